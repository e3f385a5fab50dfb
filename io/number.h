/* Numbers in text, exactly: what is read is correctly rounded, what is written reads back bit for bit. Both hold under
 * the "C" numeric locale alone, which gmds_numeric_enter (numeric.h) sets for the calling thread. */
#ifndef GMDS_NUMBER_H
#define GMDS_NUMBER_H

#include <stddef.h>
#include <stdint.h>

typedef enum gmds_number {
  GMDS_NUMBER_OK,
  GMDS_NUMBER_NOT_FINITE, /* nan, inf, or beyond the largest double */
  GMDS_NUMBER_NEGATIVE,   /* a whole number below 0 where none is allowed */
  GMDS_NUMBER_TOO_LARGE,  /* a whole number beyond 64 bits */
  GMDS_NUMBER_NONE        /* not a number at all; hexadecimal is none */
} gmds_number;

/* The number that the n bytes at `text` are, all of them. */
gmds_number gmds_parse_double(const char *text, size_t n, double *x);
gmds_number gmds_parse_count(const char *text, size_t n, uint64_t *x);

enum { GMDS_DOUBLE_TEXT = 32 };

/* Writes a finite double and a 0 behind it: 15 digits where they are enough, else 17. Returns its length. */
size_t gmds_print_double(char text[GMDS_DOUBLE_TEXT], double x);
#endif
