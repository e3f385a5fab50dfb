/* GMDS__IF_i_j(x): x in models that store i2j, nothing in others. What lists of the stored relations are made of. */
#if GMDS__S_0_0
#  define GMDS__IF_0_0(x) x
#else
#  define GMDS__IF_0_0(x)
#endif
#if GMDS__S_0_1
#  define GMDS__IF_0_1(x) x
#else
#  define GMDS__IF_0_1(x)
#endif
#if GMDS__S_0_2
#  define GMDS__IF_0_2(x) x
#else
#  define GMDS__IF_0_2(x)
#endif
#if GMDS__S_0_3
#  define GMDS__IF_0_3(x) x
#else
#  define GMDS__IF_0_3(x)
#endif
#if GMDS__S_1_0
#  define GMDS__IF_1_0(x) x
#else
#  define GMDS__IF_1_0(x)
#endif
#if GMDS__S_1_1
#  define GMDS__IF_1_1(x) x
#else
#  define GMDS__IF_1_1(x)
#endif
#if GMDS__S_1_2
#  define GMDS__IF_1_2(x) x
#else
#  define GMDS__IF_1_2(x)
#endif
#if GMDS__S_1_3
#  define GMDS__IF_1_3(x) x
#else
#  define GMDS__IF_1_3(x)
#endif
#if GMDS__S_2_0
#  define GMDS__IF_2_0(x) x
#else
#  define GMDS__IF_2_0(x)
#endif
#if GMDS__S_2_1
#  define GMDS__IF_2_1(x) x
#else
#  define GMDS__IF_2_1(x)
#endif
#if GMDS__S_2_2
#  define GMDS__IF_2_2(x) x
#else
#  define GMDS__IF_2_2(x)
#endif
#if GMDS__S_2_3
#  define GMDS__IF_2_3(x) x
#else
#  define GMDS__IF_2_3(x)
#endif
#if GMDS__S_3_0
#  define GMDS__IF_3_0(x) x
#else
#  define GMDS__IF_3_0(x)
#endif
#if GMDS__S_3_1
#  define GMDS__IF_3_1(x) x
#else
#  define GMDS__IF_3_1(x)
#endif
#if GMDS__S_3_2
#  define GMDS__IF_3_2(x) x
#else
#  define GMDS__IF_3_2(x)
#endif
#if GMDS__S_3_3
#  define GMDS__IF_3_3(x) x
#else
#  define GMDS__IF_3_3(x)
#endif
