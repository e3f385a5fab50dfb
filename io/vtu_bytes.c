/* The numbers of an array of VTU: text, or words behind their length, raw or in base64, compressed in blocks or not. A
 * length is held against the bytes that remain, and what a block says it unpacks to against what so many bytes can. */
#include "vtu.h"
#include <string.h>
#if GMDS_HAVE_ZLIB
#  include <zlib.h>
#endif

/* Bytes that come one after the other. Base64 may end in padding and begin again: a length is encoded by itself by
 * some programs, together with what follows by others. */
typedef struct source {
  const char *at, *end;
  int base64;
  unsigned char held[3];
  int n_held, next;
} source;

static int digit(char c)
{
  if (c >= 'A' && c <= 'Z')
    return c - 'A';
  if (c >= 'a' && c <= 'z')
    return c - 'a' + 26;
  if (c >= '0' && c <= '9')
    return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/* Decodes four characters, blanks between them passed. Returns 0 where they are none of base64. */
static int decode_group(source *s)
{
  unsigned bits = 0;
  int digits = 0, seen = 0;
  while (seen < 4 && s->at < s->end) {
    char c = *s->at++;
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
      continue;
    int d = digit(c);
    if (c == '=' ? digits < 2 : d < 0 || digits < seen)
      return 0;
    bits = bits << 6 | (unsigned)(c == '=' ? 0 : d);
    digits += c != '=';
    seen++;
  }
  for (int k = 0; k < 3; k++)
    s->held[k] = (unsigned char)(bits >> (16 - 8 * k));
  s->n_held = digits - 1;
  s->next = 0;
  return seen == 4;
}

/* The next n bytes. Returns 0 where the file has not so many. */
static int take(source *s, void *bytes, size_t n)
{
  unsigned char *to = bytes;
  if (!n)
    return 1;
  if (!s->base64) {
    if (n > (size_t)(s->end - s->at))
      return 0;
    memcpy(to, s->at, n);
    s->at += n;
    return 1;
  }
  for (size_t k = 0; k < n; k++) {
    if (s->next == s->n_held && !decode_group(s))
      return 0;
    to[k] = s->held[s->next++];
  }
  return 1;
}

/* At most so many bytes can still come. */
static uint64_t left(const source *s)
{
  return (uint64_t)(s->end - s->at) + 3;
}

static int take_header(const gmds_vtu *vtu, source *s, uint64_t *x)
{
  unsigned char bytes[8];
  if (!take(s, bytes, vtu->header_bytes))
    return 0;
  *x = 0;
  for (size_t k = 0; k < vtu->header_bytes; k++)
    *x = *x << 8 | bytes[vtu->little ? vtu->header_bytes - 1 - k : k];
  return 1;
}

static gmds_status fail_short(const gmds_text *text)
{
  return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "the array ends before its numbers do, or is not base64");
}

/* Makes room for n more bytes. */
static gmds_status extend(const gmds_text *text, gmds_bytes *bytes, size_t n)
{
  void *data = bytes->data;
  if (n > SIZE_MAX - bytes->capacity || !gmds_resize(bytes->memory, &data, bytes->capacity, bytes->capacity + n, 1))
    return gmds_text_failed(text, GMDS_ERR_MEMORY);
  bytes->data = data;
  bytes->capacity += n;
  return GMDS_OK;
}

#if GMDS_HAVE_ZLIB
/* Unpacks a block of `packed` bytes that stands for n. */
static gmds_status unpack_block(const gmds_text *text, source *s, uint64_t packed, uint64_t n, gmds_bytes *bytes)
{
  if (packed > left(s) || n / 1040 > packed) /* a byte of zlib's unpacks to 1032 at most */
    return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "a block of %llu bytes that would be %llu unpacked",
                          (unsigned long long)packed, (unsigned long long)n);
  gmds_bytes block = {.memory = bytes->memory};
  gmds_status status = extend(text, &block, (size_t)packed);
  uLongf made = (uLongf)n;
  if (status == GMDS_OK)
    status = extend(text, bytes, (size_t)n);
  if (status == GMDS_OK && !take(s, block.data, (size_t)packed))
    status = fail_short(text);
  if (status == GMDS_OK && n) {
    int result = uncompress((Bytef *)bytes->data + bytes->n, &made, (const Bytef *)block.data, (uLong)packed);
    if (result == Z_MEM_ERROR)
      status = gmds_text_failed(text, GMDS_ERR_MEMORY);
    else if (result != Z_OK || made != n)
      status = gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "a compressed block is not what its length says");
  }
  bytes->n += (size_t)n;
  gmds_bytes_clear(&block);
  return status;
}

/* The number of blocks, their size unpacked, that of the last one if it is another, and the size of each packed. */
static gmds_status unpack(gmds_vtu *vtu, const gmds_text *text, source *s, gmds_bytes *bytes)
{
  uint64_t n = 0, size = 0, last = 0;
  if (!take_header(vtu, s, &n))
    return fail_short(text);
  if (!n)
    return GMDS_OK;
  if (!take_header(vtu, s, &size) || !take_header(vtu, s, &last) || n > left(s) / vtu->header_bytes)
    return fail_short(text);
  source sizes = *s;
  uint64_t packed = 0;
  for (uint64_t k = 0; k < n; k++)
    if (!take_header(vtu, s, &packed))
      return fail_short(text);
  s->next = s->n_held; /* blocks are encoded apart from their header */
  for (uint64_t k = 0; k < n; k++) {
    take_header(vtu, &sizes, &packed);
    GMDS_TRY(unpack_block(text, s, packed, k + 1 == n && last ? last : size, bytes));
  }
  return GMDS_OK;
}
#else
static gmds_status unpack(gmds_vtu *vtu, const gmds_text *text, source *s, gmds_bytes *bytes)
{
  (void)vtu, (void)s, (void)bytes;
  return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1,
                        "this library was built without zlib, which compressed arrays need");
}
#endif /* GMDS_HAVE_ZLIB */

static gmds_status read_bytes(gmds_vtu *vtu, const gmds_vtu_array *array, const gmds_text *text, gmds_bytes *bytes)
{
  source s = {.at = array->begin, .end = array->end, .base64 = 1};
  uint64_t n = 0;
  if (array->format == GMDS_VTU_APPENDED) {
    if (!vtu->appended || array->offset > (uint64_t)(vtu->appended_end - vtu->appended))
      return gmds_text_fail(text, GMDS_ERR_FORMAT, -1, "the array is appended at %llu, where there is nothing",
                            (unsigned long long)array->offset);
    s = (source){.at = vtu->appended + array->offset, .end = vtu->appended_end, .base64 = vtu->appended_base64};
  }
  if (vtu->compressed)
    return unpack(vtu, text, &s, bytes);
  if (!take_header(vtu, &s, &n) || n > left(&s))
    return fail_short(text);
  GMDS_TRY(extend(text, bytes, (size_t)n));
  bytes->n = (size_t)n;
  return take(&s, bytes->data, (size_t)n) ? GMDS_OK : fail_short(text);
}

gmds_text gmds_vtu_text(const gmds_vtu *vtu, const gmds_vtu_array *array)
{
  gmds_text text = *vtu->text;
  text.at = array->begin;
  text.end = array->end;
  text.line = array->line;
  return text;
}

gmds_status gmds_vtu_open(gmds_vtu *vtu, const gmds_vtu_array *array, uint64_t n, gmds_bytes *bytes,
                          gmds_vtk_block *block)
{
  gmds_text text = gmds_vtu_text(vtu, array);
  *bytes = (gmds_bytes){.memory = vtu->stage->soup.memory};
  if (array->format == GMDS_VTU_ASCII) {
    GMDS_TRY(gmds_text_bound(&text, n, 2, "numbers"));
    *block = (gmds_vtk_block){text, 0, array->type, (size_t)n, 0};
    return GMDS_OK;
  }
  gmds_status status = read_bytes(vtu, array, &text, bytes);
  uint64_t found = bytes->n / (size_t)array->type.bytes;
  if (status == GMDS_OK && (found != n || bytes->n % (size_t)array->type.bytes))
    status = gmds_text_fail(&text, GMDS_ERR_FORMAT, -1, "expected %llu numbers of %d bytes, found %zu bytes",
                            (unsigned long long)n, array->type.bytes, bytes->n);
  if (status != GMDS_OK) {
    gmds_bytes_clear(bytes);
    return status;
  }
  text.begin = text.at = bytes->data ? bytes->data : "";
  text.end = text.at + bytes->n;
  *block = (gmds_vtk_block){text, 1, array->type, (size_t)n, vtu->little};
  return GMDS_OK;
}

gmds_status gmds_vtu_close(gmds_vtk_block *block)
{
  gmds_token token;
  if (!block->binary && gmds_text_next(&block->text, &token))
    return gmds_text_expected(&block->text, "the end of the array", token);
  return GMDS_OK;
}
