/* Places along a Hilbert curve in 2 or 3 dimensions, by tables.
 *
 * The curve enters each cube of 2^dim cells at the corner `entry` and leaves along the axis `axis`; its parts are the
 * same curve, reflected and rotated (Hamilton and Rau-Chaplin 2008, "Compact Hilbert indices", the source of the
 * formulas for entries and axes; after Butz 1971). These two are the state of an automaton that reads the bits of a
 * place from the top: 8 states in 2D and 24 in 3D, not all of which occur. A table takes it over several bits of each
 * coordinate at once; it is made afresh in some microseconds, so that there is nothing to initialise or to share. */
#ifndef GMDS_GEOMETRY_HILBERT_H
#define GMDS_GEOMETRY_HILBERT_H

#include <stdint.h>

enum {
  HILBERT_BITS_2D = 16, /* of each coordinate */
  HILBERT_BITS_3D = 10,
  HILBERT_STEP_2D = 4, /* bits of each coordinate that one look into the table takes */
  HILBERT_STEP_3D = 2,
  HILBERT_ENTRIES = 2048
};

/* entry[state << (dim step) | bits of x, then of y, then of z] is the next state << 8 | the next bits of the place. */
typedef struct hilbert {
  uint16_t entry[HILBERT_ENTRIES];
} hilbert;

/* The low `dim` bits of b, rotated to the left. */
static inline unsigned hilbert_rotate(int dim, unsigned b, int by)
{
  by %= dim;
  return (b << by | b >> (dim - by)) & ((1u << dim) - 1);
}

static inline unsigned gray(unsigned w)
{
  return w ^ w >> 1;
}

/* One level of the curve: the place w of the cell with one bit of each coordinate in `cell`, and the state within it.
 */
static inline unsigned hilbert_level(int dim, unsigned *entry, int *axis, unsigned cell)
{
  unsigned turned = hilbert_rotate(dim, cell ^ *entry, dim - (*axis + 1) % dim), w = 0;
  while (gray(w) != turned)
    w++;
  unsigned corner = w ? gray((w - 1) & ~1u) : 0;
  unsigned run = w & 1 ? w : w - 1; /* its trailing ones give the axis along which the cell is left */
  int along = 0;
  for (; w && run & 1; run >>= 1)
    along++;
  *entry ^= hilbert_rotate(dim, corner, *axis + 1);
  *axis = (*axis + along + 1) % dim;
  return w;
}

static inline void hilbert_init(hilbert *table, int dim)
{
  int step = dim == 2 ? HILBERT_STEP_2D : HILBERT_STEP_3D, width = dim * step;
  for (unsigned state = 0; state < (unsigned)dim << dim; state++)
    for (unsigned cells = 0; cells < 1u << width; cells++) {
      unsigned entry = state / (unsigned)dim, place = 0;
      int axis = (int)(state % (unsigned)dim);
      for (int bit = step - 1; bit >= 0; bit--) {
        unsigned cell = 0;
        for (int k = 0; k < dim; k++)
          cell |= (cells >> ((dim - 1 - k) * step + bit) & 1) << k;
        place = place << dim | hilbert_level(dim, &entry, &axis, cell);
      }
      table->entry[state << width | cells] = (uint16_t)((entry * (unsigned)dim + (unsigned)axis) << 8 | place);
    }
}

/* The place of a cell with 16 bits a coordinate: 32 bits. */
static inline uint32_t hilbert_place_2d(const hilbert *table, uint32_t x, uint32_t y)
{
  uint32_t place = 0, e = 0;
  for (int shift = HILBERT_BITS_2D - HILBERT_STEP_2D; shift >= 0; shift -= HILBERT_STEP_2D) {
    e = table->entry[e >> 8 << 8 | (x >> shift & 15) << 4 | (y >> shift & 15)];
    place = place << 8 | (e & 255);
  }
  return place;
}

/* The place of a cell with 10 bits a coordinate: 30 bits. */
static inline uint32_t hilbert_place_3d(const hilbert *table, uint32_t x, uint32_t y, uint32_t z)
{
  uint32_t place = 0, e = 0;
  for (int shift = HILBERT_BITS_3D - HILBERT_STEP_3D; shift >= 0; shift -= HILBERT_STEP_3D) {
    e = table->entry[e >> 8 << 6 | (x >> shift & 3) << 4 | (y >> shift & 3) << 2 | (z >> shift & 3)];
    place = place << 6 | (e & 63);
  }
  return place;
}

#endif
