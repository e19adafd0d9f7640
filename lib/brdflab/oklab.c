/* oklab.c - to Oklab and back; the matrices are Ottosson's. */
#include "oklab.h"

#include <math.h>

enum { HALVINGS = 24 };

static void multiply(const double m[3][3], const double in[3], double out[3])
{
    for (int i = 0; i < 3; ++i) {
        out[i] = m[i][0] * in[0] + m[i][1] * in[1] + m[i][2] * in[2];
    }
}

static void from_rgb(const double rgb[3], double lab[3])
{
    static const double to_cones[3][3] = {{0.4122214708, 0.5363325363, 0.0514459929},
                                          {0.2119034982, 0.6806995451, 0.1073969566},
                                          {0.0883024619, 0.2817188376, 0.6299787005}};
    static const double to_lab[3][3] = {{0.2104542553, 0.7936177850, -0.0040720468},
                                        {1.9779984951, -2.4285922050, 0.4505937099},
                                        {0.0259040371, 0.7827717662, -0.8086757660}};
    double cones[3];
    multiply(to_cones, rgb, cones);
    for (int i = 0; i < 3; ++i) {
        cones[i] = cbrt(cones[i]);
    }
    multiply(to_lab, cones, lab);
}

static void to_rgb(const double lab[3], double rgb[3])
{
    static const double to_cones[3][3] = {{1.0, 0.3963377774, 0.2158037573},
                                          {1.0, -0.1055613458, -0.0638541728},
                                          {1.0, -0.0894841775, -1.2914855480}};
    static const double from_cones[3][3] = {{4.0767416621, -3.3077115913, 0.2309699292},
                                            {-1.2684380046, 2.6097574011, -0.3413193965},
                                            {-0.0041960863, -0.7034186147, 1.7076147010}};
    double cones[3];
    multiply(to_cones, lab, cones);
    for (int i = 0; i < 3; ++i) {
        cones[i] = cones[i] * cones[i] * cones[i];
    }
    multiply(from_cones, cones, rgb);
}

static int is_shown(const double rgb[3])
{
    return rgb[0] >= 0.0 && rgb[1] >= 0.0 && rgb[2] >= 0.0;
}

void lab_color_change(double rgb[3], double hue, double saturation)
{
    double lab[3];
    from_rgb(rgb, lab);
    double a = saturation * (lab[1] * cos(hue) - lab[2] * sin(hue));
    double b = saturation * (lab[1] * sin(hue) + lab[2] * cos(hue));
    double low = 0.0, high = 1.0, share = 1.0; /* of the chroma wanted; gray can always be shown */
    for (int i = 0; i < HALVINGS; ++i) {
        const double wanted[3] = {lab[0], share * a, share * b};
        to_rgb(wanted, rgb);
        int shown = is_shown(rgb);
        if (shown && share == 1.0) {
            break;
        }
        low = shown ? share : low;
        high = shown ? high : share;
        share = 0.5 * (low + high);
    }
    for (int i = 0; i < 3; ++i) {
        rgb[i] = rgb[i] > 0.0 ? rgb[i] : 0.0; /* what the last halving left */
    }
}
