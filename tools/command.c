/* What the verbs of the command share. */
#define _POSIX_C_SOURCE 200809L
#include "command.h"
#include "registry.h"
#include <gmds/named.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static void print_help(const verb *v, const option *options, size_t n_options)
{
  printf("usage: gmds %s %s\n\n%s\n", v->name, v->synopsis, v->summary);
  if (n_options)
    printf("\n");
  for (size_t k = 0; k < n_options; k++)
    printf("  %c%c --%-14s %s\n", options[k].letter ? '-' : ' ', options[k].letter ? options[k].letter : ' ',
           options[k].name, options[k].help);
}

static const option *find_option(const option *options, size_t n, const char *word, size_t length)
{
  for (size_t k = 0; k < n; k++) {
    if (length == 2 && word[0] == '-' && word[1] != '-' && word[1] == options[k].letter)
      return &options[k];
    if (length > 2 && strncmp(word, "--", 2) == 0 && strlen(options[k].name) == length - 2 &&
        strncmp(word + 2, options[k].name, length - 2) == 0)
      return &options[k];
  }
  return NULL;
}

int read_arguments(const verb *v, int argc, char **argv, const option *options, size_t n_options,
                   const char **positional, int least, int most)
{
  int n = 0, only_positional = 0;
  for (int i = 0; i < argc; i++) {
    const char *word = argv[i];
    if (only_positional || word[0] != '-' || !word[1]) {
      if (n == most)
        return misused(v, "'%s' is one argument too many", word);
      positional[n++] = word;
      continue;
    }
    if (strcmp(word, "--") == 0) {
      only_positional = 1;
      continue;
    }
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
      print_help(v, options, n_options);
      return DONE;
    }
    const char *equals = strncmp(word, "--", 2) == 0 ? strchr(word, '=') : NULL;
    const option *o = find_option(options, n_options, word, equals ? (size_t)(equals - word) : strlen(word));
    if (!o)
      return misused(v, "there is no option '%s'", word);
    if (o->flag) {
      if (equals)
        return misused(v, "option '--%s' takes no value", o->name);
      *o->flag = 1;
    } else if (equals)
      *o->value = equals + 1;
    else if (i + 1 < argc)
      *o->value = argv[++i];
    else
      return misused(v, "option '%s' lacks its value", word);
  }
  if (n < least)
    return misused(v, "an argument is missing");
  return -1;
}

int failed(const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  fputs("gmds: ", stderr);
  vfprintf(stderr, format, arguments);
  fputc('\n', stderr);
  va_end(arguments);
  return FAILED;
}

int misused(const verb *v, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  fprintf(stderr, "gmds %s: ", v->name);
  vfprintf(stderr, format, arguments);
  fprintf(stderr, "; see 'gmds %s --help'\n", v->name);
  va_end(arguments);
  return USAGE;
}

int read_number(const char *text, unsigned long least, unsigned long most, unsigned long *number)
{
  char *end = NULL;
  errno = 0;
  if (*text < '0' || *text > '9')
    return 0;
  unsigned long value = strtoul(text, &end, 10);
  if (errno || *end || value < least || value > most)
    return 0;
  *number = value;
  return 1;
}

double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int show_progress(void *user, size_t done, size_t total)
{
  progress_state *state = user;
  if (!isatty(2) || total < 100000)
    return 0;
  fprintf(stderr, "\r%s %3d %%", state->what, (int)(100.0 * (double)done / (double)total));
  state->shown = 1;
  return 0;
}

void end_progress(progress_state *state)
{
  if (state->shown)
    fputs("\r\033[K", stderr);
  state->shown = 0;
}

#define DECLARE(prefix, text) extern const model_entry prefix##_entry;
GMDS_REGISTRY(DECLARE)
DECLARE(cmap2, "cmap")
DECLARE(cmap3, "cmap")
#undef DECLARE

const model_entry *const *all_models(size_t *n)
{
#define ENTRY(prefix, text) &prefix##_entry,
  static const model_entry *const models[] = {GMDS_REGISTRY(ENTRY)};
#undef ENTRY
  *n = sizeof models / sizeof *models;
  return models;
}

static void count_surfaces(size_t *n)
{
  size_t all = 0;
  const model_entry *const *models = all_models(&all);
  *n = 0;
  for (size_t k = 0; k < all; k++)
    *n += models[k]->dim == 2;
}

static const model_entry *find_mask(unsigned mask)
{
  size_t n = 0;
  const model_entry *const *models = all_models(&n);
  for (size_t k = 0; k < n; k++)
    if (models[k]->mask == mask)
      return models[k];
  return NULL;
}

/* The mask that a name of named.h stands for, or the text itself. */
static const char *mask_of_name(const char *text)
{
#define NAME(name, mask, why)   \
  if (strcmp(text, #name) == 0) \
    return mask;
  GMDS_NAMED_LIST(NAME)
#undef NAME
  return text;
}

/* Whether a mask has R or a relation of it. */
static int keeps_regions(unsigned mask)
{
  unsigned of_regions = GMDS_R;
  for (int i = 0; i < 4; i++)
    of_regions |= (unsigned)GMDS_RELATION_BIT(i, 3) | (unsigned)GMDS_RELATION_BIT(3, i);
  return (mask & of_regions) != 0;
}

gmds_status read_mask(const char *text, int dim, gmds_error *error, unsigned *mask)
{
  return gmds_mask_parse(dim == 3 ? mask_of_name(text) : text, error, mask);
}

/* The model of a mask without borrowed relations. */
static gmds_status find_stored(const char *text, int dim, gmds_error *error, const model_entry **entry)
{
  unsigned mask = 0;
  size_t n = 0;
  if (strcmp(text, "cmap") == 0) {
    *entry = dim == 2 ? &cmap2_entry : &cmap3_entry;
    return GMDS_OK;
  }
  if (dim == 3 && !strchr(text, '|') && read_mask(text, dim, NULL, &mask) != GMDS_OK)
    return gmds_fail(
        error, GMDS_ERR_ARGUMENT,
        "'%.80s' is no model of volumes: a mask such as 'N|R|R2N' or one of the names F1 to F6, R1 to R4, or cmap",
        text);
  GMDS_TRY(read_mask(text, dim, error, &mask));
  if (dim == 3 && !keeps_regions(mask))
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "model '%.80s' keeps no regions: add R, or leave out --dim 3", text);
  mask |= GMDS_N | (dim == 2 ? GMDS_F : GMDS_R);
  mask &= ~(unsigned)(dim == 2 ? GMDS_DIM2 : GMDS_DIM3);
  *entry = find_mask(mask);
  if (*entry)
    return GMDS_OK;
  for (int j = 0; j <= dim; j += dim)
    if (gmds_path_of(mask, dim, j).cost == GMDS_COST_NONE) {
      char advice[512];
      gmds_path_advice(dim, j, sizeof advice, advice);
      return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "model '%.80s' cannot answer %d->%d: %s", text, dim, j, advice);
    }
  count_surfaces(&n);
  if (dim == 3)
    return gmds_fail(error, GMDS_ERR_UNSUPPORTED,
                     "model '%.80s' is none of the models of volumes that this command holds: F1 to F6, R1 to R4, "
                     "N|R|R2N, N|R|R2N|R2R, N|R|N2R|R2N|R2R and the 64 that `sweep --dim 3 --models paths` runs",
                     text);
  return gmds_fail(
      error, GMDS_ERR_UNSUPPORTED,
      "model '%.80s' is none of the %zu that this command holds: masks of N, F, E and the relations N2E N2F E2N E2F "
      "F2N F2E F2F",
      text, n);
}

/* The bit of the relation that a word names, alone. */
static gmds_status read_relation(const char *word, gmds_error *error, unsigned *relation)
{
  enum { CELLS = GMDS_N | GMDS_E | GMDS_F | GMDS_R };
  unsigned mask = 0;
  GMDS_TRY(gmds_mask_parse(word, error, &mask));
  mask &= ~(unsigned)CELLS;
  if (strchr(word, '|') || !mask || mask >= GMDS_DIM2)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "'+%.80s' is not one relation: write +X2Y for each that is borrowed",
                     word);
  *relation = mask;
  return GMDS_OK;
}

/* Adds a borrowed relation to a choice that has an owner. */
static gmds_status lend(const char *word, gmds_error *error, model_choice *choice)
{
  unsigned relation = 0;
  char name[128], letters[128];
  size_t n = 0;
  GMDS_TRY(read_relation(word, error, &relation));
  gmds_mask_text(choice->owner->mask, sizeof name, name);
  gmds_mask_text(relation, sizeof letters, letters);
  if (choice->owner->mask & relation)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "model '%s' stores %s: it has nothing to borrow there", name, letters);
  if (choice->runs->mask & relation)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "%s is borrowed twice", letters);
  if (strchr(letters, 'E') && !(choice->owner->mask & GMDS_E))
    return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "model '%s' keeps no edges: it cannot borrow %s", name, letters);
  const model_entry *lender = find_mask(choice->runs->mask | relation);
  count_surfaces(&n);
  if (!lender)
    return gmds_fail(error, GMDS_ERR_UNSUPPORTED,
                     "model '%s' cannot borrow %s: the %zu models of this command store N2E N2F E2N E2F F2N F2E F2F",
                     name, letters, n);
  choice->runs = lender;
  return GMDS_OK;
}

void choose_model(const model_entry *entry, model_choice *choice)
{
  *choice = (model_choice){.runs = entry};
  if (entry->name)
    snprintf(choice->name, sizeof choice->name, "%s", entry->name);
  else
    gmds_mask_text(entry->mask, sizeof choice->name, choice->name);
}

gmds_status find_model(const char *text, int dim, gmds_error *error, model_choice *choice)
{
  char words[256];
  const model_entry *entry = NULL;
  size_t length = strcspn(text, "+"), at = length;
  if (strlen(text) >= sizeof words)
    return gmds_fail(error, GMDS_ERR_ARGUMENT, "model '%.80s...' is longer than any", text);
  snprintf(words, sizeof words, "%.*s", (int)length, text);
  for (size_t k = strlen(words); k && words[k - 1] == ' '; k--)
    words[k - 1] = 0;
  GMDS_TRY(find_stored(words, dim, error, &entry));
  model_choice found;
  choose_model(entry, &found);
  if (text[at] && entry->name)
    return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "model '%s' stores no relations, and borrows none", entry->name);
  if (text[at] && dim == 3)
    return gmds_fail(error, GMDS_ERR_UNSUPPORTED, "model '%.80s': a model of volumes borrows nothing in this version",
                     text);
  while (text[at]) { /* at a plus sign */
    found.owner = entry;
    length = strcspn(text + at + 1, "+");
    snprintf(words, sizeof words, "%.*s", (int)length, text + at + 1);
    for (size_t k = strlen(words); k && words[k - 1] == ' '; k--)
      words[k - 1] = 0;
    GMDS_TRY(lend(words, error, &found));
    at += length + 1;
  }
  for (int i = 0; i < 3 && found.owner; i++)
    for (int j = 0; j < 3; j++) {
      unsigned relation = (unsigned)GMDS_RELATION_BIT(i, j);
      size_t used = strlen(found.name);
      if (found.runs->mask & ~found.owner->mask & relation)
        snprintf(found.name + used, sizeof found.name - used, " +%c2%c", "NEF"[i], "NEF"[j]);
    }
  *choice = found;
  return GMDS_OK;
}

void json_text(FILE *file, const char *text)
{
  fputc('"', file);
  for (; *text; text++)
    if (*text == '"' || *text == '\\')
      fprintf(file, "\\%c", *text);
    else if ((unsigned char)*text < 32)
      fprintf(file, "\\u%04x", (unsigned)(unsigned char)*text);
    else
      fputc(*text, file);
  fputc('"', file);
}
