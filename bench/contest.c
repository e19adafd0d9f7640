/* contest.c - the clock, the turns, the threads and the bandwidth of the benchmark. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench.h"

enum { MOST_THREADS = 256, MOST_TIMES = 1 << 20 };

double bench_now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static int compare_numbers(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_median(const double *values, int count)
{
    double sorted[BENCH_ROUNDS];
    memcpy(sorted, values, (size_t)count * sizeof *values);
    qsort(sorted, (size_t)count, sizeof *sorted, compare_numbers);
    return count % 2 ? sorted[count / 2] : 0.5 * (sorted[count / 2 - 1] + sorted[count / 2]);
}

struct thread_part {
    pthread_t thread;
    bench_work *work;
    void *context;
    int part, parts;
    int started;
};

static void *run_part(void *data)
{
    struct thread_part *part = data;
    part->work(part->context, part->part, part->parts);
    return NULL;
}

void bench_on_threads(int threads, bench_work *work, void *context)
{
    struct thread_part parts[MOST_THREADS];
    int count = threads < MOST_THREADS ? threads : MOST_THREADS;
    for (int i = 0; i < count; ++i) {
        parts[i].work = work;
        parts[i].context = context;
        parts[i].part = i;
        parts[i].parts = count;
        /* The last part is this thread's own; so is any that no thread can be had for. */
        parts[i].started =
            i + 1 < count && pthread_create(&parts[i].thread, NULL, run_part, &parts[i]) == 0;
    }
    for (int i = 0; i < count; ++i) {
        if (!parts[i].started) {
            run_part(&parts[i]);
        }
    }
    for (int i = 0; i < count; ++i) {
        if (parts[i].started) {
            pthread_join(parts[i].thread, NULL);
        }
    }
}

struct triad {
    float *a;
    const float *b, *c;
    size_t count;
    float scale;
    int times;
};

static void triad_part(void *context, int part, int parts)
{
    const struct triad *triad = context;
    size_t first = triad->count / (size_t)parts * (size_t)part;
    size_t end = part + 1 == parts ? triad->count : first + triad->count / (size_t)parts;
    float *restrict a = triad->a;
    for (int k = 0; k < triad->times; ++k) {
        float scale = triad->scale + (float)k; /* or one time would do for all */
        for (size_t i = first; i < end; ++i) {
            a[i] = triad->b[i] + scale * triad->c[i];
        }
    }
}

double bench_triad(int threads, size_t count, int rounds)
{
    double rate[BENCH_ROUNDS];
    float *memory = malloc(3 * count * sizeof *memory);
    if (!memory) {
        return 0.0;
    }
    for (size_t i = 0; i < 3 * count; ++i) {
        memory[i] = (float)(i % 7);
    }
    struct triad triad = {memory, memory + count, memory + 2 * count, count, 3.0f, 1};
    triad.times = (int)(((size_t)1 << 26) / count) + 1;
    for (int round = -1; round < rounds; ++round) { /* the first one is to warm up */
        double begin = bench_now();
        bench_on_threads(threads, triad_part, &triad);
        double bytes = 3.0 * sizeof(float) * (double)count * triad.times;
        rate[round < 0 ? 0 : round] = bytes / (bench_now() - begin);
    }
    free(memory);
    return bench_median(rate, rounds);
}

/* How often a contender has to do its work so that the clock can tell. */
static brdf_status calibrate(const struct bench *bench, int index, bench_run *run, void *context,
                             int *times, struct brdf_error *error)
{
    double seconds = 0.0;
    brdf_status status = run(context, index, 1, &seconds, error);
    *times = 1;
    while (!status && seconds < bench->seconds && *times < MOST_TIMES) {
        double wanted = 1.1 * (double)*times * bench->seconds / (seconds > 1e-7 ? seconds : 1e-7);
        *times = wanted < 8.0 * *times ? (int)wanted + 1 : 8 * *times;
        status = run(context, index, *times, &seconds, error);
    }
    return status;
}

brdf_status bench_contest(const struct bench *bench, struct bench_row *row, double work,
                          bench_run *run, void *context, struct brdf_error *error)
{
    int times[BENCH_CONTENDERS];
    brdf_status status = BRDF_OK;
    for (int i = 0; i < row->contenders && !status; ++i) {
        status = calibrate(bench, i, run, context, &times[i], error);
    }
    for (int round = 0; round < bench->rounds && !status; ++round) {
        for (int i = 0; i < row->contenders && !status; ++i) {
            double seconds = 0.0;
            status = run(context, i, times[i], &seconds, error);
            row->contender[i].rate[round] =
                work * (double)times[i] / (seconds > 0.0 ? seconds : 1e-9);
        }
    }
    for (int i = 0; i < row->contenders && !status; ++i) {
        row->contender[i].median = bench_median(row->contender[i].rate, bench->rounds);
    }
    return status;
}
