/* Lists of identifiers. */
#include <gmds/ids.h>
#include <stdlib.h>

const int gmds_link_check = GMDS_ID_BITS;

void gmds_ids_init(gmds_ids *list, gmds_memory *memory)
{
  *list = (gmds_ids){.memory = memory};
}

void gmds_ids_clear(gmds_ids *list)
{
  gmds_release(list->memory, list->data, list->capacity, sizeof *list->data);
  gmds_ids_init(list, list->memory);
}

gmds_status gmds_ids_reserve(gmds_ids *list, size_t capacity)
{
  if (capacity <= list->capacity)
    return GMDS_OK;
  size_t grown = gmds_grown(list->capacity, capacity);
  void *data = list->data;
  if (!gmds_resize(list->memory, &data, list->capacity, grown, sizeof *list->data))
    return GMDS_ERR_MEMORY;
  list->data = data;
  list->capacity = grown;
  return GMDS_OK;
}

static int by_id(const void *a, const void *b)
{
  gmds_id x = *(const gmds_id *)a, y = *(const gmds_id *)b;
  return (x > y) - (x < y);
}

/* Answers are a dozen entries long as a rule: insertion sort, the library's sort beyond. */
static void sort_ids(gmds_id *data, size_t n)
{
  if (n > 48) {
    size_t k = 1;
    while (k < n && data[k - 1] <= data[k]) /* as a traversal meets them */
      k++;
    if (k < n)
      qsort(data, n, sizeof *data, by_id);
    return;
  }
  for (size_t i = 1; i < n; i++) {
    gmds_id x = data[i];
    size_t j = i;
    for (; j > 0 && data[j - 1] > x; j--)
      data[j] = data[j - 1];
    data[j] = x;
  }
}

void gmds_ids_keep(gmds_ids *list, size_t first, size_t times, gmds_id but)
{
  size_t kept = first;
  if (list->n <= first)
    return; /* an empty list has no data to point into */
  sort_ids(list->data + first, list->n - first);
  for (size_t begin = first, end; begin < list->n; begin = end) {
    gmds_id id = list->data[begin];
    for (end = begin + 1; end < list->n && list->data[end] == id;)
      end++;
    if (end - begin >= times && id != but)
      list->data[kept++] = id;
  }
  list->n = kept;
}
