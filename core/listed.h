/* How attributes of cells of a soup are named on the cells of a mesh of volumes. Private to the library. */
#ifndef GMDS_CORE_LISTED_H
#define GMDS_CORE_LISTED_H

#include <gmds/volume.h>
#include <stdio.h>

enum { NAME_SIZE = 512 };

/* What a vertex has as a cell is kept apart from what it has as a point. */
#define VERTEX "vertex "

/* The name that an attribute of a cell has on the i-cells for the q-th time that the cell is listed, from 0: NAME,
 * NAME (2), ... */
static inline const char *name_on_cells(const char *name, int i, int q, char room[NAME_SIZE])
{
  if (i && !q)
    return name;
  if (q)
    snprintf(room, NAME_SIZE, "%s%s (%d)", i ? "" : VERTEX, name, q + 1);
  else
    snprintf(room, NAME_SIZE, "%s%s", VERTEX, name);
  return room;
}

#endif
