// The same steps on our maps and on CGAL's Combinatorial_map: afterwards both have the same links, told by walking both at
// once from the darts that were there before.
//   oracle_maps [SEEDS]     exit 0: every script agrees
#define CGAL_NDEBUG // it finds marks of its own left behind where a cell is its own neighbour
#include <CGAL/Combinatorial_map.h>
#include <CGAL/Combinatorial_map_operations.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

extern "C" {
#include <gmds/map.h>
}

namespace
{

// splitmix64, as in harness.h
uint64_t random_bits(uint64_t &state)
{
  uint64_t z = state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

enum { NONE, SEWN, UNSEWN, SPLIT, STARRED, CUT, DANGLED, REMOVED, CONTRACTED, KINDS };

// One dimension: both maps side by side, and which of CGAL's darts is which of ours.
template <unsigned N> struct pair_of_maps {
  typedef CGAL::Combinatorial_map<N> cgal_map;
  typedef typename cgal_map::Dart_handle handle;
  gmds_map ours;
  cgal_map theirs;
  std::vector<handle> dart; // theirs for each of ours
  std::size_t done[KINDS] = {0}, invalid = 0;

  pair_of_maps()
  {
    gmds_map_init(&ours, N, 3, 15, nullptr);
  }
  ~pair_of_maps()
  {
    gmds_map_clear(&ours);
  }

  // CGAL links what is left of a cell that was its own neighbour with itself; ours becomes free, since an involution
  // of an n-map has no fixed points.
  handle link_of(handle h, unsigned i)
  {
    const handle f = theirs.beta(h, i);
    return i > 1 && f == h ? theirs.null_dart_handle : f;
  }

  // Their map made anew from our links, so that every step begins with the same on both sides.
  void copy()
  {
    theirs.clear();
    dart.assign(ours.darts.end, theirs.null_dart_handle);
    for (gmds_id d = 0; d < ours.darts.end; d++)
      if (gmds_map_has(&ours, d))
        dart[d] = theirs.create_dart();
    for (gmds_id d = 0; d < ours.darts.end; d++)
      for (unsigned i = 1; i <= N && gmds_map_has(&ours, d); i++) {
        const gmds_id e = gmds_map_beta(&ours, (int)i, d);
        if (e != GMDS_NONE && (i == 1 || e > d))
          theirs.basic_link_beta(dart[d], dart[e], i);
      }
  }

  // Walks both maps at once from pairs that are known and learns the others. False: links differ.
  bool learn(std::vector<std::pair<gmds_id, handle>> known, std::size_t others = 0)
  {
    dart.assign(ours.darts.end, theirs.null_dart_handle);
    std::size_t n = 0;
    for (auto &p : known)
      if (gmds_map_has(&ours, p.first)) {
        if (dart[p.first] != theirs.null_dart_handle && dart[p.first] != p.second)
          return false;
        n += dart[p.first] == theirs.null_dart_handle;
        dart[p.first] = p.second;
      }
    for (std::size_t k = 0; k < known.size(); k++) {
      const gmds_id d = known[k].first;
      if (!gmds_map_has(&ours, d))
        continue;
      for (unsigned i = 0; i <= N; i++) {
        const gmds_id e = gmds_map_beta(&ours, (int)i, d);
        const handle f = link_of(known[k].second, i);
        if ((e == GMDS_NONE) != (f == theirs.null_dart_handle))
          return false;
        if (e == GMDS_NONE)
          continue;
        if (dart[e] == theirs.null_dart_handle) {
          dart[e] = f;
          known.emplace_back(e, f);
          n++;
        } else if (dart[e] != f)
          return false;
      }
    }
    return n + others == ours.darts.count && theirs.number_of_darts() == n;
  }

  // What is known after an operation: the darts that were there before and still are on both sides.
  std::vector<std::pair<gmds_id, handle>> survivors(const std::vector<bool> &stays)
  {
    std::vector<std::pair<gmds_id, handle>> known;
    for (gmds_id d = 0; d < dart.size() && d < ours.darts.end; d++)
      if (d < stays.size() && stays[d] && gmds_map_has(&ours, d))
        known.emplace_back(d, dart[d]);
    return known;
  }

  bool make(uint64_t what)
  {
    const int kind = (int)(what % (N > 2 ? 4 : 3));
    gmds_id d = GMDS_NONE;
    handle h;
    const std::size_t had = ours.darts.count;
    theirs.clear();
    if (kind == 3) {
      if (gmds_map_make_shape(&ours, what / 8 % 2 ? GMDS_TETRAHEDRON : GMDS_HEXAHEDRON, nullptr, nullptr, &d) !=
          GMDS_OK)
        return false;
      h = what / 8 % 2 ? theirs.make_combinatorial_tetrahedron() : theirs.make_combinatorial_hexahedron();
    } else {
      if (gmds_map_make_polygon(&ours, 3 + (std::size_t)kind, nullptr, nullptr, &d) != GMDS_OK)
        return false;
      h = theirs.make_combinatorial_polygon(3 + (unsigned)kind);
    }
    return learn({{d, h}}, had);
  }

  // Whether the face of d is open.
  bool is_open(gmds_id d)
  {
    gmds_id e = d;
    do
      e = gmds_map_beta(&ours, 1, e);
    while (e != GMDS_NONE && e != d);
    return e == GMDS_NONE;
  }

  // A dart of a face that is 3-sewn with itself, or GMDS_NONE.
  gmds_id folded_face()
  {
    for (gmds_id d = gmds_cells_next(&ours.darts, 0); d != GMDS_NONE && N > 2;
         d = gmds_cells_next(&ours.darts, d + 1)) {
      gmds_id e = d;
      do {
        if (gmds_map_beta(&ours, 3, d) == e)
          return d;
        e = gmds_map_beta(&ours, 1, e);
      } while (e != GMDS_NONE && e != d);
    }
    return GMDS_NONE;
  }

  // Whether e is on the cell that d would be sewn by: ours folds it where that makes a map, CGAL refuses; or one face
  // is open and the other is not: ours refuses, CGAL looks at one end alone.
  bool is_fold(unsigned i, gmds_id d, gmds_id e)
  {
    gmds_memory memory;
    gmds_memory_init(&memory, nullptr);
    gmds_ids orbit = {nullptr, 0, 0, &memory};
    bool fold = true;
    if (gmds_map_orbit(&ours, d, i == 3 ? GMDS_BETA(1) : i == 1 && N > 2 ? GMDS_BETA(3) : 0, &orbit) == GMDS_OK)
      fold = gmds_ids_has(&orbit, e) && d != e;
    gmds_ids_clear(&orbit);
    return fold || (i == 3 && is_open(d) != is_open(e));
  }

  template <unsigned I> bool sew(gmds_id d, gmds_id e)
  {
    if (is_fold(I, d, e))
      return true;
    const bool free = theirs.is_free(dart[d], I) && theirs.is_free(dart[e], I == 1 ? 0 : I) && (I == 1 || d != e);
    const bool can = free && theirs.template is_sewable<I>(dart[d], dart[e]);
    const gmds_status status = gmds_map_sew(&ours, (int)I, d, e);
    if (can != (status == GMDS_OK))
      return false;
    if (can)
      theirs.template sew<I>(dart[d], dart[e]);
    done[SEWN] += can;
    return true;
  }

  template <unsigned I> bool unsew(gmds_id d)
  {
    const bool can = !theirs.is_free(dart[d], I);
    if (can != (gmds_map_unsew(&ours, (int)I, d) == GMDS_OK))
      return false;
    if (can)
      theirs.template unsew<I>(dart[d]);
    done[UNSEWN] += can;
    return true;
  }

  template <unsigned I> bool remove(gmds_id d)
  {
    const bool can = theirs.template is_removable<I>(dart[d]);
    if (can != (gmds_map_remove_cell(&ours, (int)I, d) == GMDS_OK))
      return false;
    if (can)
      theirs.template remove_cell<I>(dart[d]);
    done[REMOVED] += can;
    return true;
  }

  template <unsigned I> bool contract(gmds_id d)
  {
    const bool can = theirs.template is_contractible<I>(dart[d]);
    if (can != (gmds_map_contract_cell(&ours, (int)I, d) == GMDS_OK))
      return false;
    if (can)
      theirs.template contract_cell<I>(dart[d]);
    done[CONTRACTED] += can;
    return true;
  }

  bool insert(uint64_t what, gmds_id d, gmds_id e)
  {
    gmds_id made = GMDS_NONE;
    switch (what % 4) {
    case 0:
      if (gmds_map_insert_vertex_in_edge(&ours, d, nullptr, &made) != GMDS_OK)
        return false;
      theirs.insert_cell_0_in_cell_1(dart[d]);
      done[SPLIT]++;
      return true;
    case 1:
      if (gmds_map_insert_vertex_in_face(&ours, d, nullptr, &made) != GMDS_OK)
        return true;
      theirs.insert_cell_0_in_cell_2(dart[d]);
      done[STARRED]++;
      return true;
    case 2:
      if (gmds_map_insert_edge_in_face(&ours, d, e, &made) != GMDS_OK)
        return true;
      theirs.insert_cell_1_in_cell_2(dart[d], dart[e]);
      done[CUT]++;
      return true;
    default:
      if (gmds_map_insert_dangling_edge(&ours, d, nullptr, &made) != GMDS_OK)
        return true;
      theirs.insert_dangling_cell_1_in_cell_2(dart[d]);
      done[DANGLED]++;
      return true;
    }
  }

  bool step(uint64_t &seed);
  bool step_of(unsigned kind, unsigned i, gmds_id d, gmds_id e, uint64_t what);
};

template <> bool pair_of_maps<2>::step_of(unsigned kind, unsigned i, gmds_id d, gmds_id e, uint64_t what)
{
  switch (kind) {
  case 0:
    return i % 2 ? sew<1>(d, e) : sew<2>(d, e);
  case 1:
    return i % 2 ? unsew<1>(d) : unsew<2>(d);
  case 2:
    return i % 2 ? remove<0>(d) : remove<1>(d);
  case 3:
    return i % 2 ? contract<1>(d) : contract<2>(d);
  default:
    return insert(what, d, e);
  }
}

template <> bool pair_of_maps<3>::step_of(unsigned kind, unsigned i, gmds_id d, gmds_id e, uint64_t what)
{
  switch (kind) {
  case 0:
    return i % 2 ? sew<2>(d, e) : sew<3>(d, e); // in space they do not find all darts of a face that is open
  case 1:
    return i % 2 ? unsew<2>(d) : unsew<3>(d);
  case 2:
    return i % 3 == 0 ? remove<0>(d) : i % 3 == 1 ? remove<1>(d) : remove<2>(d);
  case 3:
    return i % 3 == 0 ? contract<1>(d) : i % 3 == 1 ? contract<2>(d) : contract<3>(d);
  default:
    return insert(what, d, e);
  }
}

template <unsigned N> bool pair_of_maps<N>::step(uint64_t &seed)
{
  const uint64_t what = random_bits(seed);
  unsigned kind = (unsigned)(random_bits(seed) % 8);
  const unsigned i = (unsigned)(random_bits(seed) % 6);
  if (ours.darts.count < 6 || kind == 7)
    return ours.darts.count > 150 ? true : make(what);
  if (ours.darts.count > 120)
    kind = 2 + kind % 2;
  if (kind == 4) // closing is not compared: theirs does not always end where faces are open
    kind = 0;
  gmds_id at[2];
  for (gmds_id &d : at) {
    d = gmds_cells_next(&ours.darts, (gmds_id)(random_bits(seed) % ours.darts.end));
    if (d == GMDS_NONE)
      d = gmds_cells_next(&ours.darts, 0);
  }
  if (kind > 4 && what % 4 == 2 && gmds_map_beta(&ours, 1, at[0]) != GMDS_NONE) { // across a face
    at[1] = gmds_map_beta(&ours, 1, at[0]);
    if (i % 2 && gmds_map_beta(&ours, 1, at[1]) != GMDS_NONE)
      at[1] = gmds_map_beta(&ours, 1, at[1]);
  }
  std::vector<bool> stays(ours.darts.end);
  for (gmds_id k = 0; k < ours.darts.end; k++)
    stays[k] = gmds_map_has(&ours, k);
  const gmds_id folded = folded_face();
  if (folded != GMDS_NONE) { // theirs counts the darts of such a face twice: it goes, without them
    gmds_map_remove_cell(&ours, 2, folded);
    return true;
  }
  copy();
  if (!step_of(kind, i, at[0], at[1], what)) {
    std::fprintf(stderr, "dimension %u, step %u, %u: one refuses what the other does\n", N, kind, i);
    return false;
  }
  if (!theirs.is_valid()) { // an edge across a face whose other side it shares a corner with: they do one side only
    invalid++;
    return true;
  }
  if (!learn(survivors(stays))) {
    std::fprintf(stderr, "dimension %u, step %u, %u: other links\n", N, kind, i);
    return false;
  }
  return true;
}

template <unsigned N> bool agree(uint64_t seeds)
{
  std::size_t done[KINDS] = {0}, invalid = 0, steps = 0;
  for (uint64_t seed = 1; seed <= seeds; seed++) {
    pair_of_maps<N> maps;
    uint64_t state = 7919 * seed + N;
    for (int k = 0; k < 150; k++)
      if (!maps.step(state)) {
        std::fprintf(stderr, "seed %llu, step %d\n", (unsigned long long)seed, k);
        return false;
      }
    for (int k = 0; k < KINDS; k++)
      done[k] += maps.done[k];
    invalid += maps.invalid;
    steps += 150;
  }
  std::printf("dimension %u: %zu sewn, %zu unsewn, %zu + %zu + %zu + %zu inserted, %zu removed, %zu contracted\n", N,
              done[SEWN], done[UNSEWN], done[SPLIT], done[STARRED], done[CUT], done[DANGLED], done[REMOVED],
              done[CONTRACTED]);
  std::printf("after %zu of %zu steps CGAL finds its own map invalid\n", invalid, steps);
  if (invalid > steps / 10)
    return false;
  for (int k = SEWN; k < KINDS; k++)
    if (!done[k]) {
      std::fprintf(stderr, "dimension %u: nothing was done of kind %d\n", N, k);
      return false;
    }
  return true;
}

} // namespace

int main(int argc, char **argv)
{
  const uint64_t seeds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 40;
  return agree<2>(seeds) && agree<3>(seeds) ? 0 : 1;
}
