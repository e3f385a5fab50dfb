/* All edges of faces: what sides that join the same two nodes make. */
#include "sides.h"
#include <gmds/edges.h>
#include <string.h>

void gmds_edge_table_init(gmds_edge_table *table, gmds_memory *memory)
{
  *table = (gmds_edge_table){.memory = memory};
}

static size_t sides_of(const gmds_edge_table *table)
{
  return table->begin ? table->begin[table->n_faces] : table->arity * table->n_faces;
}

void gmds_edge_table_clear(gmds_edge_table *table)
{
  gmds_release(table->memory, table->edges, table->edges ? sides_of(table) : 0, sizeof *table->edges);
  gmds_release(table->memory, table->begin, table->begin ? table->n_faces + 1 : 0, sizeof *table->begin);
  gmds_release(table->memory, table->nodes, table->capacity, sizeof *table->nodes);
  gmds_edge_table_init(table, table->memory);
}

/* Fills a table whose rows are known; on failure it is empty again. */
static gmds_status fill(const gmds_sides *sides, gmds_edge_table *table)
{
  void *edges = NULL;
  gmds_status status = GMDS_ERR_MEMORY;
  if (gmds_resize(table->memory, &edges, 0, sides_of(table), sizeof *table->edges)) {
    table->edges = edges;
    for (size_t f = 0; sides->alive && f < table->n_faces; f++)
      for (size_t k = 0; !gmds_bits_get(sides->alive, f) && k < table->arity; k++)
        table->edges[table->arity * f + k] = GMDS_NONE;
    status = gmds_group_sides(sides, table->memory, edges, &table->n, &table->nodes, &table->capacity);
  }
  if (status != GMDS_OK) {
    gmds_edge_table_clear(table);
    return status;
  }
  void *nodes = table->nodes;
  if (gmds_resize(table->memory, &nodes, table->capacity, 2 * table->n, sizeof *table->nodes)) {
    table->nodes = nodes;
    table->capacity = 2 * table->n;
  }
  return GMDS_OK;
}

gmds_status gmds_edges_of_inline(size_t n_nodes, size_t n_faces, size_t arity, const gmds_id *nodes,
                                 const gmds_bits *alive, gmds_edge_table *table)
{
  const gmds_sides sides = {.n_nodes = n_nodes, .n_faces = n_faces, .arity = arity, .nodes = nodes, .alive = alive};
  if (arity && n_faces >= GMDS_NONE / arity)
    return GMDS_ERR_TOO_MANY;
  table->n_faces = n_faces;
  table->arity = arity;
  return fill(&sides, table);
}

gmds_status gmds_edges_of_rows(size_t n_nodes, size_t n_faces, const size_t *begin, const gmds_id *nodes,
                               gmds_edge_table *table)
{
  const gmds_sides sides = {.n_nodes = n_nodes, .n_faces = n_faces, .begin = begin, .nodes = nodes};
  void *rows = NULL;
  if (begin[n_faces] >= GMDS_NONE)
    return GMDS_ERR_TOO_MANY;
  if (!gmds_resize(table->memory, &rows, 0, n_faces + 1, sizeof *table->begin))
    return GMDS_ERR_MEMORY;
  memcpy(rows, begin, (n_faces + 1) * sizeof *begin);
  table->n_faces = n_faces;
  table->begin = rows;
  return fill(&sides, table);
}
