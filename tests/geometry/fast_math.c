/* Does not compile with -ffast-math: the predicates refuse it with a sentence. */
#include <gmds/predicates.h>
