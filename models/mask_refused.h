/* What a model that was refused is taken for: it keeps and stores everything. */
#undef GMDS__K_0
#define GMDS__K_0 1
#undef GMDS__K_1
#define GMDS__K_1 1
#undef GMDS__K_2
#define GMDS__K_2 1
#undef GMDS__S_0_0
#define GMDS__S_0_0 1
#undef GMDS__S_0_1
#define GMDS__S_0_1 1
#undef GMDS__S_0_2
#define GMDS__S_0_2 1
#undef GMDS__S_0_3
#define GMDS__S_0_3 GMDS__K_3
#undef GMDS__S_1_0
#define GMDS__S_1_0 1
#undef GMDS__S_1_1
#define GMDS__S_1_1 1
#undef GMDS__S_1_2
#define GMDS__S_1_2 1
#undef GMDS__S_1_3
#define GMDS__S_1_3 GMDS__K_3
#undef GMDS__S_2_0
#define GMDS__S_2_0 1
#undef GMDS__S_2_1
#define GMDS__S_2_1 1
#undef GMDS__S_2_2
#define GMDS__S_2_2 1
#undef GMDS__S_2_3
#define GMDS__S_2_3 GMDS__K_3
#undef GMDS__S_3_0
#define GMDS__S_3_0 GMDS__K_3
#undef GMDS__S_3_1
#define GMDS__S_3_1 GMDS__K_3
#undef GMDS__S_3_2
#define GMDS__S_3_2 GMDS__K_3
#undef GMDS__S_3_3
#define GMDS__S_3_3 GMDS__K_3
#undef GMDS__REFUSED
