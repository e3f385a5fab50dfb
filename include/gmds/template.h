/* How templates by inclusion are named: what every header that opens or closes a model shares. */
#ifndef GMDS_TEMPLATE_H
#define GMDS_TEMPLATE_H

#define GMDS_CAT_(a, b) a##_##b
#define GMDS_CAT(a, b) GMDS_CAT_(a, b)
#define GMDS_TEXT_(x) #x
#define GMDS_TEXT(x) GMDS_TEXT_(x)

/* The name of the open model: <prefix>_<name>. */
#define GMDS_FN(name) GMDS_CAT(GMDS_PREFIX, name)

/* A function that must not be called: the sentence says what to change. */
#if defined __clang__ || (defined __GNUC__ && __GNUC__ >= 12)
#  define GMDS_UNAVAILABLE(text) __attribute__((unavailable(text)))
#elif defined __GNUC__
#  define GMDS_UNAVAILABLE(text) __attribute__((error(text)))
#else
#  define GMDS_UNAVAILABLE(text)
#endif

/* Backends of a model. */
#define GMDS_INCIDENCE 1
#define GMDS_CMAP 2

/* For functions with a parameter that is a constant in every call: each call compiles its own. */
#define GMDS_SPECIALISED __attribute__((always_inline)) static inline

/* For functions that are compiled by themselves: loops whose registers a caller would take. */
#define GMDS_APART __attribute__((noinline)) static

#endif
