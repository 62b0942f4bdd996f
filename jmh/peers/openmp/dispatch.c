/*
 * What does OpenMP pay to hand out cells, and how well does it balance them?
 *
 * A step is one `#pragma omp parallel for schedule(...)` over the cells, as users write it; libgomp
 * keeps its threads between steps. Schedules: static; dynamic,1; dynamic,16; guided; and a plain
 * loop, `sequential`. A task of work w is w iterations of a dependent chain, its result stored per
 * cell; work 0 is the empty task, a volatile read and a comparison that never holds.
 *
 * Expected with two threads on two cores: dynamic,1 pays a transfer of a cache line per task, some
 * 10 to 50 ns, static next to nothing. Under the clustered law static and guided get 0.6 of two
 * cores: the first thread's half, and guided's first chunk, hold 100 of 121 parts of the work.
 * With a core taken by another process every schedule loses a time slice per step, some ms, because
 * threads spin while they wait; OMP_WAIT_POLICY=passive avoids that and pays a wake-up per step.
 *
 *     jmh/peers/openmp/run.sh --all --output jmh/results/openmp-epyc2.json
 */
#define _GNU_SOURCE
#include <err.h>
#include <errno.h>
#include <getopt.h>
#include <omp.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "sweeps.h"
#include "taken.h"

#ifdef __clang__
#define COMPILER __VERSION__
#else
#define COMPILER "gcc " __VERSION__
#endif

enum { ROUNDS = 15 };

static const double WARM_UP_NS = 100e6;
static const double BATCH_NS = 1e6; /* the clock is read between batches of steps */
static const double READING_NS = 20e6;
static const double TAKEN_READING_NS = 100e6; /* several time slices of the scheduler */

/* The readings */

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1e9 * (double) time.tv_sec + (double) time.tv_nsec;
}

/* Runs for 100 ms; returns how many steps take some 1 to 2 ms, at least one. */
static long warmUp(Sweep *sweep) {
  long batch = 1;
  double begin = now();
  for (double last = begin, time; last - begin < WARM_UP_NS; last = time) {
    sweep(batch);
    time = now();
    batch = time - last < BATCH_NS ? 2 * batch : batch;
  }
  return batch;
}

static double nsPerStep(Sweep *sweep, long batch, double least) {
  long steps = 0;
  sweep(batch > 1 ? batch : 0); /* wakes the threads */
  double begin = now(), time;
  do {
    sweep(batch);
    steps += batch;
    time = now() - begin;
  } while (time < least);
  return time / (double) steps;
}

/* What it costs two threads to hand a cache line back and forth: it may change with the cores that
   the host gives a virtual machine, and the cost of every shared word with it. */
static double roundTrip(void) {
  enum { TRIPS = 20000 };
  static _Alignas(128) atomic_long there;
  static _Alignas(128) atomic_long back;
  double begin = now();
  atomic_store(&there, 0);
  atomic_store(&back, 0);
#pragma omp parallel num_threads(2)
  for (long trip = 1; trip <= TRIPS; trip++) {
    if (omp_get_thread_num() == 0) {
      atomic_store(&there, trip);
      while (atomic_load(&back) != trip) {
      }
    } else {
      while (atomic_load(&there) != trip) {
      }
      atomic_store(&back, trip);
    }
  }
  return (now() - begin) / TRIPS;
}

static uint64_t hashOfSums(void) {
  uint64_t hash = 0;
  for (int cell = 0; cell < cells; cell++) {
    hash = 31 * hash + sums[cell];
    sums[cell] = 0;
  }
  return hash;
}

static int ascending(const void *a, const void *b) {
  double x = *(const double *) a, y = *(const double *) b;
  return (x > y) - (x < y);
}

static int records;

/* One table: all schedules in turn, ROUNDS times. */
static void measure(FILE *json, int law, int number, long work, int threads, bool taken) {
  Sweep *const *sweeps = work == 0 ? EMPTY : CHAIN;
  double readings[SCHEDULES][ROUNDS], sequential = 0;
  long batches[SCHEDULES];
  uint64_t expected = 0;
  layOut(law, number, work);
  for (int s = 0; s < SCHEDULES; s++) {
    batches[s] = warmUp(sweeps[s]);
    uint64_t hash = hashOfSums();
    expected = s == 0 ? hash : expected;
    if (hash != expected) {
      errx(1, "sums must be those of sequential: schedule=%s", NAMES[s]);
    }
  }
  for (int round = 0; round < ROUNDS; round++) {
    usleep(20000); /* libgomp's threads spin for some ms before they sleep: not beside sequential */
    for (int s = 0; s < SCHEDULES; s++) {
      readings[s][round] = nsPerStep(sweeps[s], batches[s], taken ? TAKEN_READING_NS : READING_NS);
    }
  }
  double trip = threads < 2 || taken ? 0 : roundTrip();
  printf("\n%s, %d cells, work %ld%s, round trip %.0f ns\n%-11s %11s %11s %11s %9s %11s\n", LAW_NAMES[law], cells, work,
         taken ? ", a core taken" : "", trip, "schedule", "ns/task", "min", "us/step", "speed-up",
         "efficiency");
  for (int s = 0; s < SCHEDULES; s++) {
    double sorted[ROUNDS];
    memcpy(sorted, readings[s], sizeof sorted);
    qsort(sorted, ROUNDS, sizeof *sorted, ascending);
    double median = sorted[ROUNDS / 2];
    sequential = s == 0 ? median : sequential;
    int used = s == 0 ? 1 : threads;
    double speedUp = sequential / median;
    printf("%-11s %11.2f %11.2f %11.2f %9.3f %11.3f\n", NAMES[s], median / cells, sorted[0] / cells,
           median / 1e3, speedUp, speedUp / used);
    fprintf(json,
            "%s\n    {\"peer\": \"openmp\", \"schedule\": \"%s\", \"law\": \"%s\", \"cells\": %d, "
            "\"work\": %ld, \"threads\": %d, \"taken\": %s,\n     \"nsPerTaskMedian\": %.4f, "
            "\"nsPerTaskMin\": %.4f, \"sequentialNsPerTaskMedian\": %.4f, \"speedUp\": %.4f, "
            "\"efficiency\": %.4f, \"roundTripNs\": %.0f,\n     \"nsPerStep\": [",
            records++ > 0 ? "," : "", NAMES[s], LAW_NAMES[law], cells, work, used,
            taken ? "true" : "false", median / cells, sorted[0] / cells, sequential / cells, speedUp,
            speedUp / used, trip);
    for (int round = 0; round < ROUNDS; round++) {
      fprintf(json, "%.2f%s", readings[s][round], round < ROUNDS - 1 ? ", " : "]}");
    }
  }
  fflush(stdout);
}

/* Sizes and works not chosen (0 and -1) are all of them; under a skewed law 1000 cells of some 5 us. */
static void measureAll(FILE *json, int law, int number, long work, int threads, bool taken) {
  static const int SIZES[] = {64, 1000, 10000};
  static const long WORKS[] = {0, 800, 40000};
  number = number == 0 && law != UNIFORM ? 1000 : number;
  work = work < 0 && law != UNIFORM ? 4000 : work;
  for (int c = 0; c < (number == 0 ? 3 : 1); c++) {
    for (int w = 0; w < (work < 0 ? 3 : 1); w++) {
      measure(json, law, number == 0 ? SIZES[c] : number, work < 0 ? WORKS[w] : work, threads, taken);
    }
  }
}

/* Arguments and output */

static long number(const char *name, const char *text, long least, long most) {
  char *end;
  errno = 0;
  long value = strtol(text, &end, 10);
  if (end == text || *end != '\0' || errno != 0 || value < least || value > most) {
    errx(2, "%s must be from %ld to %ld: %s=%s", name, least, most, name, text);
  }
  return value;
}

static int lawOf(const char *text) {
  for (int law = 0; law < LAWS; law++) {
    if (strcmp(text, LAW_NAMES[law]) == 0) {
      return law;
    }
  }
  errx(2, "law must be uniform, heavyTailed or clustered: law=%s", text);
}

static void quote(FILE *json, const char *before, const char *name, const char *text) {
  fprintf(json, text == NULL ? "%s\"%s\": null" : "%s\"%s\": \"", before, name);
  for (; text != NULL && *text != '\0'; text++) {
    fprintf(json, strchr("\"\\", *text) != NULL ? "\\%c" : "%c", *text);
  }
  fputs(text == NULL ? "" : "\"", json);
}

static FILE *begin(const char *file, int threads) {
  static const char *const VARIABLES[] = {"OMP_WAIT_POLICY", "OMP_PROC_BIND", "OMP_PLACES",
                                          "GOMP_CPU_AFFINITY", "GOMP_SPINCOUNT"};
  FILE *json = file == NULL ? tmpfile() : fopen(file, "w");
  if (json == NULL) {
    err(3, "output must be writable: file=%s", file == NULL ? "(temporary)" : file);
  }
  printf("%s, %s, %d threads, %d processors\n", COMPILER, FLAGS, threads, omp_get_num_procs());
  quote(json, "{\n  ", "compiler", COMPILER);
  quote(json, ",\n  ", "flags", FLAGS);
  fprintf(json, ",\n  \"processors\": %d,\n  \"environment\": {", omp_get_num_procs());
  for (int v = 0; v < 5; v++) {
    quote(json, v == 0 ? "" : ", ", VARIABLES[v], getenv(VARIABLES[v]));
  }
  fputs("},\n  \"results\": [", json);
  return json;
}

int main(int count, char **arguments) {
  static const char *const USAGE =
      "[--all | --law LAW --cells N --work N --taken] [--threads N] [--output FILE]";
  static const struct option OPTIONS[] = {
      {"all", no_argument, NULL, 'a'},         {"law", required_argument, NULL, 'l'},
      {"cells", required_argument, NULL, 'c'}, {"work", required_argument, NULL, 'w'},
      {"taken", no_argument, NULL, 'k'},       {"threads", required_argument, NULL, 't'},
      {"output", required_argument, NULL, 'o'}, {0}};
  int law = UNIFORM, size = 0, threads = 2, granted = 0;
  long work = -1;
  bool all = false, chosen = false, taken = false;
  const char *output = NULL;
  opterr = 0;
  for (int option; (option = getopt_long(count, arguments, "t:o:", OPTIONS, NULL)) != -1;) {
    chosen = chosen || strchr("lcwk", option) != NULL;
    switch (option) {
      case 'a': all = true; break;
      case 'l': law = lawOf(optarg); break;
      case 'c': size = (int) number("cells", optarg, 1, MAX_CELLS); break;
      case 'w': work = number("work", optarg, 0, MAX_WORK); break;
      case 'k': taken = true; break;
      case 't': threads = (int) number("threads", optarg, 1, 1024); break;
      case 'o': output = optarg; break;
      default: errx(2, "arguments must be %s: %s", USAGE, arguments[optind - 1]);
    }
  }
  if (optind < count || (all && chosen)) {
    errx(2, "arguments must be %s: %s", USAGE, optind < count ? arguments[optind] : "--all and more");
  }
  if (law != UNIFORM && work == 0) {
    errx(2, "work must exceed 0 where cells differ: law=%s, work=0", LAW_NAMES[law]);
  }
  omp_set_dynamic(0);
  omp_set_num_threads(threads);
#pragma omp parallel reduction(+ : granted)
  granted++;
  if (granted != threads) {
    errx(2, "threads must be as many as OpenMP grants: threads=%d, granted=%d", threads, granted);
  }

  char part[4096]; /* a run cut short leaves no file under its final name */
  if (output != NULL && snprintf(part, sizeof part, "%s.part", output) >= (int) sizeof part) {
    errx(2, "output must have a shorter name: output=%s", output);
  }
  FILE *json = begin(output == NULL ? NULL : part, threads);
  atexit(releaseCore);
  if (taken) {
    takeCore();
  }
  measureAll(json, law, size, work, threads, taken);
  if (all) {
    measureAll(json, HEAVY_TAILED, 0, -1, threads, false);
    measureAll(json, CLUSTERED, 0, -1, threads, false);
    takeCore();
    measureAll(json, UNIFORM, 64, -1, threads, true);
    measureAll(json, UNIFORM, 1000, -1, threads, true);
  }
  fputs("\n  ]\n}\n", json);
  if (ferror(json) != 0 || fclose(json) != 0 || (output != NULL && rename(part, output) != 0)) {
    err(3, "output must be writable: file=%s", output == NULL ? "(temporary)" : output);
  }
  return 0;
}
