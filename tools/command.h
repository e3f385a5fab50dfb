/* What the verbs of the command share: options, failures, time, progress, JSON text. */
#ifndef GMDS_COMMAND_H
#define GMDS_COMMAND_H

#include "model_entry.h"
#include <gmds/quality.h>
#include <gmds/census.h>
#include <gmds/io.h>
#include <stdio.h>

enum { DONE = 0, FAILED = 1, USAGE = 2 };

/* An option: --name, with a value when `value` is not NULL, else a flag. `letter` is a short name or 0. */
typedef struct option {
  const char *name;
  char letter;
  const char **value;
  int *flag;
  const char *help; /* "VALUE  what it means", or what a flag means */
} option;

/* A verb of the command. `run` returns DONE, FAILED or USAGE. */
typedef struct verb {
  const char *name;
  const char *synopsis;
  const char *summary;
  int (*run)(const struct verb *verb, int argc, char **argv);
} verb;

/* Reads the arguments of a verb: fills options, and up to `most` positional arguments of which `least` must be there.
 * Returns -1 to go on, else what the verb returns at once: DONE after --help (printed), USAGE after a sentence. */
int read_arguments(const verb *v, int argc, char **argv, const option *options, size_t n_options,
                   const char **positional, int least, int most);

/* One sentence on stderr; returns FAILED (USAGE with a hint at --help). */
#if defined __GNUC__
__attribute__((format(printf, 1, 2)))
#endif
int failed(const char *format, ...);
#if defined __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
int misused(const verb *v, const char *format, ...);

/* A number from text: the whole of it, from `least` to `most`. Returns 1 or 0. */
int read_number(const char *text, unsigned long least, unsigned long most, unsigned long *number);

double now(void);

/* A progress line on stderr when that is a terminal; for model_task.progress. `user` is a progress_state. */
typedef struct progress_state {
  const char *what;
  int shown;
} progress_state;
int show_progress(void *user, size_t done, size_t total);
void end_progress(progress_state *state);

/* The generated models. */
const model_entry *const *all_models(size_t *n);

/* A model as a user names it: a mask, or "MASK +X2Y" (several +X2Y if need be) for a model that borrows relations for
 * the length of the algorithm. `runs` is the model that the algorithm runs on, `owner` the one that has the mesh back,
 * NULL where nothing is borrowed. */
typedef struct model_choice {
  const model_entry *runs, *owner;
  char name[128];
} model_choice;

/* The mask that a text stands for; in dimension 3 also a name of named.h. GMDS_OK, or GMDS_ERR_ARGUMENT after a
 * sentence. */
gmds_status read_mask(const char *text, int dim, gmds_error *error, unsigned *mask);

/* The model of dimension 2 or 3 that a text stands for; in 3 also the names of named.h, and nothing is borrowed;
 * `cmap` is a combinatorial map.
 * GMDS_OK, or any other status after a sentence that says what to add, what to leave out, or which models there are. */
gmds_status find_model(const char *text, int dim, gmds_error *error, model_choice *choice);
void choose_model(const model_entry *entry, model_choice *choice);

/* gmds bench hexgrid (hexgrid.c). */
int bench_hexgrid(const verb *v, const char *size, int json);

/* A string as JSON, quoted. */
void json_text(FILE *file, const char *text);

/* Pictures (svg.c): the cells of a plane soup; and time against bytes of a sweep. */
int is_svg(const char *path);
gmds_status write_picture(const char *path, const gmds_soup *soup, gmds_error *error);

typedef struct sweep_row {
  char model[128];
  size_t points;
  model_report report;
  int ok;
  char status[512]; /* "ok", or a sentence */
} sweep_row;

gmds_status write_plot(const char *path, const sweep_row *rows, size_t n, gmds_error *error);

/* Writes a soup, or its picture where the name ends in .svg. */
gmds_status write_any(const char *path, const gmds_soup *soup, gmds_error *error);

/* The check of a soup of volumes (solid.c), which prints what it finds; a line about quality. GMDS_OK, or another
 * status after a sentence. */
gmds_status check_volumes(const char *path, const gmds_soup *soup, int json, gmds_error *error);
void print_quality(const gmds_quality *quality, const char *size);

extern const verb verb_models, verb_sweep, verb_delaunay, verb_convert, verb_info, verb_check, verb_bench,
    verb_homology;

#endif
