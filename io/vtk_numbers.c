/* Blocks of numbers in VTK's legacy format, as text or as big-endian words. */
#include "vtk.h"
#include <math.h>
#include <string.h>

gmds_status gmds_vtk_next_type(gmds_vtk *vtk, gmds_vtk_type *type)
{
#define ROW(name, kind, bytes) {name, kind, bytes},
  static const gmds_vtk_type rows[] = {GMDS_VTK_TYPE_LIST(ROW)};
#undef ROW
  gmds_token token;
  gmds_text_next_on_line(vtk->text, &token);
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (gmds_token_is_any_case(token, rows[i].name)) {
      *type = rows[i];
      return GMDS_OK;
    }
  return gmds_text_expected(vtk->text, "a type of numbers", token);
}

gmds_status gmds_vtk_start(gmds_vtk *vtk, gmds_vtk_type type, uint64_t n, const char *what, gmds_vtk_block *block)
{
  gmds_text *text = vtk->text;
  if (vtk->binary) {
    GMDS_TRY(gmds_text_end_of_line(text));
    gmds_text_skip_line(text);
    text->binary = 1;
  }
  GMDS_TRY(gmds_text_bound(text, n, vtk->binary ? (size_t)type.bytes : 2, what));
  *block = (gmds_vtk_block){*text, vtk->binary, type, (size_t)n, 0};
  return GMDS_OK;
}

/* Bits are packed; text encodes them as numbers. */
static gmds_status skip_bits(gmds_vtk *vtk, uint64_t n, const char *what)
{
  uint64_t bytes = n / 8 + (n % 8 != 0);
  gmds_vtk_block block;
  GMDS_TRY(gmds_vtk_start(vtk, (gmds_vtk_type){"bit", GMDS_VTK_BIT, 1}, bytes, what, &block));
  vtk->text->at += bytes;
  return GMDS_OK;
}

/* A string has its length before it, the two highest bits of which say how many bytes hold it: 8, 4, 2 or 1. */
static gmds_status skip_binary_string(gmds_text *text)
{
  if (!gmds_text_left(text))
    return gmds_text_expected(text, "a string", (gmds_token){text->at, 0});
  unsigned first = (unsigned char)*text->at;
  size_t width = (size_t)8 >> (first >> 6);
  uint64_t length = first & 0x3f;
  GMDS_TRY(gmds_text_bound(text, width, 1, "bytes of a string's length"));
  for (size_t k = 1; k < width; k++)
    length = length << 8 | (unsigned char)text->at[k];
  text->at += width;
  GMDS_TRY(gmds_text_bound(text, length, 1, "bytes of a string"));
  text->at += length;
  return GMDS_OK;
}

/* As text, each has a line of its own, which may be empty. */
static gmds_status skip_strings(gmds_vtk *vtk, uint64_t n, const char *what)
{
  gmds_text *text = vtk->text;
  GMDS_TRY(gmds_text_end_of_line(text));
  gmds_text_skip_line(text);
  text->binary = vtk->binary;
  GMDS_TRY(gmds_text_bound(text, n, 1, what));
  for (uint64_t k = 0; k < n; k++) {
    if (vtk->binary)
      GMDS_TRY(skip_binary_string(text));
    else
      gmds_text_skip_line(text);
  }
  return GMDS_OK;
}

gmds_status gmds_vtk_pass(gmds_vtk *vtk, const gmds_vtk_block *block)
{
  gmds_text *text = vtk->text;
  if (block->binary) {
    text->at += block->left * (size_t)block->type.bytes;
    return GMDS_OK;
  }
  for (size_t k = 0; k < block->left; k++) {
    gmds_token token;
    double ignored;
    gmds_text_next(text, &token);
    if (gmds_parse_double(token.at, token.n, &ignored) == GMDS_NUMBER_NONE)
      return gmds_text_expected(text, "a number", token);
  }
  return GMDS_OK;
}

gmds_status gmds_vtk_skip(gmds_vtk *vtk, gmds_vtk_type type, uint64_t n, const char *what)
{
  gmds_vtk_block block;
  if (type.kind == GMDS_VTK_STRING)
    return skip_strings(vtk, n, what);
  if (type.kind == GMDS_VTK_BIT && vtk->binary)
    return skip_bits(vtk, n, what);
  GMDS_TRY(gmds_vtk_start(vtk, type, n, what, &block));
  return gmds_vtk_pass(vtk, &block);
}

/* A sentence names the byte where the word at fault begins. */
static const gmds_text *at_last_word(gmds_vtk_block *block)
{
  block->text.at -= block->type.bytes;
  return &block->text;
}

/* The next word of the block, its sign extended; there is one, as the block was bounded. */
static uint64_t next_word(gmds_vtk_block *block)
{
  int bytes = block->type.bytes;
  const unsigned char *at = (const unsigned char *)block->text.at;
  uint64_t x = 0;
  for (int k = 0; k < bytes; k++)
    x = x << 8 | at[block->little ? bytes - 1 - k : k];
  block->text.at += bytes;
  uint64_t sign = (uint64_t)1 << (8 * bytes - 1);
  return block->type.kind == GMDS_VTK_SIGNED ? (x ^ sign) - sign : x;
}

static gmds_status take(gmds_vtk_block *block, const char *what)
{
  if (!block->left)
    return gmds_text_fail(&block->text, GMDS_ERR_FORMAT, -1, "expected %s, but the declared numbers are used up", what);
  block->left--;
  return GMDS_OK;
}

gmds_status gmds_vtk_whole(gmds_vtk_block *block, const char *what, uint64_t *x)
{
  GMDS_TRY(take(block, what));
  if (!block->binary)
    return gmds_text_next_whole(&block->text, what, x);
  uint64_t word = next_word(block);
  if (block->type.kind == GMDS_VTK_SIGNED && word >> 63)
    return gmds_text_fail(at_last_word(block), GMDS_ERR_FORMAT, -1, "expected %s, found -%llu", what,
                          (unsigned long long)(0 - word));
  *x = word;
  return GMDS_OK;
}

gmds_status gmds_vtk_index(gmds_vtk_block *block, size_t n, gmds_id *id)
{
  if (!block->binary) {
    GMDS_TRY(take(block, "an index of a point"));
    return gmds_text_next_index(&block->text, 0, n, id);
  }
  uint64_t x = 0;
  GMDS_TRY(gmds_vtk_whole(block, "an index of a point", &x));
  if (x >= n)
    return gmds_text_fail(at_last_word(block), GMDS_ERR_FORMAT, -1, "expected an index below %zu, found %llu", n,
                          (unsigned long long)x);
  *id = (gmds_id)x;
  return GMDS_OK;
}

static double next_real(gmds_vtk_block *block)
{
  int is_signed = block->type.kind == GMDS_VTK_SIGNED;
  uint64_t word = next_word(block);
  if (block->type.kind != GMDS_VTK_REAL)
    return is_signed && word >> 63 ? -(double)(0 - word) : (double)word;
  if (block->type.bytes == 4) {
    uint32_t bits = (uint32_t)word;
    float x;
    memcpy(&x, &bits, sizeof x);
    return (double)x;
  }
  double x;
  memcpy(&x, &word, sizeof x);
  return x;
}

gmds_value gmds_vtk_value_type(gmds_vtk_type type)
{
  switch (type.kind) {
  case GMDS_VTK_REAL:
    return type.bytes == 4 ? GMDS_FLOAT : GMDS_DOUBLE;
  case GMDS_VTK_SIGNED: /* vtkIdType has 8 bytes in a program, 4 in a BINARY file, and any number as text */
    return type.bytes == 8 || strcmp(type.name, "vtkidtype") == 0 ? GMDS_LONG : GMDS_INT;
  case GMDS_VTK_UNSIGNED:
    if (type.bytes == (int)sizeof(gmds_id))
      return GMDS_ID;
    return type.bytes == 1 ? GMDS_BYTE : type.bytes == 2 ? GMDS_INT : GMDS_LONG;
  default:
    return GMDS_BYTE;
  }
}

gmds_status gmds_vtk_value(gmds_vtk_block *block, gmds_value type, void *at)
{
  GMDS_TRY(take(block, "a number"));
  if (!block->binary)
    return gmds_text_next_value(&block->text, type, at);
  if (block->type.kind == GMDS_VTK_REAL) {
    gmds_value_put_real(type, at, next_real(block));
    return GMDS_OK;
  }
  uint64_t word = next_word(block);
  int negative = block->type.kind == GMDS_VTK_SIGNED && word >> 63;
  if (gmds_value_put_whole(type, at, negative, negative ? 0 - word : word))
    return GMDS_OK;
  return gmds_text_fail(at_last_word(block), GMDS_ERR_UNSUPPORTED, -1, "the number %s%llu is too large for %s values",
                        negative ? "-" : "", (unsigned long long)(negative ? 0 - word : word), gmds_value_text(type));
}

gmds_status gmds_vtk_real(gmds_vtk_block *block, size_t point, double *x)
{
  GMDS_TRY(take(block, "a coordinate"));
  if (!block->binary)
    return gmds_text_next_real(&block->text, point, x);
  *x = next_real(block);
  if (isfinite(*x))
    return GMDS_OK;
  return gmds_text_fail(at_last_word(block), GMDS_ERR_COORDINATE, (long long)point,
                        "a coordinate of point %zu (from 0) is not a finite number: '%g'", point, *x);
}
