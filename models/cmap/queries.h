/* answer.h for each pair of dimensions. */
#define GMDS__A 0
#define GMDS__B 0
#include <gmds/models/cmap/answer.h>
#define GMDS__A 0
#define GMDS__B 1
#include <gmds/models/cmap/answer.h>
#define GMDS__A 0
#define GMDS__B 2
#include <gmds/models/cmap/answer.h>
#define GMDS__A 0
#define GMDS__B 3
#include <gmds/models/cmap/answer.h>
#define GMDS__A 1
#define GMDS__B 0
#include <gmds/models/cmap/answer.h>
#define GMDS__A 1
#define GMDS__B 1
#include <gmds/models/cmap/answer.h>
#define GMDS__A 1
#define GMDS__B 2
#include <gmds/models/cmap/answer.h>
#define GMDS__A 1
#define GMDS__B 3
#include <gmds/models/cmap/answer.h>
#define GMDS__A 2
#define GMDS__B 0
#include <gmds/models/cmap/answer.h>
#define GMDS__A 2
#define GMDS__B 1
#include <gmds/models/cmap/answer.h>
#define GMDS__A 2
#define GMDS__B 2
#include <gmds/models/cmap/answer.h>
#define GMDS__A 2
#define GMDS__B 3
#include <gmds/models/cmap/answer.h>
#define GMDS__A 3
#define GMDS__B 0
#include <gmds/models/cmap/answer.h>
#define GMDS__A 3
#define GMDS__B 1
#include <gmds/models/cmap/answer.h>
#define GMDS__A 3
#define GMDS__B 2
#include <gmds/models/cmap/answer.h>
#define GMDS__A 3
#define GMDS__B 3
#include <gmds/models/cmap/answer.h>
