/*
 * scene_rows.c - growing arrays of 16-word records.
 */
#include "scene_loader.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

float *scene_rows_append(struct scene_rows *rows)
{
    float *row;
    if (rows->count == rows->capacity) {
        size_t capacity = rows->capacity + rows->capacity / 2 + 64;
        float *words;
        if (capacity > SIZE_MAX / (PT_ROW * sizeof *words)) {
            return NULL;
        }
        words = realloc(rows->words, capacity * PT_ROW * sizeof *words);
        if (!words) {
            return NULL;
        }
        rows->words = words;
        rows->capacity = capacity;
    }
    row = rows->words + PT_ROW * rows->count++;
    memset(row, 0, PT_ROW * sizeof *row);
    return row;
}

void scene_word_set(float *row, int word, int value)
{
    memcpy(row + word, &value, sizeof value);
}
