/* table_fill.c - numbers between those of a table that were computed. */
#include "table_fill.h"

#include <math.h>

/* The polynomial through four of `count` numbers around `at`; they are `stride` words apart. */
static double between(const float *numbers, int count, int stride, double at)
{
    int first = (int)at - 1;
    first = first < 0 ? 0 : first > count - 4 ? count - 4 : first;
    double t = at - first, sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        double weight = 1.0;
        for (int k = 0; k < 4; ++k) {
            weight *= k == i ? 1.0 : (t - k) / (i - k);
        }
        sum += weight * (double)numbers[(first + i) * stride];
    }
    return sum;
}

void brdf_table_fill(float *numbers, int count, int first, int last, int stride, int step)
{
    for (int i = first; i <= last; ++i) {
        if (i % step) {
            double number =
                between(numbers, (count - 1) / step + 1, step * stride, (double)i / step);
            numbers[i * stride] = (float)fmin(fmax(number, 0.0), 1.0);
        }
    }
}
