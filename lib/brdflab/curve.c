/* curve.c - halve steps until the polygon is as good as the curve. */
#include "curve.h"

#include <math.h>
#include <stdlib.h>

enum {
    GRID = 90,
    DEEPEST = 10,  /* halvings of one step */
    MOST = 1 << 16 /* points in all: more than a picture can show */
};

struct tracer {
    lab_curve_function *function;
    const void *data;
    double tolerance;
    struct lab_curve *curve;
    size_t room;
    int failed;
};

static void put(struct tracer *tracer, struct lab_point point)
{
    struct lab_curve *curve = tracer->curve;
    if (curve->count == tracer->room) {
        size_t room = tracer->room ? 2 * tracer->room : 256;
        struct lab_point *grown = realloc(curve->point, room * sizeof *grown);
        if (!grown) {
            tracer->failed = 1;
            return;
        }
        curve->point = grown;
        tracer->room = room;
    }
    curve->point[curve->count++] = point;
}

/* How far p is from the line through a and b; where they are one, from that point. */
static double distance(struct lab_point a, struct lab_point b, struct lab_point p)
{
    double dx = b.x - a.x;
    double dy = b.y - a.y;
    double length = hypot(dx, dy);
    if (length < 1e-9) {
        return hypot(p.x - a.x, p.y - a.y);
    }
    return fabs(dx * (p.y - a.y) - dy * (p.x - a.x)) / length;
}

/* The points after a, up to and with b. */
static void follow(struct tracer *tracer, double t, struct lab_point a, double s,
                   struct lab_point b, int depth)
{
    double middle = 0.5 * (t + s);
    struct lab_point m = tracer->function(middle, tracer->data);
    int near = distance(a, b, m) <= tracer->tolerance && hypot(b.x - a.x, b.y - a.y) < 20.0;
    if (near || depth == 0 || tracer->failed || tracer->curve->count > MOST) {
        put(tracer, b);
        return;
    }
    follow(tracer, t, a, middle, m, depth - 1);
    follow(tracer, middle, m, s, b, depth - 1);
}

/* Does the line from a to b pass near all the points between? */
static int near_all(const struct lab_point *point, size_t a, size_t b, double tolerance)
{
    for (size_t i = a + 1; i < b; ++i) {
        double along = (point[i].x - point[a].x) * (point[b].x - point[a].x) +
                       (point[i].y - point[a].y) * (point[b].y - point[a].y);
        if (along < 0.0 || distance(point[a], point[b], point[i]) > tolerance) {
            return 0;
        }
    }
    return 1;
}

/* Leave out points that lie on the way: knots and the grid are needed to see, not to draw. */
static void thin(struct lab_curve *curve, double tolerance)
{
    enum { LONGEST = 64 }; /* points that one line stands for, so that time is linear */
    struct lab_point *point = curve->point;
    size_t kept = 1, last = 0;
    for (size_t i = 1; i + 1 < curve->count; ++i) {
        if (i + 1 - last > LONGEST || !near_all(point, last, i + 1, tolerance)) {
            last = i;
            point[kept++] = point[i];
        }
    }
    if (curve->count > 1) {
        point[kept++] = point[curve->count - 1];
    }
    curve->count = kept;
}

brdf_status lab_curve_trace(lab_curve_function *function, const void *data, double low, double high,
                            const double *knot, int count, double tolerance,
                            struct lab_curve *curve, struct brdf_error *error)
{
    curve->point = NULL;
    curve->count = 0;
    struct tracer tracer = {function, data, tolerance, curve, 0, 0};
    double t = low;
    struct lab_point a = function(low, data);
    int k = 0;
    put(&tracer, a);
    for (int i = 1; i <= GRID; ++i) {
        double line = i == GRID ? high : low + (high - low) * i / GRID;
        for (;;) {
            while (k < count && knot[k] <= t) {
                ++k;
            }
            double s = k < count && knot[k] < line ? knot[k] : line;
            struct lab_point b = function(s, data);
            follow(&tracer, t, a, s, b, DEEPEST);
            t = s;
            a = b;
            if (s >= line) {
                break;
            }
        }
    }
    if (tracer.failed) {
        lab_curve_free(curve);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for the points of a curve");
    }
    thin(curve, tolerance);
    return BRDF_OK;
}

void lab_curve_free(struct lab_curve *curve)
{
    free(curve->point);
    curve->point = NULL;
    curve->count = 0;
}
