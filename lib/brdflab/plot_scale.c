/* plot_scale.c - linear and logarithmic scales with round ticks. */
#include "plot_scale.h"

#include <math.h>
#include <stdio.h>

/* The 1, 2 or 5 times a power of ten that is at least x. */
static double round_step(double x)
{
    double power = pow(10.0, floor(log10(x)));
    double ratio = x / power;
    return power * (ratio <= 1.0 ? 1.0 : ratio <= 2.0 ? 2.0 : ratio <= 5.0 ? 5.0 : 10.0);
}

struct plot_scale plot_scale_linear(double most, int ticks)
{
    double step = most > 0.0 ? round_step(most / ticks) : 1.0;
    struct plot_scale scale = {0, 0.0, most > 0.0 ? 1.03 * most : 1.0, step};
    return scale;
}

struct plot_scale plot_scale_decades(double least, double most, int decades)
{
    double high = most > 0.0 ? ceil(log10(most) - 1e-6) : 0.0;
    double low = least > 0.0 ? floor(log10(least) + 1e-6) : high - decades;
    low = fmin(fmax(low, high - decades), high - 1.0);
    struct plot_scale scale = {1, pow(10.0, low), pow(10.0, high), 0.0};
    return scale;
}

struct plot_scale plot_scale_fixed(double low, double high, double step)
{
    struct plot_scale scale = {0, low, high, step};
    return scale;
}

double plot_scale_at(const struct plot_scale *scale, double value)
{
    if (!scale->logarithmic) {
        return (value - scale->low) / (scale->high - scale->low);
    }
    return value > 0.0 ? log(value / scale->low) / log(scale->high / scale->low) : -1.0;
}

int plot_scale_tick(const struct plot_scale *scale, int i, double *value)
{
    if (scale->logarithmic) {
        *value = scale->low * pow(10.0, i);
        return *value <= scale->high * 1.0001;
    }
    *value = (ceil(scale->low / scale->step - 1e-9) + i) * scale->step;
    return *value <= scale->high + 1e-9 * scale->step;
}

void plot_scale_label(const struct plot_scale *scale, double value, char *text, size_t size)
{
    const char *minus = value < 0.0 ? "\xe2\x88\x92" : "";
    double absolute = fabs(value);
    int power = absolute > 0.0 ? (int)floor(log10(absolute) + 1e-9) : 0;
    if (power >= -3 && power <= 3) {
        snprintf(text, size, "%s%.4g", minus, absolute);
        return;
    }
    char mantissa[16] = ""; /* of a power of ten on a logarithmic scale it goes without saying */
    if (!scale->logarithmic) {
        snprintf(mantissa, sizeof mantissa, "%.3g\xc2\xb7", absolute / pow(10.0, power));
    }
    snprintf(text, size, "%s%s10^{%s%d}", minus, mantissa, power < 0 ? "\xe2\x88\x92" : "",
             power < 0 ? -power : power);
}
