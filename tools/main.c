/* gmds: the command. */
#define _POSIX_C_SOURCE 200809L
#include "command.h"
#include <signal.h>
#include <string.h>

static const verb *const verbs[] = {&verb_models,   &verb_sweep, &verb_delaunay, &verb_convert,
                                    &verb_homology, &verb_info,  &verb_check,    &verb_bench};

static void print_verbs(FILE *file)
{
  fputs("usage: gmds VERB ...\n\n", file);
  for (size_t k = 0; k < sizeof verbs / sizeof *verbs; k++)
    fprintf(file, "  %-9s %s\n", verbs[k]->name, verbs[k]->summary);
  fputs("\n'gmds VERB --help' says more.\n", file);
}

/* What was printed must have arrived. */
static int flushed(int code)
{
  if (fflush(stdout) || ferror(stdout))
    return failed("cannot write to the standard output");
  return code;
}

int main(int argc, char **argv)
{
  signal(SIGXFSZ, SIG_IGN); /* a file over the limit is an error of writing, with its sentence */
  if (argc >= 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
    print_verbs(stdout);
    return flushed(DONE);
  }
  if (argc >= 2 && strcmp(argv[1], "--version") == 0) {
    printf("gmds %s\n", GMDS_VERSION);
    return flushed(DONE);
  }
  for (size_t k = 0; argc >= 2 && k < sizeof verbs / sizeof *verbs; k++)
    if (strcmp(argv[1], verbs[k]->name) == 0)
      return flushed(verbs[k]->run(verbs[k], argc - 2, argv + 2));
  if (argc >= 2)
    fprintf(stderr, "gmds: there is no verb '%s'; see 'gmds --help'\n", argv[1]);
  else
    print_verbs(stderr);
  return USAGE;
}
