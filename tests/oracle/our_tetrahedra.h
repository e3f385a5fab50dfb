/* Our Delaunay tetrahedra of the points of a soup in space, as another soup. Status and sentence of delaunay(). */
#ifndef GMDS_TESTS_OUR_TETRAHEDRA_H
#define GMDS_TESTS_OUR_TETRAHEDRA_H

#include <gmds/soup.h>

#ifdef __cplusplus
extern "C" {
#endif

gmds_status our_tetrahedra(const gmds_soup *points, gmds_soup *cells, gmds_error *error);

#ifdef __cplusplus
}
#endif
#endif
