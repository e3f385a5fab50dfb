/* libFuzzer: the first byte says the format and the dimension, the rest is the file. */
#include <gmds/io.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
  static const int dims[] = {0, 2, 3};
  if (!n)
    return 0;
  gmds_memory memory;
  gmds_memory_init(&memory, NULL);
  gmds_soup soup;
  gmds_soup_init(&soup, &memory, 2);
  gmds_error error;
  (void)gmds_read_soup_from_memory((gmds_format)(data[0] % GMDS_FORMAT_COUNT), "fuzz", data + 1, n - 1,
                                   dims[data[0] / GMDS_FORMAT_COUNT % 3], &error, &soup);
  gmds_soup_clear(&soup);
  if (memory.live)
    __builtin_trap();
  return 0;
}
