/* The scanner of text files. */
#include "text.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void gmds_text_init(gmds_text *text, const char *name, const void *bytes, size_t n, char comment, gmds_error *error)
{
  const char *at = n ? bytes : "";
  *text =
      (gmds_text){.name = name, .begin = at, .at = at, .end = at + n, .line = 1, .comment = comment, .error = error};
  if (n >= 3 && !memcmp(at, "\xef\xbb\xbf", 3))
    text->at += 3;
}

static int is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/* To the next byte that is neither blank nor of a comment; that may be the end of the line. */
static void skip_blanks(gmds_text *text)
{
  while (text->at < text->end && is_blank(*text->at))
    text->at++;
  if (text->at < text->end && text->comment && *text->at == text->comment) {
    const char *newline = memchr(text->at, '\n', (size_t)(text->end - text->at));
    text->at = newline ? newline : text->end;
  }
}

int gmds_text_next_on_line(gmds_text *text, gmds_token *token)
{
  skip_blanks(text);
  *token = (gmds_token){text->at, 0};
  while (text->at < text->end && *text->at != '\n' && !is_blank(*text->at) &&
         !(text->comment && *text->at == text->comment))
    text->at++;
  token->n = (size_t)(text->at - token->at);
  return token->n > 0;
}

int gmds_text_next(gmds_text *text, gmds_token *token)
{
  while (!gmds_text_next_on_line(text, token)) {
    if (text->at == text->end)
      return 0;
    text->at++;
    text->line++;
  }
  return 1;
}

void gmds_text_skip_line(gmds_text *text)
{
  const char *newline = memchr(text->at, '\n', (size_t)(text->end - text->at));
  text->at = newline ? newline + 1 : text->end;
  text->line += newline != NULL;
}

int gmds_token_is(gmds_token token, const char *word)
{
  return token.n == strlen(word) && !memcmp(token.at, word, token.n);
}

static char lower(char c)
{
  return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

int gmds_token_is_any_case(gmds_token token, const char *word)
{
  if (token.n != strlen(word))
    return 0;
  for (size_t i = 0; i < token.n; i++)
    if (lower(token.at[i]) != lower(word[i]))
      return 0;
  return 1;
}

size_t gmds_text_left(const gmds_text *text)
{
  return (size_t)(text->end - text->at);
}

/* The end of a path says more than its beginning when there is no room for both. */
static const char *shown_name(const char *name)
{
  size_t n = strlen(name), most = 200;
  return n > most ? name + (n - most) : name;
}

gmds_status gmds_text_fail(const gmds_text *text, gmds_status status, long long cell, const char *format, ...)
{
  if (!text->error)
    return status;
  char sentence[280];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(sentence, sizeof sentence, format, arguments);
  va_end(arguments);
  const char *name = shown_name(text->name);
  if (text->binary) {
    long long byte = text->at - text->begin;
    gmds_fail(text->error, status, "%s: byte %lld: %s", name, byte, sentence);
    cell = cell < 0 ? byte : cell;
  } else if (!text->line) {
    gmds_fail(text->error, status, "%s: %s", name, sentence);
  } else {
    gmds_fail(text->error, status, "%s:%lld: %s", name, text->line, sentence);
    text->error->line = text->line;
  }
  text->error->cell = cell;
  return status;
}

/* The token in quotes, cut after some 40 bytes, with nothing in it that a terminal would obey. */
static const char *shown_token(gmds_token token, char shown[64])
{
  size_t n = token.n < 40 ? token.n : 40, at = 0;
  shown[at++] = '\'';
  for (size_t i = 0; i < n; i++)
    shown[at++] = token.at[i] >= ' ' && token.at[i] <= '~' ? token.at[i] : '?';
  memcpy(shown + at, token.n > n ? "...'" : "'", token.n > n ? 5 : 2);
  return shown;
}

gmds_status gmds_text_expected(const gmds_text *text, const char *what, gmds_token found)
{
  char shown[64];
  const char *end = text->at == text->end ? "the end of the file" : *text->at == '\n' ? "the end of the line" : "','";
  return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "expected %s, found %s", what,
                        found.n ? shown_token(found, shown) : end);
}

gmds_status gmds_text_failed(const gmds_text *text, gmds_status status)
{
  return gmds_text_fail(text, status, -1, "%s", gmds_status_text(status));
}

gmds_status gmds_text_word(gmds_text *text, const char *word)
{
  gmds_token token;
  gmds_text_next(text, &token);
  return gmds_token_is_any_case(token, word) ? GMDS_OK : gmds_text_expected(text, word, token);
}

gmds_status gmds_text_whole(const gmds_text *text, gmds_token token, const char *what, uint64_t *x)
{
  char shown[64];
  switch (gmds_parse_count(token.at, token.n, x)) {
  case GMDS_NUMBER_OK:
    return GMDS_OK;
  case GMDS_NUMBER_TOO_LARGE:
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "expected %s, found %s, which is too large", what,
                          shown_token(token, shown));
  default:
    return gmds_text_expected(text, what, token);
  }
}

gmds_status gmds_text_next_whole(gmds_text *text, const char *what, uint64_t *x)
{
  gmds_token token;
  gmds_text_next(text, &token);
  return gmds_text_whole(text, token, what, x);
}

gmds_status gmds_text_bound(const gmds_text *text, uint64_t n, size_t bytes, const char *what)
{
  uint64_t left = (uint64_t)gmds_text_left(text) + !text->binary;
  if (n <= left / bytes)
    return GMDS_OK;
  return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "%llu %s are declared, but only %zu bytes remain",
                        (unsigned long long)n, what, gmds_text_left(text));
}

gmds_status gmds_text_next_count(gmds_text *text, size_t bytes, const char *what, size_t *n)
{
  char expected[64];
  uint64_t count;
  snprintf(expected, sizeof expected, "a number of %s", what);
  GMDS_TRY(gmds_text_next_whole(text, expected, &count));
  GMDS_TRY(gmds_text_bound(text, count, bytes, what));
  *n = (size_t)count;
  return GMDS_OK;
}

gmds_status gmds_text_index(const gmds_text *text, gmds_token token, uint64_t base, size_t n, gmds_id *id)
{
  uint64_t x;
  gmds_number result = gmds_parse_count(token.at, token.n, &x);
  if (result == GMDS_NUMBER_NONE)
    return gmds_text_expected(text, "an index of a point", token);
  if (result == GMDS_NUMBER_OK && x >= base && x - base < n) {
    *id = (gmds_id)(x - base);
    return GMDS_OK;
  }
  char shown[64];
  if (!n)
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "index %s, but there are no points", shown_token(token, shown));
  return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "expected an index from %llu to %llu, found %s",
                        (unsigned long long)base, (unsigned long long)(base + n - 1), shown_token(token, shown));
}

gmds_status gmds_text_next_index(gmds_text *text, uint64_t base, size_t n, gmds_id *id)
{
  gmds_token token;
  gmds_text_next(text, &token);
  return gmds_text_index(text, token, base, n, id);
}

gmds_status gmds_text_real(const gmds_text *text, gmds_token token, size_t point, double *x)
{
  gmds_number result = gmds_parse_double(token.at, token.n, x);
  if (result == GMDS_NUMBER_OK)
    return GMDS_OK;
  if (result != GMDS_NUMBER_NOT_FINITE)
    return gmds_text_expected(text, "a coordinate", token);
  char shown[64];
  return gmds_text_fail(text, GMDS_ERR_COORDINATE, (long long)point,
                        "a coordinate of point %zu (from 0) is not a finite number: %s", point,
                        shown_token(token, shown));
}

gmds_status gmds_text_next_real(gmds_text *text, size_t point, double *x)
{
  gmds_token token;
  gmds_text_next(text, &token);
  return gmds_text_real(text, token, point, x);
}

gmds_status gmds_text_end_of_line(gmds_text *text)
{
  gmds_token token;
  return gmds_text_next_on_line(text, &token) ? gmds_text_expected(text, "the end of the line", token) : GMDS_OK;
}

gmds_status gmds_text_end_of_file(gmds_text *text)
{
  gmds_token token;
  return gmds_text_next(text, &token) ? gmds_text_expected(text, "the end of the file", token) : GMDS_OK;
}

/* Cuts the token at its first comma; the scanner goes on behind it. Returns whether there was one. */
static int cut_at_comma(gmds_text *text, gmds_token *token)
{
  const char *comma = memchr(token->at, ',', token->n);
  if (!comma)
    return 0;
  token->n = (size_t)(comma - token->at);
  text->at = comma + 1;
  return 1;
}

/* Whether the next byte of the line that is not blank is a comma, which is passed. */
static int pass_comma(gmds_text *text)
{
  skip_blanks(text);
  int comma = text->at < text->end && *text->at == ',';
  text->at += comma;
  return comma;
}

gmds_status gmds_text_point_line(gmds_text *text, size_t point, int most, int comma, double x[3], int *n)
{
  int pending = 0; /* a comma that promises another number */
  x[2] = 0;
  for (*n = 0;; ++*n) {
    gmds_token token;
    if (!gmds_text_next_on_line(text, &token) && !pending)
      break;
    if (*n == most)
      return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)point, "expected %d coordinates, found more", most);
    pending = comma && (cut_at_comma(text, &token) || pass_comma(text));
    GMDS_TRY(gmds_text_real(text, token, point, &x[*n]));
  }
  if (*n >= 2)
    return GMDS_OK;
  return gmds_text_fail(text, GMDS_ERR_FORMAT, (long long)point, "expected %s coordinates, found %d",
                        most == 2 ? "2" : "2 or 3", *n);
}
