/* The tasks, their cost per cell, and a function that runs steps of them for each schedule. */
#include <stdint.h>

/* The tasks */

enum { MAX_CELLS = 1000000, MAX_WORK = 1000000000 };

static volatile int never = -1;
static int cells;
static int64_t iterations[MAX_CELLS];
static uint64_t sums[MAX_CELLS];

static inline void emptyTask(int cell) {
  if (cell == never) {
    never = cell - 1;
  }
}

static inline void chainTask(int cell) {
  uint64_t x = (uint64_t) cell;
  for (int64_t i = iterations[cell]; i > 0; i--) {
    x = x * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  }
  sums[cell] = x;
}

/* The laws of cost: integers only, so that another language gets the same cells */

enum { UNIFORM, HEAVY_TAILED, CLUSTERED, LAWS };
static const char *const LAW_NAMES[] = {"uniform", "heavyTailed", "clustered"};

static int64_t weight(int law, int cell) {
  static const int64_t QUARTERS[] = {20, 80, 1, 20}; /* in twentieths: 1, 4, 0.05, 1 */
  switch (law) {
    case HEAVY_TAILED: return (((uint32_t) cell * UINT32_C(2654435761)) >> 16) % 10 == 0 ? 20 : 1;
    case CLUSTERED: return QUARTERS[(int64_t) cell * 4 / cells];
    default: return 1;
  }
}

static void layOut(int law, int number, int64_t meanWork) {
  int64_t sumOfWeights = 0;
  cells = number;
  for (int cell = 0; cell < cells; cell++) {
    sumOfWeights += weight(law, cell);
  }
  for (int cell = 0; cell < cells; cell++) {
    iterations[cell] = meanWork * weight(law, cell) * cells / sumOfWeights;
    sums[cell] = 0;
  }
}

/* The schedules: a function for each and each kind of task */

#define PRAGMA(...) _Pragma(#__VA_ARGS__)
#define SWEEP(NAME, TASK, LOOP)                  \
  static void NAME##_##TASK(long steps) {        \
    for (long step = 0; step < steps; step++) {  \
      LOOP                                       \
      for (int cell = 0; cell < cells; cell++) { \
        TASK(cell);                              \
      }                                          \
    }                                            \
  }
#define SWEEPS(TASK)                                                     \
  SWEEP(sequential, TASK, )                                              \
  SWEEP(static, TASK, PRAGMA(omp parallel for schedule(static)))         \
  SWEEP(dynamic1, TASK, PRAGMA(omp parallel for schedule(dynamic, 1)))   \
  SWEEP(dynamic16, TASK, PRAGMA(omp parallel for schedule(dynamic, 16))) \
  SWEEP(guided, TASK, PRAGMA(omp parallel for schedule(guided)))

SWEEPS(emptyTask)
SWEEPS(chainTask)

typedef void Sweep(long steps);
enum { SCHEDULES = 5 };
static const char *const NAMES[] = {"sequential", "static", "dynamic,1", "dynamic,16", "guided"};
static Sweep *const EMPTY[] = {sequential_emptyTask, static_emptyTask, dynamic1_emptyTask,
                               dynamic16_emptyTask, guided_emptyTask};
static Sweep *const CHAIN[] = {sequential_chainTask, static_chainTask, dynamic1_chainTask,
                               dynamic16_chainTask, guided_chainTask};
