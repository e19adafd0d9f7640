/* report.c - the benchmark as a table and as JSON. */
#include <stdio.h>
#include <string.h>

#include "bench.h"

void bench_report_begin(struct bench *bench)
{
    const struct brdfcl_device_info *info = &bench->info;
    const double giga = 1e9;
    printf("device    %s, %d cores, native lanes %d\n", info->name, info->compute_units,
           info->native_lanes);
    printf("platform  %s\n", info->platform_version);
    printf("C         " __VERSION__ ", %d threads\n", bench->threads);
    printf("triad     %.1f GB/s with %.1f MB (as much as %d evaluations touch), %.1f GB/s in "
           "memory\n",
           bench->triad_near / giga, 76e-6 * bench->count, bench->count,
           bench->triad_memory / giga);
    printf("rounds    %d, in turns; medians\n", bench->rounds);
    struct json *json = &bench->json;
    json_object(json, NULL);
    json_text(json, "version", BRDFCL_VERSION);
    json_text(json, "device", info->name);
    json_text(json, "platform", info->platform);
    json_text(json, "platform_version", info->platform_version);
    json_text(json, "driver", info->driver);
    json_int(json, "compute_units", info->compute_units);
    json_int(json, "native_lanes", info->native_lanes);
    json_text(json, "c_compiler", __VERSION__);
    json_int(json, "c_threads", bench->threads);
    json_int(json, "rounds", bench->rounds);
    json_int(json, "evaluations", bench->count);
    json_int(json, "spp", bench->spp);
    json_real(json, "triad_bytes_per_second", bench->triad_near);
    json_real(json, "triad_memory_bytes_per_second", bench->triad_memory);
    json_array(json, "rows");
}

void bench_report_heading(const struct bench *bench, const char *what, int contenders)
{
    printf("\n%-32s %-15s %8s %5s %2d", what, "operation", "C 1", "C", bench->threads);
    for (int i = 2; i < contenders; ++i) {
        int lanes = brdfcl_device_lanes(bench->device[i - 2]);
        printf("  %2d lane%s", lanes, lanes == 1 ? " " : "s");
    }
    printf("  %6s  %s\n", "ratio", "B  of triad  build s");
}

/* How fast the row moves memory, as a part of what the triad does. */
static double part_of_triad(const struct bench *bench, const struct bench_row *row)
{
    double bytes = row->contender[row->chosen].median * row->bytes;
    return bench->triad_near > 0.0 ? bytes / bench->triad_near : 0.0;
}

static void print_row(const struct bench *bench, const struct bench_row *row)
{
    const struct bench_contender *chosen = &row->contender[row->chosen];
    size_t differing = 0;
    printf("%-32.32s %-15s", row->subject, row->operation);
    for (int i = 0; i < row->contenders; ++i) {
        printf(i < 2 ? " %8.4g" : "  %8.4g", row->contender[i].median * 1e-6);
        differing += row->contender[i].differing;
    }
    printf("  %6.1f", chosen->median / row->contender[0].median);
    if (row->bytes) {
        printf(" %2d     %3.0f %%", row->bytes, 100.0 * part_of_triad(bench, row));
    } else {
        printf("          ");
    }
    printf("  %7.2f%s\n", chosen->seconds_build, differing ? "  BITS DIFFER" : "");
    fflush(stdout);
}

static void put_contender(struct json *json, const struct bench *bench,
                          const struct bench_contender *contender)
{
    json_object(json, NULL);
    json_text(json, "backend", contender->lanes ? "opencl" : "c");
    json_int(json, "lanes", contender->lanes ? contender->lanes : 1);
    json_int(json, "threads", contender->threads);
    json_real(json, "per_second", contender->median);
    json_array(json, "rounds");
    for (int i = 0; i < bench->rounds; ++i) {
        json_real(json, NULL, contender->rate[i]);
    }
    json_array_end(json);
    json_real(json, "seconds_kernel_build", contender->seconds_build);
    json_int(json, "differing", (long long)contender->differing);
    json_int(json, "max_ulp", contender->max_ulp);
    json_object_end(json);
}

void bench_report_row(struct bench *bench, const struct bench_row *row)
{
    struct json *json = &bench->json;
    print_row(bench, row);
    json_object(json, NULL);
    json_text(json, row->bytes ? "material" : "scene", row->subject);
    json_text(json, "operation", row->operation);
    if (row->bytes) {
        json_int(json, "bytes", row->bytes);
        json_real(json, "part_of_triad", part_of_triad(bench, row));
    }
    json_real(json, "opencl_to_scalar",
              row->contender[row->chosen].median / row->contender[0].median);
    json_array(json, "contenders");
    for (int i = 0; i < row->contenders; ++i) {
        put_contender(json, bench, &row->contender[i]);
    }
    json_array_end(json);
    json_object_end(json);
}

brdf_status bench_report_end(struct bench *bench, struct brdf_error *error)
{
    json_array_end(&bench->json);
    json_object_end(&bench->json);
    return bench->json_path ? json_write(&bench->json, bench->json_path, error) : BRDF_OK;
}
