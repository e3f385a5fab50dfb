// The checksum (gmds/checksum.h) of CGAL's Delaunay triangulation in space, of its tetrahedra, or of its triangles where
// all points lie in one plane; what every model's must be equal to:
//     oracle_delaunay3 SPEC [--cells FILE]
// SPEC is read by gmds' own io, so that both see the same points; prints 16 hexadecimal digits. --cells writes the
// cells, one a line: the coordinates of their points in %a, points sorted, lines not.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <gmds/io.h>
#include <initializer_list>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel> Triangulation;
typedef std::vector<std::array<double, 3>> Cell;

static uint64_t mix64(uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

static uint64_t hash(const Cell &c)
{
  uint64_t h = 0;
  for (const auto &p : c)
    for (double x : p) {
      uint64_t w;
      std::memcpy(&w, &x, sizeof w);
      h = mix64((h ^ w) + 0x9e3779b97f4a7c15u);
    }
  return h;
}

static void add(std::vector<Cell> &cells, std::initializer_list<Triangulation::Vertex_handle> vertices)
{
  Cell c;
  for (auto v : vertices) // -0 becomes +0
    c.push_back({v->point().x() + 0.0, v->point().y() + 0.0, v->point().z() + 0.0});
  std::sort(c.begin(), c.end());
  cells.push_back(c);
}

static std::vector<Cell> triangulate(const gmds_soup &soup)
{
  std::vector<Kernel::Point_3> points;
  for (size_t i = 0; i < soup.n_points; i++)
    points.emplace_back(soup.points[3 * i], soup.points[3 * i + 1], soup.points[3 * i + 2]);
  Triangulation all(points.begin(), points.end());
  std::vector<Cell> cells;
  if (all.dimension() == 3)
    for (auto c = all.finite_cells_begin(); c != all.finite_cells_end(); ++c)
      add(cells, {c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)});
  if (all.dimension() == 2)
    for (auto f = all.finite_facets_begin(); f != all.finite_facets_end(); ++f)
      add(cells, {f->first->vertex(0), f->first->vertex(1), f->first->vertex(2)});
  return cells;
}

static bool write_cells(const char *path, const std::vector<Cell> &cells)
{
  std::FILE *out = std::fopen(path, "w");
  if (!out)
    return false;
  for (const Cell &c : cells)
    for (size_t i = 0; i < c.size(); i++)
      std::fprintf(out, "%a %a %a%s", c[i][0], c[i][1], c[i][2], i + 1 < c.size() ? " " : "\n");
  bool written = !std::ferror(out);
  return std::fclose(out) == 0 && written;
}

int main(int argc, char **argv)
{
  if (argc != 2 && (argc != 4 || std::strcmp(argv[2], "--cells"))) {
    std::fprintf(stderr, "usage: oracle_delaunay3 SPEC [--cells FILE]\n");
    return 2;
  }
  gmds_memory memory;
  gmds_soup soup;
  gmds_error error = {};
  gmds_memory_init(&memory, nullptr);
  gmds_soup_init(&soup, &memory, 3);
  if (gmds_make_points(argv[1], 3, &error, &soup) != GMDS_OK) {
    std::fprintf(stderr, "oracle_delaunay3: %s\n", error.text);
    return 1;
  }
  std::vector<Cell> cells = triangulate(soup);
  gmds_soup_clear(&soup);
  if (argc == 4 && !write_cells(argv[3], cells)) {
    std::fprintf(stderr, "oracle_delaunay3: cannot write %s\n", argv[3]);
    return 1;
  }
  uint64_t sum = 0;
  for (const Cell &c : cells)
    sum += hash(c);
  std::printf("%016" PRIx64 "\n", sum);
}
