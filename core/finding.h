/* What reports are filled with. Private to the library. */
#ifndef GMDS_CORE_FINDING_H
#define GMDS_CORE_FINDING_H

#include <gmds/manifold.h>

static const gmds_finding nothing_found = {0, {GMDS_NONE, GMDS_NONE}};

static inline void found(gmds_finding *f, gmds_id a, gmds_id b)
{
  f->count++;
  if (a < f->first[0] || (a == f->first[0] && b < f->first[1])) {
    f->first[0] = a;
    f->first[1] = b;
  }
}

#endif
