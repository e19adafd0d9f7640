/* studio.c - two softboxes, sky and ground. */
#include "studio.h"
#include "angle.h"

#include <math.h>

static struct studio_lamp lamp_make(float x, float y, float z, double degrees, double radiance)
{
    struct studio_lamp lamp;
    lamp.frame = brdf_frame_from_normal(brdf_normalize(brdf_vec3_make(x, y, z)));
    lamp.angle = degrees * pi / 180.0;
    lamp.cosine = cos(lamp.angle);
    lamp.radiance = radiance;
    lamp.density = 1.0 / (2.0 * pi * (1.0 - lamp.cosine));
    return lamp;
}

struct studio studio_make(void)
{
    struct studio studio = {
        {lamp_make(-0.55f, 0.66f, 0.58f, 11.0, 26.0), lamp_make(0.86f, 0.30f, -0.22f, 16.0, 7.0)}};
    return studio;
}

/* From 0 to 1 as x goes there, with level ends. */
static double smooth(double x)
{
    x = fmin(1.0, fmax(0.0, x));
    return x * x * (3.0 - 2.0 * x);
}

int studio_lamp_holds(const struct studio_lamp *lamp, brdf_vec3 w)
{
    return (double)brdf_dot(lamp->frame.n, w) > lamp->cosine;
}

double studio_lamp_light(const struct studio_lamp *lamp, brdf_vec3 w)
{
    if (!studio_lamp_holds(lamp, w)) {
        return 0.0;
    }
    double angle = acos(fmin(1.0, (double)brdf_dot(lamp->frame.n, w)));
    return lamp->radiance * smooth((lamp->angle - angle) / (0.2 * lamp->angle));
}

double studio_sky_light(brdf_vec3 w)
{
    double y = (double)w.y;
    double sky = 0.42 + 0.58 * smooth(y);
    double ground = 0.26 - 0.16 * smooth(-2.0 * y);
    return ground + (sky - ground) * smooth(0.5 + 8.0 * y); /* no knife's edge between them */
}

brdf_vec3 studio_lamp_sample(const struct studio_lamp *lamp, double u, double v)
{
    double z = 1.0 - u * (1.0 - lamp->cosine);
    double r = sqrt(fmax(0.0, 1.0 - z * z));
    double phi = 2.0 * pi * v;
    return brdf_to_world(lamp->frame,
                         brdf_vec3_make((float)(r * cos(phi)), (float)(r * sin(phi)), (float)z));
}
