/* Numbers of MSH files, as text or as words in the order of bytes of the machine that wrote them, and tags. */
#include "gmsh.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The next word of 4 or 8 bytes. */
static gmds_status take_word(gmds_gmsh *gmsh, const char *what, size_t bytes, uint64_t *x)
{
  gmds_text *text = gmsh->text;
  const unsigned char *at = (const unsigned char *)text->at;
  if (gmds_text_left(text) < bytes)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "expected %s, found the end of the file", what);
  *x = 0;
  for (size_t k = 0; k < bytes; k++)
    *x = *x << 8 | at[gmsh->little ? bytes - 1 - k : k];
  text->at += bytes;
  return GMDS_OK;
}

gmds_status gmds_gmsh_int(gmds_gmsh *gmsh, const char *what, int *x)
{
  uint64_t word = 0;
  if (gmsh->binary) {
    GMDS_TRY(take_word(gmsh, what, 4, &word));
    *x = (int)(int32_t)(uint32_t)word;
    return GMDS_OK;
  }
  gmds_token token;
  gmds_text_next(gmsh->text, &token);
  int negative = token.n && *token.at == '-';
  if (gmds_parse_count(token.at + negative, token.n - (size_t)negative, &word) == GMDS_NUMBER_OK &&
      gmds_value_put_whole(GMDS_INT, x, negative, word))
    return GMDS_OK;
  return gmds_text_expected(gmsh->text, what, token);
}

gmds_status gmds_gmsh_size(gmds_gmsh *gmsh, const char *what, uint64_t *x)
{
  return gmsh->binary ? take_word(gmsh, what, 8, x) : gmds_text_next_whole(gmsh->text, what, x);
}

gmds_status gmds_gmsh_value(gmds_gmsh *gmsh, double *x)
{
  uint64_t word = 0;
  if (!gmsh->binary)
    return gmds_text_next_value(gmsh->text, GMDS_DOUBLE, x);
  GMDS_TRY(take_word(gmsh, "a number", 8, &word));
  memcpy(x, &word, sizeof *x);
  return GMDS_OK;
}

gmds_status gmds_gmsh_coordinate(gmds_gmsh *gmsh, size_t point, double *x)
{
  if (!gmsh->binary)
    return gmds_text_next_real(gmsh->text, point, x);
  GMDS_TRY(gmds_gmsh_value(gmsh, x));
  if (isfinite(*x))
    return GMDS_OK;
  return gmds_text_fail(gmsh->text, GMDS_ERR_COORDINATE, (long long)point,
                        "a coordinate of point %zu (from 0) is not a finite number: '%g'", point, *x);
}

gmds_status gmds_gmsh_bound(const gmds_gmsh *gmsh, uint64_t n, size_t ints, size_t sizes, size_t doubles,
                            const char *what)
{
  size_t bytes = gmsh->binary ? 4 * ints + 8 * sizes + 8 * doubles : 2 * (ints + sizes + doubles);
  return gmds_text_bound(gmsh->text, n, bytes, what);
}

gmds_status gmds_gmsh_start_words(gmds_gmsh *gmsh)
{
  if (!gmsh->binary)
    return GMDS_OK;
  GMDS_TRY(gmds_text_end_of_line(gmsh->text));
  gmds_text_skip_line(gmsh->text);
  return GMDS_OK;
}

static gmds_status store(gmds_gmsh *gmsh, gmds_tags *tags, size_t wanted)
{
  void *pairs = tags->pairs;
  if (wanted <= tags->capacity)
    return GMDS_OK;
  wanted = gmds_grown(tags->capacity, wanted);
  if (!gmds_resize(gmsh->stage->soup.memory, &pairs, tags->capacity, wanted, sizeof *tags->pairs))
    return gmds_text_failed(gmsh->text, GMDS_ERR_MEMORY);
  tags->pairs = pairs;
  tags->capacity = wanted;
  return GMDS_OK;
}

gmds_status gmds_tags_push(gmds_gmsh *gmsh, gmds_tags *tags, uint64_t tag)
{
  if (!tags->n)
    tags->first = tag;
  if (tags->pairs || tag != tags->first + tags->n) {
    int stored = tags->pairs != NULL;
    GMDS_TRY(store(gmsh, tags, tags->n + 1));
    for (size_t k = 0; !stored && k < tags->n; k++)
      tags->pairs[k] = (gmds_tag){tags->first + k, k};
    tags->pairs[tags->n] = (gmds_tag){tag, tags->n};
  }
  tags->n++;
  return GMDS_OK;
}

static int by_tag(const void *a, const void *b)
{
  const gmds_tag *x = a, *y = b;
  return x->tag != y->tag ? (x->tag > y->tag) - (x->tag < y->tag) : (x->item > y->item) - (x->item < y->item);
}

gmds_status gmds_tags_sort(gmds_gmsh *gmsh, gmds_tags *tags, size_t most, const char *what)
{
  if (!tags->pairs)
    return GMDS_OK;
  qsort(tags->pairs, tags->n, sizeof *tags->pairs, by_tag);
  for (size_t k = most; k < tags->n; k++)
    if (tags->pairs[k].tag == tags->pairs[k - most].tag)
      return gmds_text_fail(gmsh->text, GMDS_ERR_FORMAT, -1, "%zu %s have the number %llu", most + 1, what,
                            (unsigned long long)tags->pairs[k].tag);
  return GMDS_OK;
}

size_t gmds_tags_find(const gmds_tags *tags, uint64_t tag, size_t *n)
{
  if (!tags->pairs) {
    *n = tag >= tags->first && tag - tags->first < tags->n;
    return *n ? (size_t)(tag - tags->first) : 0;
  }
  size_t low = 0, high = tags->n;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (tags->pairs[middle].tag < tag)
      low = middle + 1;
    else
      high = middle;
  }
  *n = 0;
  while (low + *n < tags->n && tags->pairs[low + *n].tag == tag)
    ++*n;
  return low;
}

size_t gmds_tags_item(const gmds_tags *tags, size_t found)
{
  return tags->pairs ? tags->pairs[found].item : found;
}

void gmds_tags_clear(gmds_gmsh *gmsh, gmds_tags *tags)
{
  gmds_release(gmsh->stage->soup.memory, tags->pairs, tags->capacity, sizeof *tags->pairs);
  *tags = (gmds_tags){0};
}
