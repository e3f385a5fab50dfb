/* The readers, one a format: each takes a scanner at the beginning of a file and fills a stage. */
#ifndef GMDS_READERS_H
#define GMDS_READERS_H

#include "stage.h"
#include <gmds/io.h>

gmds_status gmds_read_off(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_obj(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_ply(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_stl(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_vtk(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_vtu(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_gmsh(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_meshb(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_medit(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_node(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_f64(gmds_text *text, gmds_stage *stage);
gmds_status gmds_read_text(gmds_text *text, gmds_stage *stage);

/* gmds_read_soup, or the points of the file alone. */
gmds_status gmds_read_file(const char *path, int dim, int points_only, gmds_error *error, gmds_soup *soup);
#endif
