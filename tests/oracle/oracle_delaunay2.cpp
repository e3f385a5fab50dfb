// The checksum (gmds/checksum.h) of CGAL's Delaunay triangulation, what every model's must be equal to:
//     oracle_delaunay2 SPEC [--cells FILE]
// SPEC is read by gmds' own io, so that both see the same points; prints 16 hexadecimal digits. --cells writes the
// triangles, one a line: the coordinates of their points in %a, points sorted, lines not.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <gmds/io.h>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_2<Kernel> Triangulation;
typedef std::array<std::array<double, 2>, 3> Triangle;

static uint64_t mix64(uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

static uint64_t hash(const Triangle &t)
{
  uint64_t h = 0;
  for (const auto &p : t)
    for (double x : p) {
      uint64_t w;
      std::memcpy(&w, &x, sizeof w);
      h = mix64((h ^ w) + 0x9e3779b97f4a7c15u);
    }
  return h;
}

static std::vector<Triangle> triangulate(const gmds_soup &soup)
{
  std::vector<Kernel::Point_2> points;
  for (size_t i = 0; i < soup.n_points; i++)
    points.emplace_back(soup.points[2 * i], soup.points[2 * i + 1]);
  Triangulation all;
  all.insert(points.begin(), points.end());
  std::vector<Triangle> triangles;
  if (all.dimension() < 2)
    return triangles;
  for (auto f = all.finite_faces_begin(); f != all.finite_faces_end(); ++f) {
    Triangle t;
    for (int i = 0; i < 3; i++)
      t[i] = {f->vertex(i)->point().x() + 0.0, f->vertex(i)->point().y() + 0.0}; // -0 becomes +0
    std::sort(t.begin(), t.end());
    triangles.push_back(t);
  }
  return triangles;
}

static bool write_cells(const char *path, const std::vector<Triangle> &triangles)
{
  std::FILE *out = std::fopen(path, "w");
  if (!out)
    return false;
  for (const Triangle &t : triangles)
    std::fprintf(out, "%a %a %a %a %a %a\n", t[0][0], t[0][1], t[1][0], t[1][1], t[2][0], t[2][1]);
  bool written = !std::ferror(out);
  return std::fclose(out) == 0 && written;
}

int main(int argc, char **argv)
{
  if (argc != 2 && (argc != 4 || std::strcmp(argv[2], "--cells"))) {
    std::fprintf(stderr, "usage: oracle_delaunay2 SPEC [--cells FILE]\n");
    return 2;
  }
  gmds_memory memory;
  gmds_soup soup;
  gmds_error error = {};
  gmds_memory_init(&memory, nullptr);
  gmds_soup_init(&soup, &memory, 2);
  if (gmds_make_points(argv[1], 2, &error, &soup) != GMDS_OK) {
    std::fprintf(stderr, "oracle_delaunay2: %s\n", error.text);
    return 1;
  }
  std::vector<Triangle> triangles = triangulate(soup);
  gmds_soup_clear(&soup);
  if (argc == 4 && !write_cells(argv[3], triangles)) {
    std::fprintf(stderr, "oracle_delaunay2: cannot write %s\n", argv[3]);
    return 1;
  }
  uint64_t sum = 0;
  for (const Triangle &t : triangles)
    sum += hash(t);
  std::printf("%016" PRIx64 "\n", sum);
}
