// A second opinion on Delaunay triangulations in space: TetGen's.
//     oracle_tetgen SPEC            prints the checksum (gmds/checksum.h) of TetGen's tetrahedra: that of ours where no
//                                   five points lie on a sphere
//     oracle_tetgen SPEC --valid    where points do, both choose among Delaunay triangulations: TetGen's and ours are
//                                   each held against the definition by exact predicates, and against each other by volume
// Where the points span no volume there is nothing to compare, and it says so.
#include "our_tetrahedra.h"
#include <algorithm>
#include <array>
#include <cfloat>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <gmds/checksum.h>
#include <gmds/io.h>
#include <gmds/predicates.h>
#include <map>
#include <set>
#include <tetgen.h>
#include <vector>

typedef std::array<gmds_id, 4> Tetrahedron;
typedef std::array<gmds_id, 3> Face;

struct Cells {
  std::vector<double> points;
  std::vector<Tetrahedron> tetrahedra;
  const double *at(gmds_id v) const
  {
    return points.data() + 3 * static_cast<size_t>(v);
  }
};

static Cells of_tetgen(const gmds_soup &soup)
{
  tetgenio in, out;
  char switches[] = "Q";
  Cells cells;
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(soup.n_points);
  in.pointlist = new REAL[3 * soup.n_points];
  std::copy(soup.points, soup.points + 3 * soup.n_points, in.pointlist);
  tetrahedralize(switches, &in, &out);
  cells.points.assign(out.pointlist, out.pointlist + 3 * out.numberofpoints); // without those that are there twice
  for (int t = 0; t < out.numberoftetrahedra; t++) {
    Tetrahedron v;
    for (size_t k = 0; k < 4; k++)
      v[k] = static_cast<gmds_id>(out.tetrahedronlist[4 * t + static_cast<int>(k)]);
    cells.tetrahedra.push_back(v);
  }
  return cells;
}

static Cells of_ours(const gmds_soup &soup)
{
  Cells cells;
  cells.points.assign(soup.points, soup.points + 3 * soup.n_points);
  for (size_t c = 0; c < soup.n_cells; c++) {
    Tetrahedron v;
    std::copy_n(soup.corners + soup.begin[c], 4, v.begin());
    cells.tetrahedra.push_back(v);
  }
  return cells;
}

static int fail(const char *whose, const char *what)
{
  std::fprintf(stderr, "oracle_tetgen: %s: %s\n", whose, what);
  return 1;
}

// What lies on a face, its nodes sorted: the tetrahedra there, and the face turned outwards from the first.
struct Beside {
  std::vector<size_t> tetrahedra;
  Face outwards;
};

static gmds_id opposite(const Tetrahedron &t, const Face &f)
{
  for (gmds_id v : t)
    if (std::find(f.begin(), f.end(), v) == f.end())
      return v;
  return GMDS_NONE;
}

// The hull closes, and is convex at every edge.
static int check_hull(const char *whose, const Cells &cells, const std::vector<Face> &hull)
{
  std::map<std::pair<gmds_id, gmds_id>, Face> at;
  for (const Face &f : hull)
    for (size_t k = 0; k < 3; k++)
      if (!at.emplace(std::make_pair(f[k], f[(k + 1) % 3]), f).second)
        return fail(whose, "two faces of the hull turn the same way at an edge");
  for (const auto &side : at) {
    auto beyond = at.find({side.first.second, side.first.first});
    if (beyond == at.end())
      return fail(whose, "the hull does not close");
    const Face &f = side.second;
    for (gmds_id v : beyond->second)
      if (v != side.first.first && v != side.first.second &&
          gmds_orient3d(cells.at(f[0]), cells.at(f[1]), cells.at(f[2]), cells.at(v)) > 0)
        return fail(whose, "the hull is not convex");
  }
  return 0;
}

// Positive tetrahedra, two on each face but those of the hull, and none has the opposite node of a neighbour within its
// sphere: with a convex hull, the Delaunay triangulation.
static int check_cells(const char *whose, Cells &cells)
{
  static const int outer[4][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}};
  std::map<Face, Beside> faces;
  std::vector<Face> hull;
  int turned = 0;
  for (Tetrahedron &t : cells.tetrahedra) {
    int turn = gmds_orient3d(cells.at(t[0]), cells.at(t[1]), cells.at(t[2]), cells.at(t[3]));
    if (turn == 0 || (turned && turn != turned))
      return fail(whose, "a tetrahedron is flat, or turned another way");
    turned = turn;
    if (turn < 0)
      std::swap(t[0], t[1]);
  }
  for (size_t i = 0; i < cells.tetrahedra.size(); i++)
    for (const int *k : outer) {
      const Tetrahedron &t = cells.tetrahedra[i];
      Face out = {t[static_cast<size_t>(k[0])], t[static_cast<size_t>(k[1])], t[static_cast<size_t>(k[2])]}, key = out;
      std::sort(key.begin(), key.end());
      Beside &b = faces[key];
      b.tetrahedra.push_back(i);
      if (b.tetrahedra.size() == 1)
        b.outwards = out;
    }
  for (const auto &f : faces) {
    const Beside &b = f.second;
    if (b.tetrahedra.size() > 2)
      return fail(whose, "a face has three tetrahedra");
    if (b.tetrahedra.size() == 1) {
      hull.push_back(b.outwards);
      continue;
    }
    const Tetrahedron &t = cells.tetrahedra[b.tetrahedra[0]];
    gmds_id beyond = opposite(cells.tetrahedra[b.tetrahedra[1]], f.first);
    const Face &o = b.outwards;
    if (gmds_orient3d(cells.at(o[0]), cells.at(o[1]), cells.at(o[2]), cells.at(beyond)) <= 0)
      return fail(whose, "two tetrahedra lie on the same side of a face");
    if (gmds_insphere(cells.at(t[0]), cells.at(t[1]), cells.at(t[2]), cells.at(t[3]), cells.at(beyond)) > 0)
      return fail(whose, "a sphere is not empty");
  }
  return check_hull(whose, cells, hull);
}

// Six times the volume, and what rounding may have made of it.
struct Volume {
  long double sum, error;
};

static Volume volume(const Cells &cells)
{
  Volume v = {0, 0};
  for (const Tetrahedron &t : cells.tetrahedra) {
    long double x[3][3], determinant = 0;
    for (size_t i = 0; i < 3; i++)
      for (size_t d = 0; d < 3; d++)
        x[i][d] = static_cast<long double>(cells.at(t[i + 1])[d]) - cells.at(t[0])[d];
    for (size_t d = 0; d < 3; d++) {
      const long double p = x[0][d] * x[1][(d + 1) % 3] * x[2][(d + 2) % 3],
                        q = x[0][d] * x[1][(d + 2) % 3] * x[2][(d + 1) % 3];
      determinant += p - q;
      v.error += 16 * LDBL_EPSILON * (std::fabs(p) + std::fabs(q));
    }
    v.sum += std::fabs(determinant);
    v.error += LDBL_EPSILON * v.sum;
  }
  return v;
}

// The points that are nodes of tetrahedra: all that are distinct.
static std::set<std::array<double, 3>> used(const Cells &cells)
{
  std::set<std::array<double, 3>> points;
  for (const Tetrahedron &t : cells.tetrahedra)
    for (gmds_id v : t)
      points.insert({cells.at(v)[0] + 0.0, cells.at(v)[1] + 0.0, cells.at(v)[2] + 0.0});
  return points;
}

static int compare(Cells &tetgen, Cells &ours)
{
  if (check_cells("TetGen's", tetgen) || check_cells("ours", ours))
    return 1;
  if (used(tetgen) != used(ours))
    return fail("both", "other points are nodes");
  const Volume a = volume(tetgen), b = volume(ours);
  if (!(std::fabs(a.sum - b.sum) <= a.error + b.error))
    return fail("both", "the volumes differ");
  std::printf("valid: %zu tetrahedra of TetGen, %zu of ours\n", tetgen.tetrahedra.size(), ours.tetrahedra.size());
  return 0;
}

static int run(const gmds_soup &points, const gmds_soup &cells, bool valid)
{
  Cells tetgen, ours = of_ours(cells);
  if (ours.tetrahedra.empty()) {
    std::printf("no volume\n");
    return 0;
  }
  try {
    tetgen = of_tetgen(points);
  } catch (int status) {
    std::fprintf(stderr, "oracle_tetgen: TetGen gave up with %d\n", status);
    return 1;
  }
  if (valid)
    return compare(tetgen, ours);
  uint64_t sum = 0;
  for (Tetrahedron &t : tetgen.tetrahedra) {
    uint64_t h = 0;
    if (gmds_checksum_cell(3, tetgen.points.data(), 4, t.data(), &h) != GMDS_OK)
      return 1;
    sum += h;
  }
  std::printf("%016" PRIx64 "\n", sum);
  return 0;
}

int main(int argc, char **argv)
{
  if (argc < 2 || argc > 3 || (argc == 3 && std::strcmp(argv[2], "--valid") != 0)) {
    std::fprintf(stderr, "usage: oracle_tetgen SPEC [--valid]\n");
    return 2;
  }
  gmds_memory memory;
  gmds_soup points, cells;
  gmds_error error = {};
  gmds_memory_init(&memory, nullptr);
  gmds_soup_init(&points, &memory, 3);
  gmds_soup_init(&cells, &memory, 3);
  int status = 1;
  if (gmds_make_points(argv[1], 3, &error, &points) != GMDS_OK || our_tetrahedra(&points, &cells, &error) != GMDS_OK)
    std::fprintf(stderr, "oracle_tetgen: %s\n", error.text);
  else
    status = run(points, cells, argc == 3);
  gmds_soup_clear(&points);
  gmds_soup_clear(&cells);
  return status;
}
