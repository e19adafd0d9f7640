/*
 * rgl_spectrum.c - spectral measurements as linear Rec. 709.
 *
 * Data, both as published by the CIE: colour matching functions of the 1931 2-degree observer
 * (ISO/CIE 11664-1, every 5 nm of the table of 1 nm steps) and the standard illuminant D65 (ISO/CIE
 * 11664-2, every 10 nm, between which it is defined to be linear). Matrix from the chromaticities
 * of ITU-R BT.709-6, section 1.3 and 1.4.
 */
#include "rgl_format.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST = 360, LAST = 830, OBSERVER_STEP = 5, DAYLIGHT_STEP = 10 };

static const float observer[(LAST - FIRST) / OBSERVER_STEP + 1][3] = {
    {0.0001299f, 3.917e-06f, 0.0006061f},
    {0.0002321f, 6.965e-06f, 0.001086f},
    {0.0004149f, 1.239e-05f, 0.001946f},
    {0.0007416f, 2.202e-05f, 0.003486f},
    {0.001368f, 3.9e-05f, 0.00645f},
    {0.002236f, 6.4e-05f, 0.01055f},
    {0.004243f, 0.00012f, 0.02005f},
    {0.00765f, 0.000217f, 0.03621f},
    {0.01431f, 0.000396f, 0.06785f},
    {0.02319f, 0.00064f, 0.1102f},
    {0.04351f, 0.00121f, 0.2074f},
    {0.07763f, 0.00218f, 0.3713f},
    {0.13438f, 0.004f, 0.6456f},
    {0.21477f, 0.0073f, 1.03905f},
    {0.2839f, 0.0116f, 1.3856f},
    {0.3285f, 0.01684f, 1.62296f},
    {0.34828f, 0.023f, 1.74706f},
    {0.34806f, 0.0298f, 1.7826f},
    {0.3362f, 0.038f, 1.77211f},
    {0.3187f, 0.048f, 1.7441f},
    {0.2908f, 0.06f, 1.6692f},
    {0.2511f, 0.0739f, 1.5281f},
    {0.19536f, 0.09098f, 1.28764f},
    {0.1421f, 0.1126f, 1.0419f},
    {0.09564f, 0.13902f, 0.81295f},
    {0.05795f, 0.1693f, 0.6162f},
    {0.03201f, 0.20802f, 0.46518f},
    {0.0147f, 0.2586f, 0.3533f},
    {0.0049f, 0.323f, 0.272f},
    {0.0024f, 0.4073f, 0.2123f},
    {0.0093f, 0.503f, 0.1582f},
    {0.0291f, 0.6082f, 0.1117f},
    {0.06327f, 0.71f, 0.07825f},
    {0.1096f, 0.7932f, 0.05725f},
    {0.1655f, 0.862f, 0.04216f},
    {0.22575f, 0.91485f, 0.02984f},
    {0.2904f, 0.954f, 0.0203f},
    {0.3597f, 0.9803f, 0.0134f},
    {0.43345f, 0.99495f, 0.00875f},
    {0.51205f, 1.0f, 0.00575f},
    {0.5945f, 0.995f, 0.0039f},
    {0.6784f, 0.9786f, 0.00275f},
    {0.7621f, 0.952f, 0.0021f},
    {0.8425f, 0.9154f, 0.0018f},
    {0.9163f, 0.87f, 0.00165f},
    {0.9786f, 0.8163f, 0.0014f},
    {1.0263f, 0.757f, 0.0011f},
    {1.0567f, 0.6949f, 0.001f},
    {1.0622f, 0.631f, 0.0008f},
    {1.0456f, 0.5668f, 0.0006f},
    {1.0026f, 0.503f, 0.00034f},
    {0.9384f, 0.4412f, 0.00024f},
    {0.85445f, 0.381f, 0.00019f},
    {0.7514f, 0.321f, 0.0001f},
    {0.6424f, 0.265f, 5e-05f},
    {0.5419f, 0.217f, 3e-05f},
    {0.4479f, 0.175f, 2e-05f},
    {0.3608f, 0.1382f, 1e-05f},
    {0.2835f, 0.107f, 0.0f},
    {0.2187f, 0.0816f, 0.0f},
    {0.1649f, 0.061f, 0.0f},
    {0.1212f, 0.04458f, 0.0f},
    {0.0874f, 0.032f, 0.0f},
    {0.0636f, 0.0232f, 0.0f},
    {0.04677f, 0.017f, 0.0f},
    {0.0329f, 0.01192f, 0.0f},
    {0.0227f, 0.00821f, 0.0f},
    {0.01584f, 0.005723f, 0.0f},
    {0.0113592f, 0.004102f, 0.0f},
    {0.00811092f, 0.002929f, 0.0f},
    {0.00579035f, 0.002091f, 0.0f},
    {0.00410946f, 0.001484f, 0.0f},
    {0.00289933f, 0.001047f, 0.0f},
    {0.00204919f, 0.00074f, 0.0f},
    {0.00143997f, 0.00052f, 0.0f},
    {0.000999949f, 0.0003611f, 0.0f},
    {0.000690079f, 0.0002492f, 0.0f},
    {0.000476021f, 0.0001719f, 0.0f},
    {0.000332301f, 0.00012f, 0.0f},
    {0.000234826f, 8.48e-05f, 0.0f},
    {0.000166151f, 6e-05f, 0.0f},
    {0.000117413f, 4.24e-05f, 0.0f},
    {8.30753e-05f, 3e-05f, 0.0f},
    {5.87065e-05f, 2.12e-05f, 0.0f},
    {4.15099e-05f, 1.499e-05f, 0.0f},
    {2.93533e-05f, 1.06e-05f, 0.0f},
    {2.06738e-05f, 7.4657e-06f, 0.0f},
    {1.45598e-05f, 5.2578e-06f, 0.0f},
    {1.0254e-05f, 3.7029e-06f, 0.0f},
    {7.22146e-06f, 2.6078e-06f, 0.0f},
    {5.08587e-06f, 1.8366e-06f, 0.0f},
    {3.58165e-06f, 1.2934e-06f, 0.0f},
    {2.52253e-06f, 9.1093e-07f, 0.0f},
    {1.77651e-06f, 6.4153e-07f, 0.0f},
    {1.25114e-06f, 4.5181e-07f, 0.0f},
};

static const float daylight[] = {
    46.6383f, 52.0891f, 49.9755f, 54.6482f, 82.7549f, 91.486f,  93.4318f, 86.6823f,
    104.865f, 117.008f, 117.812f, 114.861f, 115.923f, 108.811f, 109.354f, 107.802f,
    104.79f,  107.689f, 104.405f, 104.046f, 100.0f,   96.3342f, 95.788f,  88.6856f,
    90.0062f, 89.5991f, 87.6987f, 83.2886f, 83.6992f, 80.0268f, 80.2146f, 82.2778f,
    78.2842f, 69.7213f, 71.6091f, 74.349f,  61.604f,  69.8856f, 75.087f,  63.5927f,
    46.4182f, 66.8054f, 63.3828f, 64.304f,  59.4519f, 51.959f,  57.4406f, 60.3125f,
};

static const double rgb_of_xyz[3][3] = {
    {3.2409699419, -1.5373831776, -0.4986107603},
    {-0.9692436363, 1.8759675015, 0.0415550574},
    {0.0556300797, -0.2039769589, 1.0569715142},
};

/* Illuminant times observer, in linear Rec. 709 up to a factor. */
static void light_at(double nanometre, double rgb[3])
{
    double place = (nanometre - FIRST) / OBSERVER_STEP;
    int low =
        place < (LAST - FIRST) / OBSERVER_STEP ? (int)place : (LAST - FIRST) / OBSERVER_STEP - 1;
    double t = place - low;
    double day_place = (nanometre - FIRST) / DAYLIGHT_STEP;
    int day = day_place < (LAST - FIRST) / DAYLIGHT_STEP ? (int)day_place
                                                         : (LAST - FIRST) / DAYLIGHT_STEP - 1;
    double u = day_place - day;
    double power = (1.0 - u) * (double)daylight[day] + u * (double)daylight[day + 1];
    for (int i = 0; i < 3; ++i) {
        rgb[i] = 0.0;
        for (int k = 0; k < 3; ++k) {
            double xyz = (1.0 - t) * (double)observer[low][k] + t * (double)observer[low + 1][k];
            rgb[i] += rgb_of_xyz[i][k] * power * xyz;
        }
    }
}

/*
 * How much each wavelength of the file counts for each colour: the light at every nanometre goes
 * to the two wavelengths around it. Each colour adds up to 1, so white stays white.
 */
void brdf_rgl_weights_find(const struct brdf_rgl_file *file, double (*weights)[3])
{
    double sum[3] = {0.0, 0.0, 0.0};
    int next = 0; /* the first wavelength above */
    memset(weights, 0, (size_t)file->channels * sizeof *weights);
    if (!file->wavelengths) {
        for (int i = 0; i < 3; ++i) {
            weights[i][i] = 1.0;
        }
        return;
    }
    for (int nanometre = FIRST; nanometre <= LAST; ++nanometre) {
        double light[3];
        light_at(nanometre, light);
        while (next < file->channels && (double)file->wavelengths[next] <= nanometre) {
            ++next;
        }
        int low = next > 0 ? next - 1 : 0;
        int high = next < file->channels ? next : file->channels - 1;
        double width = (double)file->wavelengths[high] - (double)file->wavelengths[low];
        double t = low < high ? (nanometre - (double)file->wavelengths[low]) / width : 0.0;
        for (int i = 0; i < 3; ++i) {
            weights[low][i] += (1.0 - t) * light[i];
            weights[high][i] += t * light[i];
            sum[i] += light[i];
        }
    }
    for (int channel = 0; channel < file->channels; ++channel) {
        for (int i = 0; i < 3; ++i) {
            weights[channel][i] /= sum[i];
        }
    }
}

static void view_reduce(const struct brdf_rgl_file *file, double (*weights)[3],
                        const float *spectra, float *rgb)
{
    size_t nodes = (size_t)file->size * (size_t)file->size;
    for (size_t node = 0; node < nodes; ++node) {
        double sum[3] = {0.0, 0.0, 0.0};
        for (int channel = 0; channel < file->channels; ++channel) {
            double value = (double)spectra[(size_t)channel * nodes + node];
            for (int i = 0; i < 3; ++i) {
                sum[i] += weights[channel][i] * value;
            }
        }
        for (size_t i = 0; i < 3; ++i) {
            rgb[i * nodes + node] = (float)sum[i];
        }
    }
}

brdf_status brdf_rgl_to_rgb(struct brdf_rgl_file *file, struct brdf_error *error)
{
    if (!file || !file->values) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT, "brdf_rgl_to_rgb needs a file with values");
    }
    if (!file->wavelengths) {
        return BRDF_OK;
    }
    size_t views = (size_t)file->phi_count * (size_t)file->theta_count;
    size_t nodes = (size_t)file->size * (size_t)file->size;
    double(*weights)[3] = malloc((size_t)file->channels * sizeof *weights);
    float *rgb = malloc(views * 3 * nodes * sizeof *rgb);
    if (!weights || !rgb) {
        free(weights);
        free(rgb);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for the colours of %zu views",
                         views);
    }
    brdf_rgl_weights_find(file, weights);
    for (size_t view = 0; view < views; ++view) {
        view_reduce(file, weights, file->values + view * (size_t)file->channels * nodes,
                    rgb + view * 3 * nodes);
    }
    free(weights);
    free(file->values);
    free(file->wavelengths);
    file->values = rgb;
    file->wavelengths = NULL;
    file->channels = 3;
    return BRDF_OK;
}
