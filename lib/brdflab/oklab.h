/*
 * oklab.h - hue and saturation changed, lightness kept.
 *
 * In Oklab [Ottosson, "A perceptual color space for image processing", 2020] lightness, hue and
 * chroma are nearly independent to the eye. Its axes scale with the cube root of light, so turning
 * the hue of a colour and making the colour brighter give the same in either order: highlights far
 * above 1 are changed as their faint borders are.
 */
#ifndef BRDFLAB_OKLAB_H
#define BRDFLAB_OKLAB_H

/*
 * Turn the hue of a linear Rec. 709 colour >= 0 by an angle [rad] and scale its chroma by
 * `saturation` >= 0. Where that leaves what Rec. 709 can show, chroma is reduced until it does not.
 */
void lab_color_change(double rgb[3], double hue, double saturation);

#endif
