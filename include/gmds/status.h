/* Status codes and the error object.
 *
 * Every call that can fail returns a gmds_status and gives its results through its last pointers, which are untouched
 * on failure. A caller who wants the sentence behind a status passes a gmds_error; every parameter of that type may be
 * NULL. The library never prints, exits or aborts. */
#ifndef GMDS_STATUS_H
#define GMDS_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

/* X(name, what it means). GMDS_ERR_CONFLICT says that something stands in the way: a third face at a side (F2F), a
 * third region on a face (R2R), a face with the same nodes in another order, cells on one that is to be removed, an
 * attribute of the same name. */
#define GMDS_STATUS_LIST(X)                                                  \
  X(GMDS_OK, "done")                                                         \
  X(GMDS_ERR_ARGUMENT, "an argument is not of the form that the call takes") \
  X(GMDS_ERR_MEMORY, "out of memory")                                        \
  X(GMDS_ERR_TOO_MANY, "more cells than the index type holds")               \
  X(GMDS_ERR_CELL, "no such cell")                                           \
  X(GMDS_ERR_CONFLICT, "what is there already does not allow it")            \
  X(GMDS_ERR_COORDINATE, "a coordinate is not a finite number")              \
  X(GMDS_ERR_CANCELLED, "cancelled by the caller")                           \
  X(GMDS_ERR_OPEN, "a file cannot be opened")                                \
  X(GMDS_ERR_READ, "a file cannot be read")                                  \
  X(GMDS_ERR_WRITE, "a file cannot be written")                              \
  X(GMDS_ERR_FORMAT, "a file is not of its format")                          \
  X(GMDS_ERR_UNSUPPORTED, "not supported by this model or format")           \
  X(GMDS_ERR_INVARIANT, "stored relations contradict each other")            \
  X(GMDS_ERR_PLATFORM, "the floating-point arithmetic of this build is not IEEE 754 double")

#define GMDS_STATUS_ENUM_(name, text) name,
typedef enum gmds_status { GMDS_STATUS_LIST(GMDS_STATUS_ENUM_) GMDS_STATUS_COUNT } gmds_status;
#undef GMDS_STATUS_ENUM_

/* The sentence behind a failure. `text` is complete by itself: it names the file and the line, or the cell.
 * Zero-initialise it, or let the first failing call fill it. */
typedef struct gmds_error {
  gmds_status status;
  long long line; /* line of a text file, from 1; 0 where there is none */
  long long cell; /* the cell, point or byte that the text names; -1 where there is none */
  char text[512];
} gmds_error;

/* The meaning of a status in a few words, never NULL. */
const char *gmds_status_text(gmds_status status);

/* Fills `error` (may be NULL) with the status and a formatted sentence, cut at its end if too long; returns `status`,
 * so that a failing function ends in `return gmds_fail(error, GMDS_ERR_..., "...")`. */
#if defined __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
gmds_status
gmds_fail(gmds_error *error, gmds_status status, const char *format, ...);

/* Returns from the calling function with the status of `call` unless that is GMDS_OK. */
#define GMDS_TRY(call)              \
  do {                              \
    gmds_status gmds_try_ = (call); \
    if (gmds_try_ != GMDS_OK)       \
      return gmds_try_;             \
  } while (0)

#ifdef __cplusplus
}
#endif
#endif
