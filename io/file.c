/* Files by way of POSIX: exclusive creation and rename are what keeps a failed write from leaving anything behind. */
#define _POSIX_C_SOURCE 200809L
#include "file.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The end of a path says more than its beginning when there is no room for both. */
static const char *shown(const char *path)
{
  size_t n = strlen(path), most = 200;
  return n > most ? path + (n - most) : path;
}

/* `<path>: cannot be opened: No such file or directory` */
static gmds_status fail_errno(gmds_error *error, gmds_status status, const char *path, const char *what, int code)
{
  char reason[128];
  if (strerror_r(code, reason, sizeof reason))
    snprintf(reason, sizeof reason, "error %d", code);
  return gmds_fail(error, status, "%s: cannot be %s: %s", shown(path), what, reason);
}

/* Grows the block until the file ends; one byte more than its size shows the end without growing. */
static gmds_status read_all(FILE *file, size_t size, const char *path, gmds_error *error, gmds_bytes *bytes)
{
  for (size_t wanted = size < SIZE_MAX ? size + 1 : size;;) {
    void *data = bytes->data;
    if (!gmds_resize(bytes->memory, &data, bytes->capacity, wanted, 1))
      return gmds_fail(error, GMDS_ERR_MEMORY, "%s: out of memory for its %zu bytes or more", shown(path), wanted - 1);
    bytes->data = data;
    bytes->capacity = wanted;
    bytes->n += fread(bytes->data + bytes->n, 1, bytes->capacity - bytes->n, file);
    if (ferror(file))
      return fail_errno(error, GMDS_ERR_READ, path, "read", errno);
    if (bytes->n < bytes->capacity)
      return GMDS_OK;
    wanted = gmds_grown(bytes->capacity, bytes->capacity < SIZE_MAX ? bytes->capacity + 1 : SIZE_MAX);
  }
}

gmds_status gmds_bytes_read(const char *path, gmds_memory *memory, gmds_error *error, gmds_bytes *bytes)
{
  *bytes = (gmds_bytes){.memory = memory};
  FILE *file = fopen(path, "rb");
  if (!file)
    return fail_errno(error, GMDS_ERR_OPEN, path, "opened", errno);
  struct stat about;
  gmds_status status = GMDS_OK;
  if (fstat(fileno(file), &about))
    status = fail_errno(error, GMDS_ERR_READ, path, "read", errno);
  else if (S_ISDIR(about.st_mode))
    status = fail_errno(error, GMDS_ERR_READ, path, "read", EISDIR);
  else if (S_ISREG(about.st_mode) && (uintmax_t)about.st_size >= SIZE_MAX)
    status = fail_errno(error, GMDS_ERR_READ, path, "read", EFBIG);
  else
    status = read_all(file, S_ISREG(about.st_mode) ? (size_t)about.st_size : 0, path, error, bytes);
  fclose(file);
  if (status != GMDS_OK)
    gmds_bytes_clear(bytes);
  return status;
}

void gmds_bytes_clear(gmds_bytes *bytes)
{
  gmds_release(bytes->memory, bytes->data, bytes->capacity, 1);
  *bytes = (gmds_bytes){.memory = bytes->memory};
}

/* Opens a new file `<path>.<process>-<k>.tmp`. Returns 0, or an errno. */
static int create_beside(gmds_output *output)
{
  for (int k = 0; k < 1000; k++) {
    int n = snprintf(output->temporary, sizeof output->temporary, "%s.%ld-%d.tmp", output->path, (long)getpid(), k);
    if (n < 0 || (size_t)n >= sizeof output->temporary)
      return ENAMETOOLONG;
    int descriptor = open(output->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST)
      continue;
    if (descriptor < 0)
      return errno;
    output->file = fdopen(descriptor, "wb");
    if (output->file)
      return 0;
    int code = errno;
    close(descriptor);
    unlink(output->temporary);
    return code;
  }
  return EEXIST;
}

gmds_status gmds_output_open(gmds_output *output, const char *path, gmds_error *error)
{
  *output = (gmds_output){.path = path};
  struct stat about;
  if (!stat(path, &about) && !S_ISREG(about.st_mode)) /* a rename would put a file in the place of a device */
    return gmds_fail(error, GMDS_ERR_OPEN, "%s: cannot be written: it is there and is no regular file", shown(path));
  int code = create_beside(output);
  return code ? fail_errno(error, GMDS_ERR_OPEN, path, "written", code) : GMDS_OK;
}

gmds_status gmds_output_close(gmds_output *output, gmds_status status, gmds_error *error)
{
  errno = 0;
  int failed = fflush(output->file) || ferror(output->file);
  int code = errno;
  if (fclose(output->file) && !failed) {
    failed = 1;
    code = errno;
  }
  if (status == GMDS_OK && !failed && rename(output->temporary, output->path)) {
    failed = 1;
    code = errno;
  }
  if (status != GMDS_OK || failed)
    unlink(output->temporary);
  if (status == GMDS_OK && failed)
    return fail_errno(error, GMDS_ERR_WRITE, output->path, "written", code ? code : EIO);
  return status;
}
