/* What an insertion asks about the nodes and points of one of several threads, in the plane and in space. */

/* What follows is compiled twice: for an insertion that has the mesh to itself, and for one of several threads, each of
 * which goes from cell to cell only where all nodes are its own (strips.h). */
#define GMDS__ALONE 0
#define GMDS__SHARED 1

/* Whether a node is this thread's. The ghost, whose coordinates are not numbers, is everyone's. */
static inline int owns(const insertion *in, gmds_id v)
{
#if GMDS_CONCURRENT_STARS
  double x = point(in->m, v)[in->axis];
  return !(x < in->low) & !(x >= in->high);
#else
  (void)in;
  (void)v;
  return 1;
#endif
}

#if GMDS_TOP == 3
static inline int owns_all(const insertion *in, const gmds_id v[4])
{
  return owns(in, v[0]) & owns(in, v[1]) & owns(in, v[2]) & owns(in, v[3]);
}
#endif

/* Puts the point in hand off until all threads are done. */
static inline void defer(insertion *in)
{
#if GMDS_CONCURRENT_STARS
  in->deferred = 1;
#else
  (void)in;
#endif
}

static inline int is_deferred(const insertion *in)
{
#if GMDS_CONCURRENT_STARS
  return in->deferred;
#else
  (void)in;
  return 0;
#endif
}
