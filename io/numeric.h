/* The "C" numeric locale for the calling thread while a file is read or written. Include under POSIX.1-2008. */
#ifndef GMDS_NUMERIC_H
#define GMDS_NUMERIC_H

#include <locale.h>
#if defined __APPLE__
#  include <xlocale.h>
#endif

typedef struct gmds_numeric {
  locale_t c, old;
} gmds_numeric;

/* Returns 0 when there is no memory for a locale; otherwise gmds_numeric_leave must follow in the same thread. */
static inline int gmds_numeric_enter(gmds_numeric *numeric)
{
  numeric->c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  if (numeric->c == (locale_t)0)
    return 0;
  numeric->old = uselocale(numeric->c);
  return 1;
}

static inline void gmds_numeric_leave(gmds_numeric *numeric)
{
  uselocale(numeric->old);
  freelocale(numeric->c);
}
#endif
