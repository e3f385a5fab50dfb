/* The self-test of the floating-point arithmetic that the predicates rest on. */
#include <gmds/predicates.h>

gmds_status gmds_predicates_check(void)
{
  /* Volatile: the compiler shall not evaluate any of this itself. */
  volatile double one = 1, small = 0x1p-53, smallest = 0x1p-1022, factor = 1 + 0x1p-30;
  /* To nearest, ties to even, for both signs: no directed mode gives all of these. */
  double up = one + (small + 0x1p-60), tie = one + small, down = -one - (small + 0x1p-60), tie_down = -one - small;
  if (up != 1 + 0x1p-52 || tie != 1 || down != -1 - 0x1p-52 || tie_down != -1)
    return GMDS_ERR_PLATFORM;
  /* (1 + 2^-30)^2 needs 61 bits. Rounded first, the square cancels; contracted, 2^-60 is left. */
  double x = factor, contracted = x * x - (1 + 0x1p-29);
  if (contracted != 0)
    return GMDS_ERR_PLATFORM;
  /* Subnormal results and subnormal operands. */
  volatile double subnormal = smallest * 0x1p-52;
  if (!(subnormal > 0) || subnormal * 0x1p52 != smallest)
    return GMDS_ERR_PLATFORM;
  return GMDS_OK;
}
