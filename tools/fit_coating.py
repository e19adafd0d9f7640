#!/usr/bin/env python3
"""fit_coating.py - makes include/brdf/coating_fit.h: what a rough dielectric interface lets through.

Usage: fit_coating.py > include/brdf/coating_fit.h   (needs numpy; takes some minutes)

Computes, by quadrature over the facets' slopes, the single-scattering transmittance T(mu) of an
interface from its thinner side, and the part K of diffuse light that it reflects from its denser
side; separable masking of Smith. Then fits polynomials; coating.h evaluates them and says in what.
"""
from math import erf, pi, sqrt
import sys

import numpy as np
from numpy.polynomial.chebyshev import cheb2poly, chebvander
from numpy.polynomial.legendre import leggauss

T_LOW, T_HIGH = 1 / 21, 3 / 7  # (eta - 1) / (eta + 1) of eta = 1.1 and 2.5
DEGREE_T = (10, 14, 5)  # in x, y, z; terms with i / 10 + j / 14 + k / 5 <= 1.5
DEGREE_K = (8, 4)
ERF_PLACES = np.linspace(0, 6, 60001)
ERF_VALUES = np.vectorize(erf)(ERF_PLACES)


def fresnel(cosine, eta):
    sin2 = (1 - cosine * cosine) / (eta * eta)
    cos_t = np.sqrt(np.maximum(1 - sin2, 0))
    p = (eta * cosine - cos_t) / np.maximum(eta * cosine + cos_t, 1e-300)
    s = (cosine - eta * cos_t) / np.maximum(cosine + eta * cos_t, 1e-300)
    total = (sin2 >= 1) | (cosine <= 0)
    return np.where(total, 1.0, 0.5 * (p * p + s * s)), cos_t


def area(ggx, z, slope2):
    """Projected area of the facets seen under the cosine z, (alpha sin)^2 being slope2."""
    if ggx:
        return 0.5 * (z + np.sqrt(z * z + slope2))
    slope = np.sqrt(slope2)
    a = np.minimum(z / np.maximum(slope, 1e-300), 6)
    tail = slope * np.exp(-a * a) / (2 * sqrt(pi))
    return np.maximum(0.5 * z * (1 + np.interp(a, ERF_PLACES, ERF_VALUES)) + tail, z)


def slopes(ggx, rings, spokes):
    """Nodes and weights over slopes of unit roughness; half of the circle, for symmetry."""
    v, w = leggauss(rings)
    v, w = (v + 1) / 2, w / 2
    u, w = 1 - (1 - v) ** 2, w * 2 * (1 - v)
    radius = np.sqrt(u / (1 - u)) if ggx else np.sqrt(-np.log(1 - u))
    angle = (np.arange(spokes) + 0.5) / spokes * pi
    r, phi = np.meshgrid(radius, angle, indexing="ij")
    return (r * np.cos(phi)).ravel(), (r * np.sin(phi)).ravel(), np.repeat(w / spokes, spokes)


def albedo(ggx, alpha, eta, cosines, passed, rings, spokes):
    """What directions get through the interface (or back from it), by one facet."""
    x, y, weight = slopes(ggx, rings, spokes)
    hz = 1 / np.sqrt(1 + alpha**2 * (x * x + y * y))
    hx, hy = -alpha * x * hz, -alpha * y * hz
    result = np.empty(len(cosines))
    for i, mu in enumerate(cosines):
        sine = sqrt(max(1 - mu * mu, 0))
        oh = sine * hx + mu * hz
        f, cos_t = fresnel(np.maximum(oh, 0), eta)
        if passed:
            along = oh / eta - cos_t
            ix, iy, iz = along * hx - sine / eta, along * hy, mu / eta - along * hz
            f = 1 - f
        else:
            ix, iy, iz = 2 * oh * hx - sine, 2 * oh * hy, 2 * oh * hz - mu
        good = (oh > 0) & (iz > 0)
        iz = np.abs(iz)
        seen = iz / area(ggx, iz, alpha**2 * (ix * ix + iy * iy))
        share = weight * oh / hz / area(ggx, mu, (alpha * sine) ** 2)
        result[i] = np.sum(np.where(good, share * f * seen, 0))
    return result


def internal_mean(ggx, alpha, eta):
    """K; the integral over cosines is cut where total reflection begins."""
    v, w = leggauss(20)
    v, w = (v + 1) / 2, w / 2
    cut = sqrt(1 - 1 / eta**2)
    mu = np.concatenate([cut * (1 - (1 - v) ** 2), cut + (1 - cut) * v * v])
    w = np.concatenate([cut * w * 2 * (1 - v), (1 - cut) * w * 2 * v])
    return np.sum(2 * w * mu * albedo(ggx, alpha, 1 / eta, mu, False, 64, 40))


def unit_nodes(n):
    inner = (1 - np.cos((np.arange(n) + 0.5) / n * pi)) / 2
    return np.concatenate([[0], inner, [1]])


def fit(matrix, values, rounds):
    """Least squares, reweighted towards the smallest maximum of the error."""
    w, best = np.ones(len(values)), None
    for _ in range(rounds):
        c = np.linalg.lstsq(matrix * w[:, None], values * w, rcond=1e-13)[0]
        error = np.abs(matrix @ c - values)
        if best is None or error.max() < best[0]:
            best = (error.max(), np.sqrt((error**2).mean()), c)
        w *= np.sqrt(0.1 + error / error.max())
        w /= w.max()
    return best


def monomials(grid):
    for axis in range(grid.ndim):
        grid = np.apply_along_axis(lambda v: np.resize(
            np.concatenate([cheb2poly(v), np.zeros(len(v))]), len(v)), axis, grid)
    return grid


def row_length(i, k):
    """How many powers of y go with x^i z^k; coating.h has the same rule."""
    return max(min(14, (105 - 7 * i - 14 * k) // 5) + 1, 0)


def fit_transmittance(ggx):
    x, y, z = np.meshgrid(unit_nodes(17), unit_nodes(26), unit_nodes(8), indexing="ij")
    alpha = np.maximum(2 * y * y, 1e-4)
    t = (sqrt(T_LOW) + (sqrt(T_HIGH) - sqrt(T_LOW)) * z) ** 2
    eta = (1 + t) / (1 - t)
    a2 = 2 * alpha**2
    mu = np.maximum(np.sqrt(a2) * x / np.sqrt(1 - x * x + a2 * x * x), 1e-7)
    value = np.empty_like(x)
    for j in range(x.shape[1]):
        for k in range(x.shape[2]):
            value[:, j, k] = albedo(ggx, alpha[0, j, k], eta[0, j, k], mu[:, j, k], True, 48, 32)
    mean_cos = np.sqrt((mu**2 + 3 * alpha**2) / (1 + 3 * alpha**2))
    factor = 1 - fresnel(mean_cos, eta)[0]
    terms = [(i, j, k) for i in range(11) for k in range(6) for j in range(row_length(i, k))]
    v = [chebvander(2 * q.ravel() - 1, n) for q, n in zip((x, y, z), DEGREE_T)]
    matrix = np.stack([v[0][:, i] * v[1][:, j] * v[2][:, k] for i, j, k in terms], 1)
    worst, rms, c = fit(matrix * factor.ravel()[:, None], value.ravel(), 5)
    grid = np.zeros([n + 1 for n in DEGREE_T])
    for term, number in zip(terms, c):
        grid[term] = number
    grid = monomials(grid)
    return worst, rms, [grid[i, j, k] for i, j, k in terms]


def fit_internal(ggx):
    y, z = np.meshgrid(unit_nodes(24), unit_nodes(7), indexing="ij")
    t = (sqrt(T_LOW) + (sqrt(T_HIGH) - sqrt(T_LOW)) * z) ** 2
    value = [internal_mean(ggx, max(2 * b * b, 1e-4), (1 + c) / (1 - c))
             for b, c in zip(y.ravel(), t.ravel())]
    v = [chebvander(2 * q.ravel() - 1, n) for q, n in zip((y, z), DEGREE_K)]
    matrix = (v[0][:, :, None] * v[1][:, None, :]).reshape(y.size, -1)
    worst, rms, c = fit(matrix, np.array(value), 4)
    return worst, rms, list(monomials(c.reshape(9, 5)).T.ravel())


def show(name, numbers):
    print(f"\nBRDF_CONSTANT float {name}[{len(numbers)}] = {{")
    for i in range(0, len(numbers), 6):
        print("    " + " ".join(f"{v:.8e}f," for v in numbers[i:i + 6]))
    print("};")


def main():
    print("/*\n * coating_fit.h - numbers of coating.h, made by tools/fit_coating.py; nothing to read"
          ".\n */\n/* clang-format off */\n#ifndef BRDF_COATING_FIT_H\n#define BRDF_COATING_FIT_H\n\n"
          "#include \"dialect.h\"")
    for ggx, name in ((False, "beckmann"), (True, "ggx")):
        for what, (worst, rms, numbers) in (("pass", fit_transmittance(ggx)),
                                            ("inside", fit_internal(ggx))):
            print(f"{name} {what}: worst {worst:.1e}, rms {rms:.1e}", file=sys.stderr)
            show(f"brdf_coating_{what}_{name}", numbers)
    print("\n#endif")


main()
