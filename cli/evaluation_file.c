/* evaluation_file.c - f and pdf for the directions that a file lists. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluation.h"

enum { BLOCK = 16384, NUMBERS = 6 };

struct reader {
    FILE *file;
    const char *path;
    unsigned long line;
};

struct block {
    float in[NUMBERS][BLOCK]; /* wo, wi */
    float f[3][BLOCK];
    float pdf[BLOCK];
    size_t count;
};

/* Six numbers between commas or spaces; how many were read before something else came. */
static int read_numbers(const char *text, float number[NUMBERS])
{
    for (int i = 0; i < NUMBERS; ++i) {
        char *end;
        text += strspn(text, " \t");
        if (i > 0 && *text == ',') {
            ++text;
        }
        number[i] = strtof(text, &end);
        if (end == text) {
            return i;
        }
        text = end;
    }
    text += strspn(text, " \t\r\n");
    return *text ? NUMBERS + 1 : NUMBERS;
}

static brdf_status check_unit(const struct reader *reader, const char *name, const float w[3],
                              struct brdf_error *error)
{
    double length = sqrt((double)w[0] * (double)w[0] + (double)w[1] * (double)w[1] +
                         (double)w[2] * (double)w[2]);
    if (!(fabs(length - 1.0) <= 1e-3)) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s:%lu: %s has the length %.6g: directions must be unit vectors",
                         reader->path, reader->line, name, length);
    }
    return BRDF_OK;
}

/* One line into the block, unless it is empty or a heading. */
static brdf_status take_line(const struct reader *reader, const char *text, struct block *block,
                             struct brdf_error *error)
{
    float number[NUMBERS];
    if (text[strspn(text, " \t\r\n")] == '\0') {
        return BRDF_OK;
    }
    int found = read_numbers(text, number);
    if (found == 0 && reader->line == 1) {
        return BRDF_OK;
    }
    if (found != NUMBERS) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s:%lu: expected six numbers, the unit vectors wo and wi as x,y,z,x,y,z",
                         reader->path, reader->line);
    }
    brdf_status status = check_unit(reader, "wo", number, error);
    status = status ? status : check_unit(reader, "wi", number + 3, error);
    if (!status) {
        for (int i = 0; i < NUMBERS; ++i) {
            block->in[i][block->count] = number[i];
        }
        ++block->count;
    }
    return status;
}

static brdf_status read_block(struct reader *reader, struct block *block, struct brdf_error *error)
{
    char text[512];
    brdf_status status = BRDF_OK;
    block->count = 0;
    while (block->count < BLOCK && !status && fgets(text, sizeof text, reader->file)) {
        ++reader->line;
        if (!strchr(text, '\n') && !feof(reader->file)) {
            return brdf_fail(error, BRDF_BAD_FILE, "%s:%lu: the line is longer than 510 bytes",
                             reader->path, reader->line);
        }
        status = take_line(reader, text, block, error);
    }
    if (!status && ferror(reader->file)) {
        status = brdf_fail(error, BRDF_IO, "%s: %s", reader->path, strerror(errno));
    }
    return status;
}

static brdf_status print_block(const struct evaluation *evaluation, struct block *block,
                               struct brdf_error *error)
{
    struct brdf_vectors wo = {block->in[0], block->in[1], block->in[2]};
    struct brdf_vectors wi = {block->in[3], block->in[4], block->in[5]};
    struct brdf_colors f = {block->f[0], block->f[1], block->f[2]};
    brdf_status status = evaluation_run(evaluation, block->count, wo, wi, f, block->pdf, error);
    for (size_t i = 0; i < block->count && !status; ++i) {
        printf("%.9g,%.9g,%.9g,%.9g\n", (double)f.r[i], (double)f.g[i], (double)f.b[i],
               (double)block->pdf[i]);
    }
    return status;
}

brdf_status evaluation_print_file(const struct evaluation *evaluation, const char *path,
                                  struct brdf_error *error)
{
    int is_input = strcmp(path, "-") == 0;
    struct reader reader = {is_input ? stdin : fopen(path, "r"), is_input ? "standard input" : path,
                            0};
    struct block *block = malloc(sizeof *block);
    brdf_status status = BRDF_OK;
    if (!reader.file) {
        status = brdf_fail(error, BRDF_IO, "%s: %s", path, strerror(errno));
        goto done;
    }
    if (!block) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for a block of directions");
        goto done;
    }
    printf("f_r,f_g,f_b,pdf\n");
    do {
        status = read_block(&reader, block, error);
        status = status ? status : print_block(evaluation, block, error);
    } while (!status && block->count == BLOCK && !ferror(stdout));
done:
    free(block);
    if (reader.file && !is_input) {
        fclose(reader.file);
    }
    return status;
}
