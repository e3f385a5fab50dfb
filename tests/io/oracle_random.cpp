/* The C++ library's random numbers, for test_make_points.c. */
#include <cstddef>
#include <cstdint>
#include <random>

extern "C" void oracle_random(std::uint64_t seed, std::size_t n, double *x)
{
  std::mt19937_64 bits(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (std::size_t i = 0; i < n; i++)
    x[i] = unit(bits);
}
