#include "rank.h"
#include "harness.h"

/* A matrix of bits, a row a cell. */
typedef struct matrix {
  size_t rows, words;
  uint64_t *bits;
} matrix;

static matrix new_matrix(size_t rows, size_t columns)
{
  matrix m = {rows, columns / 64 + 1, NULL};
  m.bits = calloc(rows * m.words + 1, sizeof *m.bits);
  return m;
}

static void flip(matrix *m, size_t row, size_t column)
{
  m->bits[row * m->words + column / 64] ^= UINT64_C(1) << column % 64;
}

static int get(const matrix *m, size_t row, size_t column)
{
  return m->bits[row * m->words + column / 64] >> column % 64 & 1;
}

/* By elimination; the matrix is freed. */
static size_t rank_of(matrix m)
{
  size_t rank = 0;
  for (size_t column = 0; column < 64 * m.words && rank < m.rows; column++) {
    size_t pivot = rank;
    while (pivot < m.rows && !get(&m, pivot, column))
      pivot++;
    if (pivot == m.rows)
      continue;
    for (size_t k = 0; k < m.words; k++) {
      uint64_t swap = m.bits[pivot * m.words + k];
      m.bits[pivot * m.words + k] = m.bits[rank * m.words + k];
      m.bits[rank * m.words + k] = swap;
    }
    for (size_t row = 0; row < m.rows; row++)
      if (row != rank && get(&m, row, column))
        for (size_t k = 0; k < m.words; k++)
          m.bits[row * m.words + k] ^= m.bits[rank * m.words + k];
    rank++;
  }
  free(m.bits);
  return rank;
}

/* The edges of the faces, each once. */
typedef struct edges {
  size_t n;
  gmds_id (*ends)[2];
  int *faces; /* how many sides are on each */
} edges;

static size_t find_edge(const edges *e, gmds_id a, gmds_id b)
{
  size_t k = 0;
  while (k < e->n && !(e->ends[k][0] == a && e->ends[k][1] == b) && !(e->ends[k][0] == b && e->ends[k][1] == a))
    k++;
  return k;
}

static gmds_id after(const face_list *f, size_t face, size_t i)
{
  return f->nodes[i + 1 < f->begin[face + 1] ? i + 1 : f->begin[face]];
}

static edges list_edges(const face_list *f)
{
  edges e = {0, NULL, NULL};
  const size_t sides = f->begin[f->n];
  e.ends = malloc((sides + 1) * sizeof *e.ends);
  e.faces = calloc(sides + 1, sizeof *e.faces);
  for (size_t face = 0; face < f->n; face++)
    for (size_t i = f->begin[face]; i < f->begin[face + 1]; i++) {
      const gmds_id a = f->nodes[i], b = after(f, face, i);
      const size_t k = find_edge(&e, a, b);
      if (k == e.n) {
        e.ends[e.n][0] = a;
        e.ends[e.n++][1] = b;
      }
      e.faces[k]++;
    }
  return e;
}

static void free_edges(edges *e)
{
  free(e->ends);
  free(e->faces);
}

/* The boundaries of faces in the first rows of a matrix with `more` rows behind. */
static matrix boundaries(const face_list *f, const edges *e, size_t more)
{
  matrix m = new_matrix(f->n + more, e->n);
  for (size_t face = 0; face < f->n; face++)
    for (size_t i = f->begin[face]; i < f->begin[face + 1]; i++)
      flip(&m, face, find_edge(e, f->nodes[i], after(f, face, i)));
  return m;
}

/* Whether turning some faces makes every two that share an edge run along it in different directions: a system of
 * equations modulo 2, an unknown a face, solvable when the right side does not raise the rank. */
static int find_orientable(const face_list *f, const edges *e)
{
  matrix m = new_matrix(e->n, f->n + 1), left = new_matrix(e->n, f->n + 1);
  size_t first[2], rows = 0;
  for (size_t k = 0; k < e->n; k++) {
    int n = 0, same = 0;
    for (size_t face = 0; face < f->n; face++)
      for (size_t i = f->begin[face]; i < f->begin[face + 1]; i++)
        if (find_edge(e, f->nodes[i], after(f, face, i)) == k) {
          same += f->nodes[i] == e->ends[k][0] ? 1 : -1;
          first[n++ & 1] = face;
        }
    if (n != 2)
      continue;
    for (int side = 0; side < 2; side++) {
      flip(&m, rows, first[side]);
      flip(&left, rows, first[side]);
    }
    if (same)
      flip(&m, rows, f->n);
    rows++;
  }
  return rank_of(m) == rank_of(left);
}

truth find_truth(const face_list *f)
{
  edges e = list_edges(f);
  truth t = {.edges = e.n, .orientable = find_orientable(f, &e)};
  matrix ends = new_matrix(e.n, f->n_vertices);
  char *used = calloc(f->n_vertices + 1, 1);
  for (size_t k = 0; k < e.n; k++)
    for (int end = 0; end < 2; end++) {
      flip(&ends, k, e.ends[k][end]);
      t.vertices += !used[e.ends[k][end]];
      used[e.ends[k][end]] = 1;
    }
  for (size_t k = 0; k < e.n; k++)
    t.border += e.faces[k] == 1;
  const size_t rank1 = rank_of(ends), rank2 = rank_of(boundaries(f, &e, 0));
  t.betti[0] = t.vertices - rank1;
  t.betti[1] = e.n - rank1 - rank2;
  t.betti[2] = f->n - rank2;
  free(used);
  free_edges(&e);
  return t;
}

int are_generators(const face_list *f, const gmds_csr *h1)
{
  edges e = list_edges(f);
  matrix m = boundaries(f, &e, h1->n);
  int right = 1;
  for (size_t r = 0; r < h1->n; r++) {
    const gmds_id *chain = h1->data + h1->begin[r];
    const size_t n = h1->begin[r + 1] - h1->begin[r];
    right &= n >= 3;
    for (size_t k = 0; k < n; k++) {
      const size_t edge = find_edge(&e, chain[k], chain[k + 1 < n ? k + 1 : 0]);
      right &= edge < e.n;
      if (edge < e.n)
        flip(&m, f->n + r, edge);
      for (size_t q = 0; q < k; q++)
        right &= chain[q] != chain[k];
    }
  }
  right = right && rank_of(m) == rank_of(boundaries(f, &e, 0)) + h1->n;
  free_edges(&e);
  return right;
}

int are_closed(const face_list *f, const gmds_csr *h2)
{
  edges e = list_edges(f);
  char *met = calloc(f->n + 1, 1);
  int right = 1;
  for (size_t r = 0; r < h2->n; r++) {
    matrix m = new_matrix(1, e.n);
    for (size_t k = h2->begin[r]; k < h2->begin[r + 1]; k++) {
      const gmds_id face = h2->data[k];
      right &= !met[face];
      met[face] = 1;
      for (size_t i = f->begin[face]; i < f->begin[face + 1]; i++)
        flip(&m, 0, find_edge(&e, f->nodes[i], after(f, face, i)));
    }
    right &= h2->begin[r] < h2->begin[r + 1] && rank_of(m) == 0;
  }
  free(met);
  free_edges(&e);
  return right;
}

int are_components(const face_list *f, const gmds_ids *h0)
{
  size_t *label = malloc((f->n_vertices + 1) * sizeof *label);
  int right = 1;
  for (size_t v = 0; v < f->n_vertices; v++)
    label[v] = v;
  for (int changed = 1; changed;) {
    changed = 0;
    for (size_t face = 0; face < f->n; face++)
      for (size_t i = f->begin[face]; i < f->begin[face + 1]; i++) {
        size_t *a = &label[f->nodes[i]], *b = &label[after(f, face, i)], least = *a < *b ? *a : *b;
        changed |= *a != *b;
        *a = *b = least;
      }
  }
  for (size_t i = 0; i < f->begin[f->n]; i++) {
    size_t n = 0;
    for (size_t k = 0; k < h0->n; k++)
      n += label[h0->data[k]] == label[f->nodes[i]];
    right &= n == 1;
  }
  free(label);
  return right;
}
