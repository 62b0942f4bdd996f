/* A core taken by another process: one that spins, pinned. Linux only. */
#include <err.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { TAKEN_CORE = 1 };

static pid_t taker;

static void releaseCore(void) {
  if (taker > 0) {
    kill(taker, SIGKILL);
    waitpid(taker, NULL, 0);
    taker = 0;
  }
}

static void takeCore(void) {
  pid_t parent = getpid();
  cpu_set_t core;
  CPU_ZERO(&core);
  CPU_SET(TAKEN_CORE, &core);
  taker = fork();
  if (taker == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* ends with its parent, however that ends */
    if (getppid() != parent) {
      _exit(1);
    }
    for (;;) {
    }
  }
  if (taker < 0 || sched_setaffinity(taker, sizeof core, &core) != 0) {
    err(2, "core must exist and be ours to take: core=%d", TAKEN_CORE);
  }
}
