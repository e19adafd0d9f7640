/* progress.c - how far a render is. */
#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { BAR = 28 };

/* Without a terminal: a line each 10 %, but not more often than this many seconds, and at least
   as often as that many. */
static const double seldom = 2.0, often = 15.0;

const char *short_number(double value, char text[16])
{
    static const char *const units[] = {"", " k", " M", " G", " T"};
    int unit = 0;
    while (value >= 999.5 && unit < 4) {
        value /= 1000.0;
        ++unit;
    }
    snprintf(text, 16, "%.3g%s", value, units[unit]);
    return text;
}

const char *short_time(double seconds, char text[32])
{
    if (seconds < 0.9995) {
        snprintf(text, 32, "%.0f ms", seconds * 1e3);
    } else if (seconds < 59.95) {
        snprintf(text, 32, "%.1f s", seconds);
    } else if (seconds < 3600.0) {
        int whole = (int)(seconds + 0.5);
        snprintf(text, 32, "%d min %02d s", whole / 60, whole % 60);
    } else if (seconds < 360000.0) {
        int minutes = (int)(seconds / 60.0 + 0.5);
        snprintf(text, 32, "%d h %02d min", minutes / 60, minutes % 60);
    } else {
        snprintf(text, 32, "%.0f days", seconds / 86400.0);
    }
    return text;
}

struct progress progress_begin(int quiet)
{
    const char *kind = getenv("TERM");
    struct progress progress = {quiet, 0, 0, 0.0, 0};
    progress.terminal = isatty(STDERR_FILENO) && kind && strcmp(kind, "dumb") != 0;
    if (progress.terminal && !quiet) {
        fputs("getting ready ...", stderr);
        progress.shown = 1;
    }
    return progress;
}

/* "37 %  4.2 s, 7.1 s left, 5.43 M samples/s" */
static void describe(const struct brdfcl_progress *state, int percent, char *text, size_t size)
{
    char done[32], left[32], rate[16];
    double per_second = state->seconds > 0.0 ? (double)state->samples / state->seconds : 0.0;
    double rest = per_second > 0.0 ? (double)(state->samples_all - state->samples) / per_second : 0;
    snprintf(text, size, "%3d %%  %s, %s left, %s samples/s", percent,
             short_time(state->seconds, done), per_second > 0.0 ? short_time(rest, left) : "?",
             short_number(per_second, rate));
}

void progress_show(struct progress *progress, const struct brdfcl_progress *state)
{
    if (progress->quiet || state->samples_all <= 0) {
        return;
    }
    double part = (double)state->samples / (double)state->samples_all;
    int percent = (int)(part * 100.0);
    char text[128];
    describe(state, percent, text, sizeof text);
    if (progress->terminal) {
        char bar[BAR + 1];
        int filled = (int)(part * BAR);
        for (int i = 0; i < BAR; ++i) {
            bar[i] = i < filled ? '=' : i == filled ? '>' : ' ';
        }
        bar[BAR] = '\0';
        fprintf(stderr, "\r[%s] %s\033[K", bar, text);
        fflush(stderr);
        progress->shown = 1;
        return;
    }
    double since = state->seconds - progress->said;
    if ((percent / 10 > progress->said_percent / 10 && since >= seldom) || since >= often) {
        fprintf(stderr, "%s\n", text);
        progress->said = state->seconds;
        progress->said_percent = percent;
    }
}

void progress_end(struct progress *progress)
{
    if (progress->shown) {
        fputs("\r\033[K", stderr);
        progress->shown = 0;
    }
}
