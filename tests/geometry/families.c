/* Families of points that are hard for predicates in different ways; families.h says which. */
#include "families.h"
#include "draw.h"

#define FAMILY_NAME(name) #name,
const char *const family_name[family_count] = {FAMILY_LIST(FAMILY_NAME)};
#undef FAMILY_NAME

static void uniform(uint64_t *seed, double p[8])
{
  for (int i = 0; i < 8; i++)
    p[i] = random_unit(seed);
}

static void square_grid(uint64_t *seed, double p[8])
{
  double shift = integer_in(seed, -1000000, 1000000), scale = ldexp(1, (int)integer_in(seed, -320, 280));
  int side = (int)integer_in(seed, 1, 8);
  for (int i = 0; i < 8; i++)
    p[i] = (shift + integer_in(seed, 0, side)) * scale;
}

static void decimal_grid(uint64_t *seed, double p[8])
{
  double x = integer_in(seed, 0, 990), y = integer_in(seed, 0, 990), h = integer_in(seed, 1, 9);
  const double square[] = {x, y, x + h, y, x + h, y + h, x, y + h};
  for (int i = 0; i < 8; i++)
    p[i] = square[i] / 1000;
}

static void lattice_circle(uint64_t *seed, double p[8])
{
  int size = 1 << random_below(seed, 30);
  double shift = integer_in(seed, 0, 1 << 30), scale = ldexp(1, (int)integer_in(seed, -300, 260));
  double x = integer_in(seed, 1, size), y = integer_in(seed, 1, size);
  double off = integer_in(seed, 0, 3) == 0 ? integer_in(seed, -1, 1) : 0;
  /* Eight lattice points lie on the circle through (x, y) about the origin. */
  for (int i = 0; i < 4; i++) {
    double u = random_bits(seed) & 1 ? x : -x, v = random_bits(seed) & 1 ? y : -y;
    int swap = (int)(random_bits(seed) & 1);
    p[2 * i] = (shift + (swap ? v : u)) * scale;
    p[2 * i + 1] = (shift + (swap ? u : v) + (i == 3 ? off : 0)) * scale;
  }
}

static void on_a_line(uint64_t *seed, double p[8])
{
  double x = random_unit(seed), y = random_unit(seed), dx = random_unit(seed) - 0.5, dy = random_unit(seed) - 0.5;
  for (int i = 0; i < 4; i++) {
    double t = 8 * random_unit(seed) - 4;
    p[2 * i] = x + t * dx;
    p[2 * i + 1] = y + t * dy;
  }
  move_point(seed, 2, p, 2, 4);
}

static void on_a_circle(uint64_t *seed, double p[8])
{
  double x = random_unit(seed) - 0.5, y = random_unit(seed) - 0.5, radius = 0.1 + 2 * random_unit(seed);
  for (int i = 0; i < 4; i++) {
    double angle = 6.283185307179586 * random_unit(seed);
    p[2 * i] = x + radius * cos(angle);
    p[2 * i + 1] = y + radius * sin(angle);
  }
  move_point(seed, 2, p, 3, 4);
}

static void ulps_of_diagonal(uint64_t *seed, double p[8])
{
  const double diagonal[] = {0.5, 0.5, 12, 12, 24, 24, 0.5, 24};
  memcpy(p, diagonal, sizeof diagonal);
  move_point(seed, 2, p, (int)integer_in(seed, 0, 2), 64);
  if (random_bits(seed) & 1)
    move_point(seed, 2, p, 3, 64);
}

static void mirrored(uint64_t *seed, double p[8])
{
  /* Reflections in the axes and the diagonal keep the circle about the origin. */
  double x = random_unit(seed), y = random_unit(seed);
  for (int i = 0; i < 4; i++) {
    int swap = (int)(random_bits(seed) & 1);
    p[2 * i] = (swap ? y : x) * (random_bits(seed) & 1 ? 1 : -1);
    p[2 * i + 1] = (swap ? x : y) * (random_bits(seed) & 1 ? 1 : -1);
  }
  if (random_bits(seed) & 1)
    move_point(seed, 2, p, 3, 1);
}

static void any_bits(uint64_t *seed, double p[8])
{
  for (int i = 0; i < 8; i++)
    p[i] = finite_bits(seed);
}

static void any_exponents(uint64_t *seed, double p[8])
{
  for (int i = 0; i < 8; i++)
    p[i] = ldexp(integer_in(seed, -3, 3), (int)integer_in(seed, -1074, 1021));
}

static void subnormals(uint64_t *seed, double p[8])
{
  int side = (int)integer_in(seed, 1, 20);
  for (int i = 0; i < 8; i++)
    p[i] = integer_in(seed, -side, side) * 0x1p-1074;
}

static void subnormal_beside_normal(uint64_t *seed, double p[8])
{
  for (int i = 0; i < 8; i++)
    p[i] = random_bits(seed) & 1 ? integer_in(seed, -3, 3) * 0x1p-1074 : integer_in(seed, -3, 3);
}

/* Nearly degenerate points times 2^exponent. */
static void scaled(uint64_t *seed, double p[8], int exponent)
{
  switch (random_below(seed, 4)) {
  case 0:
    on_a_line(seed, p);
    break;
  case 1:
    on_a_circle(seed, p);
    break;
  case 2:
    ulps_of_diagonal(seed, p);
    break;
  default:
    mirrored(seed, p);
  }
  for (int i = 0; i < 8; i++)
    p[i] = ldexp(p[i], exponent);
}

static void scaled_down(uint64_t *seed, double p[8])
{
  scaled(seed, p, (int)integer_in(seed, -1074, -200));
}

static void underflow_ties(uint64_t *seed, double p[8])
{
  double x = (integer_in(seed, 0, 3) + 0.5) * 0x1p-537, y = 0x1p-537;
  const double about[] = {x, x, y, y, 0, 0, y, x};
  for (int i = 0; i < 8; i++)
    p[i] = moved(about[i], i == 4 || i == 5 ? 0 : (int)integer_in(seed, -1, 1));
  p[4] = (2 * random_unit(seed) - 1) * x * 0x1p-53;
  p[5] = (2 * random_unit(seed) - 1) * x * 0x1p-53;
}

static void scaled_up(uint64_t *seed, double p[8])
{
  scaled(seed, p, (int)integer_in(seed, 200, 1018));
}

static void mixed_scales(uint64_t *seed, double p[8])
{
  int far = (int)integer_in(seed, -300, 300), near = far - (int)integer_in(seed, 0, 300);
  on_a_circle(seed, p);
  for (int i = 0; i < 4; i++) {
    int exponent = random_bits(seed) & 1 ? far : near;
    p[2 * i] = ldexp(p[2 * i], exponent);
    p[2 * i + 1] = ldexp(p[2 * i + 1], exponent);
  }
}

void family_fill(int family, uint64_t *seed, double p[8])
{
#define FAMILY_FUNCTION(name) name,
  static void (*const fill[family_count])(uint64_t *, double *) = {FAMILY_LIST(FAMILY_FUNCTION)};
#undef FAMILY_FUNCTION
  fill[family](seed, p);
}
