/* The list of all compiled models. */
#include "volumes/volume.h"

#define X(table) extern const volume_model table;
#include "list.h"
#undef X

const volume_model *const volume_models[] = {
#define X(table) &table,
#include "list.h"
#undef X
};
const size_t n_volume_models = sizeof volume_models / sizeof *volume_models;
