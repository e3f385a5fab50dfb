/* Path choice by the preprocessor: for a mask the first row of the tables, in order of priority, whose relations are
 * stored. GMDS_CHOOSE(mask, list) is an integer expression that #if reads:
 *   0                            no path
 *   16 * id + inverse hops       row `id`; bit s is set when hop s is a traversal (the inverse relation is stored) */
#ifndef GMDS_MODELS_CHOICE_H
#define GMDS_MODELS_CHOICE_H

/* The rows are a table. */
/* clang-format off */

#include <gmds/models/tables.h>
#include <gmds/relations.h>

#define GMDS_ROW_(code, need) ((GMDS__MASK & (need)) == (need)) ? (code) :
#define GMDS_D_(a, b) GMDS_RELATION_BIT(a, b) /* a hop along a stored relation */
#define GMDS_I_(a, b) GMDS_RELATION_BIT(b, a) /* a hop by traversal */

/* no traversal */
#define GMDS_C0P1_(id, i, j) GMDS_ROW_(16 * id, GMDS_D_(i, j))
#define GMDS_C0P2_(id, t, i, k, j, n) GMDS_ROW_(16 * id, GMDS_D_(i, k) | GMDS_D_(k, j))
#define GMDS_C0P3_(id, t, i, k, l, j, o, n) GMDS_ROW_(16 * id, GMDS_D_(i, k) | GMDS_D_(k, l) | GMDS_D_(l, j))
#define GMDS_C0P4_(id, t, i, k, l, m, j, o, p, n)                                                                      \
  GMDS_ROW_(16 * id, GMDS_D_(i, k) | GMDS_D_(k, l) | GMDS_D_(l, m) | GMDS_D_(m, j))
/* one traversal: the last hop first, as in Listing 1 of the paper */
#define GMDS_C1P1_(id, i, j) GMDS_ROW_(16 * id + 1, GMDS_I_(i, j))
#define GMDS_C1P2_(id, t, i, k, j, n)                                                                                  \
  GMDS_ROW_(16 * id + 2, GMDS_D_(i, k) | GMDS_I_(k, j)) GMDS_ROW_(16 * id + 1, GMDS_I_(i, k) | GMDS_D_(k, j))
#define GMDS_C1P3_(id, t, i, k, l, j, o, n)                                                                            \
  GMDS_ROW_(16 * id + 4, GMDS_D_(i, k) | GMDS_D_(k, l) | GMDS_I_(l, j))                                                \
  GMDS_ROW_(16 * id + 2, GMDS_D_(i, k) | GMDS_I_(k, l) | GMDS_D_(l, j))                                                \
  GMDS_ROW_(16 * id + 1, GMDS_I_(i, k) | GMDS_D_(k, l) | GMDS_D_(l, j))
#define GMDS_C1P4_(id, t, i, k, l, m, j, o, p, n)                                                                      \
  GMDS_ROW_(16 * id + 8, GMDS_D_(i, k) | GMDS_D_(k, l) | GMDS_D_(l, m) | GMDS_I_(m, j))                                \
  GMDS_ROW_(16 * id + 4, GMDS_D_(i, k) | GMDS_D_(k, l) | GMDS_I_(l, m) | GMDS_D_(m, j))                                \
  GMDS_ROW_(16 * id + 2, GMDS_D_(i, k) | GMDS_I_(k, l) | GMDS_D_(l, m) | GMDS_D_(m, j))                                \
  GMDS_ROW_(16 * id + 1, GMDS_I_(i, k) | GMDS_D_(k, l) | GMDS_D_(l, m) | GMDS_D_(m, j))
/* two */
#define GMDS_C2P1_(id, i, j)
#define GMDS_C2P2_(id, t, i, k, j, n) GMDS_ROW_(16 * id + 3, GMDS_I_(i, k) | GMDS_I_(k, j))
#define GMDS_C2P3_(id, t, i, k, l, j, o, n)                                                                            \
  GMDS_ROW_(16 * id + 6, GMDS_D_(i, k) | GMDS_I_(k, l) | GMDS_I_(l, j))                                                \
  GMDS_ROW_(16 * id + 5, GMDS_I_(i, k) | GMDS_D_(k, l) | GMDS_I_(l, j))                                                \
  GMDS_ROW_(16 * id + 3, GMDS_I_(i, k) | GMDS_I_(k, l) | GMDS_D_(l, j))
#define GMDS_C2P4_(id, t, i, k, l, m, j, o, p, n)                                                                      \
  GMDS_ROW_(16 * id + 12, GMDS_D_(i, k) | GMDS_D_(k, l) | GMDS_I_(l, m) | GMDS_I_(m, j))                               \
  GMDS_ROW_(16 * id + 10, GMDS_D_(i, k) | GMDS_I_(k, l) | GMDS_D_(l, m) | GMDS_I_(m, j))                               \
  GMDS_ROW_(16 * id + 9, GMDS_I_(i, k) | GMDS_D_(k, l) | GMDS_D_(l, m) | GMDS_I_(m, j))                                \
  GMDS_ROW_(16 * id + 6, GMDS_D_(i, k) | GMDS_I_(k, l) | GMDS_I_(l, m) | GMDS_D_(m, j))                                \
  GMDS_ROW_(16 * id + 5, GMDS_I_(i, k) | GMDS_D_(k, l) | GMDS_I_(l, m) | GMDS_D_(m, j))                                \
  GMDS_ROW_(16 * id + 3, GMDS_I_(i, k) | GMDS_I_(k, l) | GMDS_D_(l, m) | GMDS_D_(m, j))
/* three */
#define GMDS_C3P1_(id, i, j)
#define GMDS_C3P2_(id, t, i, k, j, n)
#define GMDS_C3P3_(id, t, i, k, l, j, o, n) GMDS_ROW_(16 * id + 7, GMDS_I_(i, k) | GMDS_I_(k, l) | GMDS_I_(l, j))
#define GMDS_C3P4_(id, t, i, k, l, m, j, o, p, n)                                                                      \
  GMDS_ROW_(16 * id + 14, GMDS_D_(i, k) | GMDS_I_(k, l) | GMDS_I_(l, m) | GMDS_I_(m, j))                               \
  GMDS_ROW_(16 * id + 13, GMDS_I_(i, k) | GMDS_D_(k, l) | GMDS_I_(l, m) | GMDS_I_(m, j))                               \
  GMDS_ROW_(16 * id + 11, GMDS_I_(i, k) | GMDS_I_(k, l) | GMDS_D_(l, m) | GMDS_I_(m, j))                               \
  GMDS_ROW_(16 * id + 7, GMDS_I_(i, k) | GMDS_I_(k, l) | GMDS_I_(l, m) | GMDS_D_(m, j))
/* four */
#define GMDS_C4P1_(id, i, j)
#define GMDS_C4P2_(id, t, i, k, j, n)
#define GMDS_C4P3_(id, t, i, k, l, j, o, n)
#define GMDS_C4P4_(id, t, i, k, l, m, j, o, p, n)                                                                      \
  GMDS_ROW_(16 * id + 15, GMDS_I_(i, k) | GMDS_I_(k, l) | GMDS_I_(l, m) | GMDS_I_(m, j))

/* The choice for GMDS__MASK, an integer; i = j has no inverse of its own (F2F is its own). */
#define GMDS_CHOOSE(PATHS)                                                                                             \
  (PATHS(GMDS_C0P1_, GMDS_C0P2_, GMDS_C0P3_, GMDS_C0P4_)                                                               \
   PATHS(GMDS_C1P1_, GMDS_C1P2_, GMDS_C1P3_, GMDS_C1P4_)                                                               \
   PATHS(GMDS_C2P1_, GMDS_C2P2_, GMDS_C2P3_, GMDS_C2P4_)                                                               \
   PATHS(GMDS_C3P1_, GMDS_C3P2_, GMDS_C3P3_, GMDS_C3P4_)                                                               \
   PATHS(GMDS_C4P1_, GMDS_C4P2_, GMDS_C4P3_, GMDS_C4P4_) 0)

#endif
