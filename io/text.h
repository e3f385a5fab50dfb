/* The scanner that every reader of text shares: a file in memory as tokens with line numbers, and the sentences that
 * say what was expected there and what was found. Nothing is copied and no line is too long. */
#ifndef GMDS_TEXT_H
#define GMDS_TEXT_H

#include "number.h"
#include <gmds/ids.h>

typedef struct gmds_text {
  const char *name; /* of the file, for sentences */
  const char *begin, *at, *end;
  long long line; /* of `at`, from 1; 0: sentences name the file alone */
  int binary;     /* lines mean nothing any more: sentences name the byte */
  char comment;   /* runs from here to the end of its line; 0: there is none */
  gmds_error *error;
} gmds_text;

typedef struct gmds_token {
  const char *at;
  size_t n;
} gmds_token;

/* A byte-order mark at the beginning is skipped. */
void gmds_text_init(gmds_text *text, const char *name, const void *bytes, size_t n, char comment, gmds_error *error);

/* The next token, on any line or before the line ends: 0 when there is none (token->n is 0 then). */
int gmds_text_next(gmds_text *text, gmds_token *token);
int gmds_text_next_on_line(gmds_text *text, gmds_token *token);

/* Goes behind the end of the line, whatever stands there. */
void gmds_text_skip_line(gmds_text *text);

int gmds_token_is(gmds_token token, const char *word); /* in this case */
int gmds_token_is_any_case(gmds_token token, const char *word);
size_t gmds_text_left(const gmds_text *text); /* bytes */

/* Fails with `<file>:<line>: <sentence>`; `cell` (point, cell; -1: none) goes to the error object. */
#if defined __GNUC__
__attribute__((format(printf, 4, 5)))
#endif
gmds_status
gmds_text_fail(const gmds_text *text, gmds_status status, long long cell, const char *format, ...);

/* Fails with `expected <what>, found <token>`; an empty token is the end of the line or of the file. */
gmds_status gmds_text_expected(const gmds_text *text, const char *what, gmds_token found);

/* Status and sentence of a failed allocation, and of a failed call on a soup. */
gmds_status gmds_text_failed(const gmds_text *text, gmds_status status);

/* The next token must be this word. */
gmds_status gmds_text_word(gmds_text *text, const char *word);

/* A whole number from 0: what the token or the next token is. `what` names it: "a number of points". */
gmds_status gmds_text_whole(const gmds_text *text, gmds_token token, const char *what, uint64_t *x);
gmds_status gmds_text_next_whole(gmds_text *text, const char *what, uint64_t *x);

/* Holds a declared count against what remains: `n` times `bytes` must fit in the bytes left (the last one may lack the
 * byte that parts it from a next). `what` in the plural: "points". */
gmds_status gmds_text_bound(const gmds_text *text, uint64_t n, size_t bytes, const char *what);
gmds_status gmds_text_next_count(gmds_text *text, size_t bytes, const char *what, size_t *n);

/* The token, or the next token, as an index from `base` of one of n points. */
gmds_status gmds_text_index(const gmds_text *text, gmds_token token, uint64_t base, size_t n, gmds_id *id);
gmds_status gmds_text_next_index(gmds_text *text, uint64_t base, size_t n, gmds_id *id);

/* The token, or the next token, as a coordinate of a point. */
gmds_status gmds_text_real(const gmds_text *text, gmds_token token, size_t point, double *x);
gmds_status gmds_text_next_real(gmds_text *text, size_t point, double *x);

/* Nothing more on this line, or in this file. */
gmds_status gmds_text_end_of_line(gmds_text *text);
gmds_status gmds_text_end_of_file(gmds_text *text);

/* As many numbers as the line holds, at most `most` (2 or 3), the third being 0 where it is missing. `comma`: one comma
 * may stand between two of them. */
gmds_status gmds_text_point_line(gmds_text *text, size_t point, int most, int comma, double x[3], int *n);
#endif
