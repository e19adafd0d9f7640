/*
 * fuzz_file.h - the fuzzer's bytes as a file, for readers that want a path.
 */
#ifndef FUZZ_FILE_H
#define FUZZ_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* One file a process, written anew for each input. Ends the program where it cannot be written. */
static inline const char *fuzz_file(const uint8_t *bytes, size_t size)
{
    static char path[64];
    snprintf(path, sizeof path, "/tmp/brdfcl-fuzz-%ld", (long)getpid());
    FILE *stream = fopen(path, "wb");
    if (!stream || fwrite(bytes, 1, size, stream) != size || fclose(stream) != 0) {
        abort();
    }
    return path;
}

#endif
