/* Families of points in space that are hard for predicates in different ways; families3.h says which. */
#include "families3.h"
#include "draw.h"

#define FAMILY3_NAME(name) #name,
const char *const family3_name[family3_count] = {FAMILY3_LIST(FAMILY3_NAME)};
#undef FAMILY3_NAME

static void uniform(uint64_t *seed, double p[15])
{
  for (int i = 0; i < 15; i++)
    p[i] = random_unit(seed);
}

static void cubic_grid(uint64_t *seed, double p[15])
{
  double shift = integer_in(seed, -1000000, 1000000), scale = ldexp(1, (int)integer_in(seed, -320, 280));
  int side = (int)integer_in(seed, 1, 8);
  for (int i = 0; i < 15; i++)
    p[i] = (shift + integer_in(seed, 0, side)) * scale;
}

static void decimal_grid(uint64_t *seed, double p[15])
{
  double low[3], h = integer_in(seed, 1, 9);
  for (int k = 0; k < 3; k++)
    low[k] = integer_in(seed, 0, 990);
  for (int i = 0; i < 15; i++)
    p[i] = (low[i % 3] + (random_bits(seed) & 1 ? h : 0)) / 1000;
}

/* A point that has the coordinates of q with other signs and in another order. */
static void reflect(uint64_t *seed, const double q[3], double *p)
{
  int first = (int)random_below(seed, 3), step = 1 + (int)random_below(seed, 2);
  for (int k = 0; k < 3; k++)
    p[k] = q[(first + k * step) % 3] * (random_bits(seed) & 1 ? 1 : -1);
}

static void lattice_sphere(uint64_t *seed, double p[15])
{
  int size = 1 << random_below(seed, 30);
  double shift = integer_in(seed, 0, 1 << 30), scale = ldexp(1, (int)integer_in(seed, -250, 200)), q[3];
  double off = integer_in(seed, 0, 3) == 0 ? integer_in(seed, -1, 1) : 0;
  for (int k = 0; k < 3; k++)
    q[k] = integer_in(seed, 1, size);
  for (int i = 0; i < 5; i++)
    reflect(seed, q, p + 3 * i);
  p[14] += off;
  for (int i = 0; i < 15; i++)
    p[i] = (shift + p[i]) * scale;
}

static void on_a_plane(uint64_t *seed, double p[15])
{
  double origin[3], u[3], v[3];
  for (int k = 0; k < 3; k++) {
    origin[k] = random_unit(seed);
    u[k] = random_unit(seed) - 0.5;
    v[k] = random_unit(seed) - 0.5;
  }
  for (int i = 0; i < 5; i++) {
    double s = 8 * random_unit(seed) - 4, t = 8 * random_unit(seed) - 4;
    for (int k = 0; k < 3; k++)
      p[3 * i + k] = origin[k] + s * u[k] + t * v[k];
  }
  move_point(seed, 3, p, 3, 4);
}

/* Five points of a sphere, or of the circle of it where z is `height` times the radius. */
static void about_a_centre(uint64_t *seed, double p[15], int circle)
{
  double centre[3], radius = 0.1 + 2 * random_unit(seed), height = 2 * random_unit(seed) - 1;
  for (int k = 0; k < 3; k++)
    centre[k] = random_unit(seed) - 0.5;
  for (int i = 0; i < 5; i++) {
    double z = circle ? height : 2 * random_unit(seed) - 1, angle = 6.283185307179586 * random_unit(seed);
    double across = radius * sqrt(1 - z * z);
    p[3 * i] = centre[0] + across * cos(angle);
    p[3 * i + 1] = centre[1] + across * sin(angle);
    p[3 * i + 2] = centre[2] + radius * z;
  }
}

static void on_a_sphere(uint64_t *seed, double p[15])
{
  about_a_centre(seed, p, 0);
  move_point(seed, 3, p, 4, 4);
}

static void on_a_circle(uint64_t *seed, double p[15])
{
  about_a_centre(seed, p, 1);
  for (int i = 0; i < 5; i++) {
    double *q = p + 3 * i, x = q[0];
    q[0] = 0.6 * x - 0.8 * q[2];
    q[2] = 0.8 * x + 0.6 * q[2];
  }
  move_point(seed, 3, p, 4, 4);
}

static void above_a_circle(uint64_t *seed, double p[15])
{
  double centre[3], height = 0.3 + random_unit(seed), turn = 6.283185307179586 * random_unit(seed);
  for (int k = 0; k < 3; k++)
    centre[k] = 2 * random_unit(seed) - 1;
  for (int i = 0; i < 5; i++) {
    double angle = turn + 1.5707963267948966 * (i + 0.2 * random_unit(seed)), z = i == 4 ? height : 0;
    double x = i == 4 ? 0 : cos(angle);
    p[3 * i] = centre[0] + 0.6 * x - 0.8 * z;
    p[3 * i + 1] = centre[1] + (i == 4 ? 0 : sin(angle));
    p[3 * i + 2] = centre[2] + 0.8 * x + 0.6 * z;
  }
}

static void ulps_of_diagonal(uint64_t *seed, double p[15])
{
  const double diagonal[] = {0.5, 0.5, 0.5, 12, 12, 24, 24, 24, 12, 0.5, 0.5, 24, 12, 0.5, 24};
  memcpy(p, diagonal, sizeof diagonal);
  move_point(seed, 3, p, (int)integer_in(seed, 0, 3), 64);
  if (random_bits(seed) & 1)
    move_point(seed, 3, p, 4, 64);
}

static void mirrored(uint64_t *seed, double p[15])
{
  double q[3];
  for (int k = 0; k < 3; k++)
    q[k] = random_unit(seed);
  for (int i = 0; i < 5; i++)
    reflect(seed, q, p + 3 * i);
  if (random_bits(seed) & 1)
    move_point(seed, 3, p, 4, 1);
}

static void any_bits(uint64_t *seed, double p[15])
{
  for (int i = 0; i < 15; i++)
    p[i] = finite_bits(seed);
}

static void any_exponents(uint64_t *seed, double p[15])
{
  for (int i = 0; i < 15; i++)
    p[i] = ldexp(integer_in(seed, -3, 3), (int)integer_in(seed, -1074, 1021));
}

static void subnormals(uint64_t *seed, double p[15])
{
  int side = (int)integer_in(seed, 1, 20);
  for (int i = 0; i < 15; i++)
    p[i] = integer_in(seed, -side, side) * 0x1p-1074;
}

static void subnormal_beside_normal(uint64_t *seed, double p[15])
{
  for (int i = 0; i < 15; i++)
    p[i] = random_bits(seed) & 1 ? integer_in(seed, -3, 3) * 0x1p-1074 : integer_in(seed, -3, 3);
}

/* Nearly degenerate points times 2^exponent. */
static void scaled(uint64_t *seed, double p[15], int exponent)
{
  switch (random_below(seed, 5)) {
  case 0:
    on_a_plane(seed, p);
    break;
  case 1:
    on_a_sphere(seed, p);
    break;
  case 2:
    ulps_of_diagonal(seed, p);
    break;
  case 3:
    on_a_circle(seed, p);
    break;
  default:
    mirrored(seed, p);
  }
  for (int i = 0; i < 15; i++)
    p[i] = ldexp(p[i], exponent);
}

static void scaled_down(uint64_t *seed, double p[15])
{
  scaled(seed, p, (int)integer_in(seed, -1074, -60));
}

/* Differences whose products of two, of three or of five fall to the smallest numbers. */
static void underflow_ties(uint64_t *seed, double p[15])
{
  static const int depth[] = {-537, -358, -268, -215};
  double unit = ldexp(1, depth[random_below(seed, 4)]), x = (integer_in(seed, 0, 3) + 0.5) * unit;
  for (int i = 0; i < 12; i++)
    p[i] = moved(random_bits(seed) & 1 ? x : unit, (int)integer_in(seed, -1, 1)) * (random_bits(seed) & 1 ? 1 : -1);
  for (int i = 12; i < 15; i++)
    p[i] = (2 * random_unit(seed) - 1) * x * 0x1p-53;
}

static void scaled_up(uint64_t *seed, double p[15])
{
  scaled(seed, p, (int)integer_in(seed, 60, 1018));
}

static void mixed_scales(uint64_t *seed, double p[15])
{
  int far = (int)integer_in(seed, -300, 300), near = far - (int)integer_in(seed, 0, 300);
  on_a_sphere(seed, p);
  for (int i = 0; i < 5; i++) {
    int exponent = random_bits(seed) & 1 ? far : near;
    for (int k = 0; k < 3; k++)
      p[3 * i + k] = ldexp(p[3 * i + k], exponent);
  }
}

void family3_fill(int family, uint64_t *seed, double p[15])
{
#define FAMILY3_FUNCTION(name) name,
  static void (*const fill[family3_count])(uint64_t *, double *) = {FAMILY3_LIST(FAMILY3_FUNCTION)};
#undef FAMILY3_FUNCTION
  fill[family](seed, p);
}
