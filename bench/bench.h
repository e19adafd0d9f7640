/*
 * bench.h - the benchmark: contenders that do the same work, in turns, and what came of it.
 *
 * Every contender's results are compared with those of scalar C before anything is timed. Then all
 * of them run one after the other, several rounds, so that a machine that slows down slows all of
 * them; what is reported is the median of the rounds. Building kernels is timed apart.
 */
#ifndef BENCH_BENCH_H
#define BENCH_BENCH_H

#include <stddef.h>

#include <brdfcl/device.h>

#include "json.h"
#include "options.h"

enum {
    BENCH_LANES = 5,
    BENCH_RENDER_LANES = 4,
    BENCH_CONTENDERS = 2 + BENCH_LANES,
    BENCH_ROUNDS = 99
};

/* Who runs: 0 is C on one thread, 1 is C on all, the others are OpenCL at 1, 4, 8, 16 lanes and,
   but for renders, 32. */
struct bench_contender {
    int lanes;   /* 0 for C */
    int threads; /* of C; compute units of the device for OpenCL */
    double seconds_build;
    double rate[BENCH_ROUNDS]; /* evaluations or samples per second, of each round */
    double median;
    size_t differing; /* results that are not those of scalar C */
    unsigned max_ulp;
};

/* One row of the table: a material and an operation, or a scene. */
struct bench_row {
    const char *subject;
    const char *operation;
    int bytes;      /* that one evaluation moves; 0 for a render */
    int contenders; /* how many run */
    int chosen;     /* the one whose lanes the library takes by itself */
    struct bench_contender contender[BENCH_CONTENDERS];
};

struct bench {
    struct texts scenes;
    struct texts materials;
    char material_names[64][64]; /* of those that nobody named */
    const char *json_path;
    const char *device_choice;
    int quick;
    int variance; /* measure noise instead of time */
    int rounds;
    int count;           /* evaluations in one run of a kernel */
    int spp;             /* of renders */
    double seconds;      /* that one timing takes, at least */
    int threads;         /* all of the host */
    double triad_near;   /* bytes/s, arrays as large as those of the benchmark */
    double triad_memory; /* bytes/s, arrays larger than any cache */
    struct brdfcl_device *device[BENCH_LANES];
    struct brdfcl_device_info info;
    int render_chosen; /* the contenders whose lanes renders and evaluators take by themselves */
    int array_chosen;
    struct json json;
    int differs; /* some result was not that of scalar C */
};

double bench_now(void);
double bench_median(const double *values, int count);

/* Run a part of work, `part` of `parts`, on so many threads at once; they all take part. */
typedef void bench_work(void *context, int part, int parts);
void bench_on_threads(int threads, bench_work *work, void *context);

/* a = b + s c by `threads` threads over arrays of `count` floats; bytes per second, 0 if it
   cannot be measured. */
double bench_triad(int threads, size_t count, int rounds);

/*
 * Time the contenders of a row in turns. `run` does the work of contender `index` `times` times
 * and stores the seconds that it took; `work` is how many evaluations or samples are one time.
 */
typedef brdf_status bench_run(void *context, int index, int times, double *seconds,
                              struct brdf_error *error);
brdf_status bench_contest(const struct bench *bench, struct bench_row *row, double work,
                          bench_run *run, void *context, struct brdf_error *error);

/* All rows of a material, or the row of a scene: measured, printed, put into the JSON. */
brdf_status bench_material(struct bench *bench, const char *description, struct brdf_error *error);
brdf_status bench_scene(struct bench *bench, const char *path, struct brdf_error *error);

/* The heading, and a row: relative variance of sampling a material. variance.c */
void bench_variance_begin(struct bench *bench);
brdf_status bench_variance(struct bench *bench, const char *description, struct brdf_error *error);

/* report.c */
void bench_report_begin(struct bench *bench);
void bench_report_heading(const struct bench *bench, const char *what, int contenders);
void bench_report_row(struct bench *bench, const struct bench_row *row);
brdf_status bench_report_end(struct bench *bench, struct brdf_error *error);

#endif
