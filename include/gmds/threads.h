/* Work shared among threads. */
#ifndef GMDS_THREADS_H
#define GMDS_THREADS_H

#ifdef __cplusplus
extern "C" {
#endif

enum { GMDS_MAX_THREADS = 256 };

/* Calls body(work, t) once for each t from 0 to n - 1 and returns when all have, n from 1 to GMDS_MAX_THREADS. Thread 0
 * is the caller's; a thread that the system refuses has its part done by the caller. Starting a thread costs some 20
 * microseconds. What the bodies wrote is seen after the call. */
void gmds_share(unsigned n, void (*body)(void *work, unsigned t), void *work);

/* The first of n things that is part t's, when `threads` share them evenly: part t is [first, first of t + 1). */
#define GMDS_SHARE(n, t, threads) ((n) / (threads) * (t) + ((n) % (threads) < (t) ? (n) % (threads) : (t)))

#ifdef __cplusplus
}
#endif
#endif
