/* How attributes of cells of a soup are named on the cells of a mesh of volumes. Private to the library. */
#ifndef GMDS_CORE_LISTED_H
#define GMDS_CORE_LISTED_H

#include <gmds/volume.h>
#include <stdio.h>
#include <string.h>

/* Of a name in a mesh; what is added to one of a soup takes at most NAME_MARKS of it. */
enum { NAME_SIZE = 512, NAME_MARKS = 32 };

/* What a vertex has as a cell is kept apart from what it has as a point. */
#define VERTEX GMDS_RESERVED "vertex "
#define AGAIN GMDS_RESERVED "again "

static inline int is_reserved(const char *name)
{
  return !strncmp(name, GMDS_RESERVED, strlen(GMDS_RESERVED));
}

/* The name that an attribute of a cell has on the i-cells for the q-th time that the cell is listed, from 0: NAME,
 * gmds:NAME (2), ...; on nodes gmds:vertex NAME, gmds:again NAME (2), ... So that no two come to the same, whatever
 * NAME is, the names of other columns do not end in a parenthesis, and the first and the second time on nodes begin
 * differently. */
static inline const char *name_on_cells(const char *name, int i, int q, char room[NAME_SIZE])
{
  if (i && !q)
    return name;
  if (q)
    snprintf(room, NAME_SIZE, "%s%s (%d)", i ? GMDS_RESERVED : AGAIN, name, q + 1);
  else
    snprintf(room, NAME_SIZE, "%s%s", VERTEX, name);
  return room;
}

/* The name under which the turns of the q-th time are remembered. */
static inline const char *name_of_turns(int q, char room[NAME_SIZE])
{
  snprintf(room, NAME_SIZE, GMDS_RESERVED "turn %d", q + 1);
  return room;
}

#endif
