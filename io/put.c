/* What writers share: points, corners, values and words put into a file. */
#include "number.h"
#include "value.h"
#include "writers.h"
#include <inttypes.h>
#include <limits.h>
#include <string.h>

double gmds_coordinate(const gmds_soup *soup, size_t point, int k)
{
  return k < soup->dim ? soup->points[point * (size_t)soup->dim + (size_t)k] : 0;
}

void gmds_put_point(FILE *file, const gmds_soup *soup, size_t point, int dim)
{
  for (int k = 0; k < dim; k++) {
    char text[GMDS_DOUBLE_TEXT];
    size_t n = gmds_print_double(text, gmds_coordinate(soup, point, k));
    if (k)
      putc(' ', file);
    fwrite(text, 1, n, file);
  }
}

void gmds_put_corners(FILE *file, const gmds_soup *soup, size_t cell, unsigned base)
{
  for (size_t k = soup->begin[cell]; k < soup->begin[cell + 1]; k++)
    fprintf(file, " %" PRIu64, (uint64_t)soup->corners[k] + base);
}

void gmds_put_row(FILE *file, const gmds_attribute *attribute, size_t row)
{
  size_t bytes = gmds_value_bytes(attribute->type);
  const char *at = (const char *)attribute->data + row * attribute->bytes;
  for (size_t k = 0; k < attribute->components; k++) {
    char text[GMDS_DOUBLE_TEXT];
    size_t n = gmds_print_value(text, attribute->type, at + k * bytes);
    if (k)
      putc(' ', file);
    fwrite(text, 1, n, file);
  }
}

void gmds_put_word(FILE *file, uint64_t x, int bytes, int little)
{
  unsigned char word[8];
  for (int k = 0; k < bytes; k++)
    word[little ? k : bytes - 1 - k] = (unsigned char)(x >> 8 * k);
  fwrite(word, 1, (size_t)bytes, file);
}

void gmds_put_double(FILE *file, double x, int little)
{
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  gmds_put_word(file, bits, 8, little);
}

uint64_t gmds_value_word(const gmds_attribute *attribute, size_t k)
{
  const char *at = (const char *)attribute->data + k * gmds_value_bytes(attribute->type);
  uint64_t word;
  uint32_t half;
  if (attribute->type == GMDS_DOUBLE) {
    memcpy(&word, at, sizeof word);
    return word;
  }
  if (attribute->type == GMDS_FLOAT) {
    memcpy(&half, at, sizeof half);
    return half;
  }
  return gmds_value_whole(attribute->type, at);
}

int gmds_is_reference(const gmds_soup *soup, gmds_place place, const gmds_attribute *attribute)
{
  if (attribute->components != 1 || gmds_value_is_real(attribute->type))
    return 0;
  for (size_t i = 0; attribute->type != GMDS_INT && i < gmds_rows_of(soup, place); i++) {
    uint64_t x = gmds_value_whole(attribute->type, (const char *)attribute->data + i * attribute->bytes);
    if (gmds_value_is_signed(attribute->type) ? (int64_t)x < INT_MIN || (int64_t)x > INT_MAX : x > INT_MAX)
      return 0;
  }
  return 1;
}

int gmds_reference(const gmds_attribute *attribute, size_t item)
{
  return attribute ? (int)gmds_value_whole(attribute->type, (const char *)attribute->data + item * attribute->bytes)
                   : 0;
}
