/* Values of attributes: from text and from words of a file into a column, and back. */
#ifndef GMDS_VALUE_H
#define GMDS_VALUE_H

#include "number.h"
#include "text.h"
#include <gmds/cells.h>

int gmds_value_is_real(gmds_value type);
int gmds_value_is_signed(gmds_value type); /* of a whole one */

/* Puts a whole number into a column of a whole type. Returns 0, and puts nothing, when the type does not hold it. */
int gmds_value_put_whole(gmds_value type, void *at, int negative, uint64_t magnitude);

/* Puts a real number into a column of a real type: a float is rounded. */
void gmds_value_put_real(gmds_value type, void *at, double x);

/* A value of a whole type as 64 bits, its sign extended; a value of any type as a double, which may be rounded. */
uint64_t gmds_value_whole(gmds_value type, const void *at);
double gmds_value_real(gmds_value type, const void *at);

/* Whether a value is a double exactly. */
int gmds_value_is_double(gmds_value type, const void *at);

/* Writes a value and a 0 behind it so that it reads back bit for bit, but for what nan carries. Returns its length. */
size_t gmds_print_value(char text[GMDS_DOUBLE_TEXT], gmds_value type, const void *at);

/* The token, or the next token, as a value of a type. A real one may be nan or infinite. */
gmds_status gmds_text_value(const gmds_text *text, gmds_token token, gmds_value type, void *at);
gmds_status gmds_text_next_value(gmds_text *text, gmds_value type, void *at);
#endif
