/* Whole files into memory, and files that appear under their name only when they are complete. */
#ifndef GMDS_FILE_H
#define GMDS_FILE_H

#include <gmds/memory.h>
#include <gmds/status.h>
#include <stdio.h>

typedef struct gmds_bytes {
  gmds_memory *memory;
  char *data;
  size_t n, capacity;
} gmds_bytes;

/* Reads all of a file, a pipe too. GMDS_OK; GMDS_ERR_OPEN, _READ, _MEMORY with a sentence. */
gmds_status gmds_bytes_read(const char *path, gmds_memory *memory, gmds_error *error, gmds_bytes *bytes);
void gmds_bytes_clear(gmds_bytes *bytes);

enum { GMDS_PATH_TEXT = 4096 };

/* A file being written under another name in the same folder. */
typedef struct gmds_output {
  FILE *file;
  const char *path;
  char temporary[GMDS_PATH_TEXT];
} gmds_output;

/* GMDS_OK; GMDS_ERR_OPEN with a sentence. */
gmds_status gmds_output_open(gmds_output *output, const char *path, gmds_error *error);

/* Closes the file. With status GMDS_OK it then takes its name, if all that was written arrived; otherwise, and on
 * failure, it is removed. Returns `status`, or GMDS_ERR_WRITE with a sentence. */
gmds_status gmds_output_close(gmds_output *output, gmds_status status, gmds_error *error);
#endif
