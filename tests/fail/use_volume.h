/* What a program may do with a model of volumes named vol. */
static inline void use(gmds_status status)
{
  (void)status;
}

static inline void use_volume(vol_mesh *m, gmds_ids *list)
{
  const double x[3] = {0, 0, 0};
  const gmds_id v[4] = {0, 1, 2, 3};
  gmds_id c = 0;
  use(vol_mesh_init(m, NULL));
  use(vol_add_node(m, x, &c));
  use(vol_add_edge(m, 0, 1, &c));
  use(vol_add_face(m, 3, v, &c));
  use(vol_add_region(m, GMDS_TETRAHEDRON, v, &c));
  use(vol_get_adj_0_0(m, c, list));
  use(vol_get_adj_0_1(m, c, list));
  use(vol_get_adj_0_2(m, c, list));
  use(vol_get_adj_0_3(m, c, list));
  use(vol_get_adj_1_0(m, c, list));
  use(vol_get_adj_1_1(m, c, list));
  use(vol_get_adj_1_2(m, c, list));
  use(vol_get_adj_1_3(m, c, list));
  use(vol_get_adj_2_0(m, c, list));
  use(vol_get_adj_2_1(m, c, list));
  use(vol_get_adj_2_2(m, c, list));
  use(vol_get_adj_2_3(m, c, list));
  use(vol_get_adj_3_0(m, c, list));
  use(vol_get_adj_3_1(m, c, list));
  use(vol_get_adj_3_2(m, c, list));
  use(vol_get_adj_3_3(m, c, list));
  use(vol_remove_region(m, c, GMDS_KEEP_BARE));
  vol_mesh_clear(m);
}
