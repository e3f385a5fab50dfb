/* declaration.h for each pair of dimensions. */
#define GMDS__JOIN(x, a, b) GMDS__JOIN_(x, a, b)
#define GMDS__JOIN_(x, a, b) x##_##a##_##b
#define GMDS__A 0
#define GMDS__B 0
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 0
#define GMDS__B 1
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 0
#define GMDS__B 2
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 0
#define GMDS__B 3
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 1
#define GMDS__B 0
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 1
#define GMDS__B 1
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 1
#define GMDS__B 2
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 1
#define GMDS__B 3
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 2
#define GMDS__B 0
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 2
#define GMDS__B 1
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 2
#define GMDS__B 2
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 2
#define GMDS__B 3
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 3
#define GMDS__B 0
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 3
#define GMDS__B 1
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 3
#define GMDS__B 2
#include <gmds/models/cmap/declaration.h>
#define GMDS__A 3
#define GMDS__B 3
#include <gmds/models/cmap/declaration.h>
