/* gmds check of a file of volumes: every relation is filled and verified, then what is there is reported. */
#include "command.h"
#include <gmds/manifold.h>
#include <gmds/quality.h>

typedef struct solid_findings {
  size_t nodes, components;
  gmds_volume_report report;
  gmds_quality measured;
} solid_findings;

#define GMDS_PREFIX solid
#define GMDS_MODEL \
  (N | E | F | R | N2N | N2E | N2F | N2R | E2N | E2E | E2F | E2R | F2N | F2E | F2F | F2R | R2N | R2E | R2F | R2R)
#define GMDS_REGIONS (TETRAHEDRON | PYRAMID | PRISM | HEXAHEDRON | POLYHEDRON)
#include <gmds/mesh.h>
#include "solid.h"
#include <gmds/end.h>

/* R2R holds two regions a face: files with more go without it. */
#define GMDS_PREFIX branched
#define GMDS_MODEL \
  (N | E | F | R | N2N | N2E | N2F | N2R | E2N | E2E | E2F | E2R | F2N | F2E | F2F | F2R | R2N | R2E | R2F)
#define GMDS_REGIONS (TETRAHEDRON | PYRAMID | PRISM | HEXAHEDRON | POLYHEDRON)
#include <gmds/mesh.h>
#include "solid.h"
#include <gmds/end.h>

/* Faces have one order around: files in which regions disagree go without faces. */
#define GMDS_PREFIX crossed
#define GMDS_MODEL (N | E | R | N2N | N2E | N2R | E2N | E2E | E2R | R2N | R2E)
#include <gmds/mesh.h>
#include "solid.h"
#include <gmds/end.h>

static long long euler_of(const gmds_volume_report *r)
{
  return (long long)r->nodes - (long long)r->edges + (long long)r->faces - (long long)r->regions;
}

static long long euler_of_border(const gmds_surface_report *s)
{
  return (long long)s->nodes - (long long)s->sides + (long long)s->faces;
}

static void print_json(const char *path, const solid_findings *f, size_t left_out)
{
  const gmds_volume_report *r = &f->report;
  const gmds_quality *q = &f->measured;
  printf("{\"file\":");
  json_text(stdout, path);
  printf(",\"nodes\":%zu,\"edges\":%zu,\"faces\":%zu,\"regions\":%zu,\"euler\":%lld,\"components\":%zu,"
         "\"isolated_nodes\":%zu,\"border_faces\":%zu,\"nonmanifold_faces\":%zu,\"nonmanifold_edges\":%zu,"
         "\"nonmanifold_nodes\":%zu,\"inconsistent_faces\":%zu,\"crossed_faces\":%zu,\"repeated\":%zu,\"inverted\":%zu,"
         "\"flat\":%zu,\"degenerate\":%zu,",
         f->nodes, r->edges, r->faces, r->regions, euler_of(r), f->components, f->nodes - r->nodes, r->border.count,
         r->crowded.count, r->pinched_edges.count, r->pinched_nodes.count, r->turned.count, r->crossed.count,
         r->repeated.count, r->inverted.count, r->degenerate.count, left_out);
  printf("\"border\":{\"nodes\":%zu,\"edges\":%zu,\"euler\":%lld,\"manifold\":%s,\"closed\":%s},\"volume\":%.17g,",
         r->surface.nodes, r->surface.sides, euler_of_border(&r->surface), r->surface.manifold ? "true" : "false",
         r->surface.closed ? "true" : "false", q->size);
  printf("\"quality\":{\"min\":%.17g,\"mean\":%.17g,\"max\":%.17g,\"bins\":[", q->min, q->mean, q->max);
  for (int k = 0; k < GMDS_QUALITY_BINS; k++)
    printf("%s%zu", k ? "," : "", q->bins[k]);
  printf("]}}\n");
}

/* How many there are, and which is the first. */
static void print_found(const gmds_finding *f, const char *what, const char *first)
{
  printf("  %zu %s", f->count, what);
  if (f->count && f->first[1] != GMDS_NONE)
    printf(", first %s %lu %lu", first, (unsigned long)f->first[0], (unsigned long)f->first[1]);
  else if (f->count)
    printf(", first %s %lu", first, (unsigned long)f->first[0]);
  printf("\n");
}

static void print_text(const char *path, const solid_findings *f, size_t left_out, const char *relations)
{
  const gmds_volume_report *r = &f->report;
  printf("%s: %zu nodes, %zu edges, %zu faces, %zu regions in %zu components, Euler characteristic %lld\n", path,
         r->nodes, r->edges, r->faces, r->regions, f->components, euler_of(r));
  printf("  %zu isolated nodes, %zu degenerate cells left out\n", f->nodes - r->nodes, left_out);
  if (r->border.count)
    printf("  border of %zu faces, Euler characteristic %lld, %s\n", r->border.count, euler_of_border(&r->surface),
           r->surface.closed ? "a closed manifold" : "no manifold");
  else
    printf("  no border\n");
  print_found(&r->crowded, "faces with more than two regions", "region and face");
  print_found(&r->pinched_edges, "edges whose regions are not one fan", "between nodes");
  print_found(&r->pinched_nodes, "nodes whose regions are not one fan", "node");
  print_found(&r->turned, "faces whose regions are oriented against each other", "region and face");
  print_found(&r->crossed, "faces whose regions list their nodes in other orders", "region and face");
  print_found(&r->repeated, "regions with the nodes of another", "region");
  print_found(&r->inverted, "inverted regions", "region");
  print_found(&r->degenerate, "flat regions", "region");
  print_quality(&f->measured, "volume");
  printf("  every relation of %s agrees with the others\n", relations);
}

void print_quality(const gmds_quality *q, const char *size)
{
  printf("  %s %.9g; quality from %.4g to %.4g, mean %.4g, %zu of 0 or less; a tenth each:", size, q->size, q->min,
         q->max, q->mean, q->inverted);
  for (int k = 0; k < GMDS_QUALITY_BINS; k++)
    printf(" %zu", q->bins[k]);
  printf("\n");
}

gmds_status check_volumes(const char *path, const gmds_soup *soup, int json, gmds_error *error)
{
  solid_findings f = {.nodes = 0};
  const char *relations = "the sixteen";
  gmds_status status = solid_inspect(soup, &f, error);
  if (status == GMDS_ERR_CONFLICT) {
    relations = "the sixteen but R2R";
    status = branched_inspect(soup, &f, error);
  }
  if (status == GMDS_ERR_CONFLICT) { /* the sentence stays where this does not hold the regions either */
    relations = "the eight without faces and R2R";
    status = crossed_inspect(soup, &f, NULL) == GMDS_OK ? GMDS_OK : status;
  }
  if (status != GMDS_OK)
    return status;
  if (json)
    print_json(path, &f, soup->degenerate);
  else
    print_text(path, &f, soup->degenerate, relations);
  return GMDS_OK;
}
