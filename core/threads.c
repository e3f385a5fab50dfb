/* Work shared among threads. POSIX threads rather than <threads.h>: race detectors know them. */
#include <gmds/threads.h>
#include <pthread.h>

typedef struct job {
  void (*body)(void *work, unsigned t);
  void *work;
  unsigned t;
} job;

static void *run_job(void *argument)
{
  const job *j = argument;
  j->body(j->work, j->t);
  return NULL;
}

void gmds_share(unsigned n, void (*body)(void *work, unsigned t), void *work)
{
  pthread_t thread[GMDS_MAX_THREADS];
  job jobs[GMDS_MAX_THREADS];
  unsigned started = 1;
  for (; started < n; started++) {
    jobs[started] = (job){body, work, started};
    if (pthread_create(&thread[started], NULL, run_job, &jobs[started]) != 0)
      break;
  }
  body(work, 0);
  for (unsigned t = started; t < n; t++)
    body(work, t);
  for (unsigned t = 1; t < started; t++)
    (void)pthread_join(thread[t], NULL);
}
