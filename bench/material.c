/* material.c - one material: each operation in C on one thread and on all, and at each lane count.
 */
#include <string.h>

#include "arrays.h"
#include "bench.h"

struct material_work {
    struct bench *bench;
    struct brdf_bsdf *bsdf;
    struct arrays arrays;
    struct brdfcl_evaluator *evaluator[BENCH_LANES];
    enum operation operation;
    int times;
};

static void c_part(void *context, int part, int parts)
{
    struct material_work *work = context;
    size_t count = work->arrays.count;
    size_t first = count / (size_t)parts * (size_t)part;
    size_t end = part + 1 == parts ? count : first + count / (size_t)parts;
    for (int i = 0; i < work->times; ++i) {
        arrays_run_c(&work->arrays, work->bsdf, work->operation, first, end);
    }
}

static brdf_status run(void *context, int index, int times, double *seconds,
                       struct brdf_error *error)
{
    struct material_work *work = context;
    if (index >= 2) {
        return brdfcl_evaluator_repeat(work->evaluator[index - 2], times, seconds, error);
    }
    work->times = times;
    double begin = bench_now();
    bench_on_threads(index == 0 ? 1 : work->bench->threads, c_part, work);
    *seconds = bench_now() - begin;
    return BRDF_OK;
}

/* The results of each device against those of C; building shows in the first call. */
static brdf_status compare(struct material_work *work, struct bench_row *row,
                           struct brdf_error *error)
{
    arrays_run_c(&work->arrays, work->bsdf, work->operation, 0, work->arrays.count);
    brdf_status status = BRDF_OK;
    for (int i = 0; i < BENCH_LANES && !status; ++i) {
        struct bench_contender *contender = &row->contender[2 + i];
        double begin = bench_now(), again = 0.0;
        status = arrays_run_opencl(&work->arrays, work->evaluator[i], work->operation, error);
        double first = bench_now() - begin;
        if (!status) {
            contender->differing =
                arrays_compare(&work->arrays, work->operation, &contender->max_ulp);
            begin = bench_now();
            status = arrays_run_opencl(&work->arrays, work->evaluator[i], work->operation, error);
            again = bench_now() - begin;
        }
        contender->seconds_build += first > again ? first - again : 0.0;
        work->bench->differs |= contender->differing > 0;
    }
    return status;
}

static brdf_status open_evaluators(struct material_work *work, double build[BENCH_LANES],
                                   struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    for (int i = 0; i < BENCH_LANES && !status; ++i) {
        double begin = bench_now();
        status =
            brdfcl_evaluator_create(work->bench->device[i], work->bsdf, &work->evaluator[i], error);
        build[i] = bench_now() - begin;
    }
    return status;
}

static brdf_status bench_operation(struct material_work *work, const char *subject,
                                   const double build[BENCH_LANES], struct brdf_error *error)
{
    struct bench *bench = work->bench;
    struct bench_row row;
    memset(&row, 0, sizeof row);
    row.subject = subject;
    row.operation = operation_name(work->operation);
    row.bytes = operation_bytes(work->operation);
    row.contenders = BENCH_CONTENDERS;
    row.chosen = bench->array_chosen;
    for (int i = 0; i < BENCH_CONTENDERS; ++i) {
        row.contender[i].lanes = i < 2 ? 0 : brdfcl_device_lanes(bench->device[i - 2]);
        row.contender[i].threads = i == 0 ? 1 : i == 1 ? bench->threads : bench->info.compute_units;
        row.contender[i].seconds_build = i < 2 ? 0.0 : build[i - 2];
    }
    brdf_status status = compare(work, &row, error);
    if (!status) {
        status = bench_contest(bench, &row, (double)work->arrays.count, run, work, error);
    }
    if (!status) {
        bench_report_row(bench, &row);
    }
    return status;
}

brdf_status bench_material(struct bench *bench, const char *description, struct brdf_error *error)
{
    struct material_work work;
    double build[BENCH_LANES] = {0.0};
    memset(&work, 0, sizeof work);
    work.bench = bench;
    brdf_status status = measured_bsdf_create(description, &work.bsdf, error);
    status = status ? status : arrays_create(&work.arrays, (size_t)bench->count, 1, error);
    status = status ? status : open_evaluators(&work, build, error);
    for (int i = 0; i < OPERATION_COUNT && !status; ++i) {
        work.operation = (enum operation)i;
        status = bench_operation(&work, description, build, error);
    }
    for (int i = 0; i < BENCH_LANES; ++i) {
        brdfcl_evaluator_destroy(work.evaluator[i]);
    }
    arrays_destroy(&work.arrays);
    brdf_bsdf_destroy(work.bsdf);
    return status;
}
