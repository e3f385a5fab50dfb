/* A mesh of volumes without its model. */
#include <gmds/volume.h>
#include <string.h>

void gmds_volume_init(gmds_volume *volume, gmds_memory *memory)
{
  memset(volume, 0, sizeof *volume);
  volume->memory = memory;
  for (int i = 0; i < 4; i++)
    gmds_cells_init(&volume->cells[i], memory, GMDS_NONE);
  gmds_complex_init(&volume->complex, memory, 0);
}

void gmds_volume_clear(gmds_volume *volume)
{
  gmds_complex_clear(&volume->complex);
  gmds_release(volume->memory, volume->points, volume->points ? volume->cells[0].capacity : 0, 3 * sizeof(double));
  for (int i = 0; i < 4; i++)
    gmds_cells_clear(&volume->cells[i]);
  gmds_volume_init(volume, volume->memory);
}

gmds_status gmds_cells_copy(const gmds_cells *from, gmds_cells *to)
{
  GMDS_TRY(gmds_cells_resize(to, from->end));
  (void)gmds_cells_take_many(to, from->end);
  for (size_t c = from->end; c-- > 0;)
    if (!gmds_bits_get(&from->alive, c))
      gmds_cells_drop(to, (gmds_id)c);
  for (const gmds_attribute *a = from->attributes; a; a = a->next) {
    gmds_attribute *b = NULL;
    GMDS_TRY(gmds_attribute_add(to, a->name, a->type, a->components, &b));
    if (from->end)
      memcpy(b->data, a->data, from->end * a->bytes);
  }
  return GMDS_OK;
}
