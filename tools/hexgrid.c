/* gmds bench hexgrid: a grid of hexahedra as a 3-map that keeps nodes alone, made one by one from coordinates and sewn
 * by matching faces; nothing of the grid is known to either. */
#include "command.h"
#define GMDS_PREFIX hex
#define GMDS_BACKEND GMDS_CMAP
#define GMDS_DIM 3
#define GMDS_MODEL N
#include <gmds/mesh.h>
#include <gmds/end.h>

/* N x N x N unit cubes. */
static gmds_status make_cubes(hex_mesh *m, size_t n)
{
  for (size_t c = 0; c < n * n * n; c++) {
    const double at[3] = {(double)(c % n), (double)(c / n % n), (double)(c / n / n)};
    double x[24];
    gmds_id d = GMDS_NONE;
    for (int v = 0; v < 8; v++) {
      x[3 * v] = at[0] + (v == 1 || v == 2 || v == 5 || v == 6);
      x[3 * v + 1] = at[1] + (v == 2 || v == 3 || v == 6 || v == 7);
      x[3 * v + 2] = at[2] + (v > 3);
    }
    GMDS_TRY(hex_make_hexahedron(m, x, &d));
  }
  return GMDS_OK;
}

/* The map as it is left: sewn, without holes, trimmed. */
static gmds_status build(hex_mesh *m, size_t n, double *seconds, size_t *sewn)
{
  const double begin = now();
  GMDS_TRY(make_cubes(m, n));
  GMDS_TRY(hex_match_points(m, sewn));
  GMDS_TRY(hex_compact(m, NULL));
  GMDS_TRY(hex_trim(m));
  *seconds = now() - begin;
  return GMDS_OK;
}

int bench_hexgrid(const verb *v, const char *size, int json)
{
  unsigned long number = 0;
  if (!size)
    return misused(v, "hexgrid needs --n N");
  if (!read_number(size, 1, 500, &number))
    return misused(v, "--n is a number from 1 to 500 for a hexgrid, not '%s'", size);
  const size_t n = number, hexes = n * n * n;
  double seconds = 0;
  size_t sewn = 0;
  hex_mesh m;
  hex_mesh_init(&m, NULL);
  const gmds_status status = build(&m, n, &seconds, &sewn);
  const size_t bytes = hex_mesh_memory(&m)->live, darts = hex_count_darts(&m), nodes = hex_count_0(&m);
  hex_mesh_clear(&m);
  if (status != GMDS_OK)
    return failed("a grid of %zu hexahedra: %s", hexes, gmds_status_text(status));
  if (sewn != 3 * n * n * (n - 1) || nodes != (n + 1) * (n + 1) * (n + 1) || darts != 24 * hexes)
    return failed("a grid of %zu hexahedra: it is not one", hexes);
  const double bytes_per_hex = (double)bytes / (double)hexes;
  if (json)
    printf("{\"hexes\":%zu,\"darts\":%zu,\"seconds\":%.6f,\"bytes_per_hex\":%.2f}\n", hexes, darts, seconds,
           bytes_per_hex);
  else
    printf("%zu hexahedra, %zu darts, %zu nodes, %zu faces sewn\n%.6f seconds, %.3f microseconds a hexahedron, %.1f "
           "bytes\n",
           hexes, darts, nodes, sewn, seconds, 1e6 * seconds / (double)hexes, bytes_per_hex);
  return DONE;
}
