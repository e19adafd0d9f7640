/* name.c - the known name that somebody meant. */
#include "brdf/info.h"

#include <string.h>

/* Longer names are not compared: nobody mistypes one into another. */
enum { LONGEST = 63 };

static int smallest(int a, int b)
{
    return a < b ? a : b;
}

/* Of ASCII letters only, whatever the locale. */
static char small_letter(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

/*
 * Edits that make b of a, with neighbours exchanged counting as one edit: the "optimal string
 * alignment" distance [Boytsov 2011, section 2.2.1]. Three rows of the table are enough.
 */
static int distance(const char *a, const char *b)
{
    int rows[3][LONGEST + 1];
    int *before = rows[0], *last = rows[1], *row = rows[2];
    int length_a = (int)strlen(a), length_b = (int)strlen(b);
    for (int j = 0; j <= length_b; ++j) {
        last[j] = j;
    }
    for (int i = 1; i <= length_a; ++i) {
        row[0] = i;
        for (int j = 1; j <= length_b; ++j) {
            char x = small_letter(a[i - 1]), y = small_letter(b[j - 1]);
            row[j] = smallest(smallest(last[j], row[j - 1]) + 1, last[j - 1] + (x != y));
            if (i > 1 && j > 1 && x == small_letter(b[j - 2]) && y == small_letter(a[i - 2])) {
                row[j] = smallest(row[j], before[j - 2] + 1);
            }
        }
        int *spare = before;
        before = last;
        last = row;
        row = spare;
    }
    return last[length_b];
}

const char *brdf_name_nearest(const char *name, const char *const *names, size_t count)
{
    size_t length = strlen(name);
    if (length > LONGEST) {
        return NULL;
    }
    const char *nearest = NULL;
    int least = (int)(length + 1) / 3 + 1;
    for (size_t i = 0; i < count; ++i) {
        if (strlen(names[i]) <= LONGEST) {
            int edits = distance(name, names[i]);
            if (edits < least) {
                least = edits;
                nearest = names[i];
            }
        }
    }
    return nearest;
}
