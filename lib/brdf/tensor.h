/*
 * tensor.h - the container of RGL files: named arrays in a "tensor file" (internal).
 *
 * A tensor file: 12 bytes "tensor_file" and a 0, two bytes of version (1, 0), 4 bytes with the
 * number of fields, then for each field 2 bytes with the length of its name, the name, 2 bytes
 * with its rank, 1 byte with its type, 8 bytes with the place of its data from the start of the
 * file, and 8 bytes for each dimension. All of it little-endian.
 */
#ifndef BRDF_TENSOR_H
#define BRDF_TENSOR_H

#include <stdint.h>
#include <stdio.h>

#include "rgl_format.h"

enum {
    BRDF_TENSOR_MAGIC = 12,    /* bytes of it */
    BRDF_TENSOR_PROLOGUE = 18, /* bytes before the first field */
    BRDF_TENSOR_UINT8 = 1,
    BRDF_TENSOR_FLOAT32 = 10,
    BRDF_TENSOR_TYPES = 12, /* 0 is none of them */
    BRDF_TENSOR_RANK_MAX = 5
};

extern const unsigned char brdf_tensor_magic[BRDF_TENSOR_MAGIC];

/* A field of an open file. */
struct brdf_tensor {
    int found;
    long long header;   /* the byte where the file describes it */
    long long data;     /* where its data begin */
    long long elements; /* product of the dimensions */
    long long dimension[BRDF_TENSOR_RANK_MAX];
};

/* An open file, and what its header says of it. */
struct brdf_tensor_file {
    FILE *stream;
    const char *path;
    long long size;
    long long at;  /* the next byte */
    long long end; /* of the data that come last */
    struct brdf_tensor field[BRDF_RGL_FIELDS];
};

/*
 * Read the header of a file that has just been opened: every field that RGL files have, with the
 * type and rank that it must have and its data inside the file; other fields must be inside too,
 * and nothing may follow the data.
 */
brdf_status brdf_tensor_header(struct brdf_tensor_file *source, struct brdf_error *error);

/* The next `count` bytes. */
brdf_status brdf_tensor_take(struct brdf_tensor_file *source, void *bytes, int count,
                             struct brdf_error *error);

/* Little-endian numbers in memory, whatever the machine. */
static inline uint64_t brdf_little(const unsigned char *bytes, int count)
{
    uint64_t word = 0;
    for (int i = count - 1; i >= 0; --i) {
        word = word << 8 | bytes[i];
    }
    return word;
}

#endif
