#!/usr/bin/env python3
"""fit_coating.py - makes include/brdf/coating_fit.h: what a rough dielectric interface lets through.

Usage: fit_coating.py > include/brdf/coating_fit.h   (needs numpy; takes some minutes)

Computes, by quadrature over the facets' slopes, the single-scattering transmittance T(mu) of an
interface from its thinner side, and the part K of diffuse light that it reflects from its denser
side; separable masking of Smith. Then fits polynomials; coating.h evaluates them and says in what.
"""
from math import sqrt
import sys

import numpy as np
from numpy.polynomial.chebyshev import chebvander
from numpy.polynomial.legendre import leggauss

from facets import albedo, fit, fresnel, monomials, nodes, show

T_LOW, T_HIGH = 1 / 21, 3 / 7  # (eta - 1) / (eta + 1) of eta = 1.1 and 2.5
DEGREE_T = (10, 14, 5)  # in x, y, z; terms with i / 10 + j / 14 + k / 5 <= 1.5
DEGREE_K = (8, 4)


def internal_mean(distribution, alpha, eta):
    """K; the integral over cosines is cut where total reflection begins."""
    v, w = leggauss(20)
    v, w = (v + 1) / 2, w / 2
    cut = sqrt(1 - 1 / eta**2)
    mu = np.concatenate([cut * (1 - (1 - v) ** 2), cut + (1 - cut) * v * v])
    w = np.concatenate([cut * w * 2 * (1 - v), (1 - cut) * w * 2 * v])
    return np.sum(2 * w * mu * albedo(distribution, "separable", alpha, mu, 64, 40, 1 / eta)[0])


def errors(difference):
    return np.abs(difference).max(), np.sqrt((difference**2).mean())


def row_length(i, k):
    """How many powers of y go with x^i z^k; coating.h has the same rule."""
    return max(min(14, (105 - 7 * i - 14 * k) // 5) + 1, 0)


def fit_transmittance(distribution):
    x, y, z = np.meshgrid(nodes(17), nodes(26), nodes(8), indexing="ij")
    alpha = np.maximum(2 * y * y, 1e-4)
    t = (sqrt(T_LOW) + (sqrt(T_HIGH) - sqrt(T_LOW)) * z) ** 2
    eta = (1 + t) / (1 - t)
    a2 = 2 * alpha**2
    mu = np.maximum(np.sqrt(a2) * x / np.sqrt(1 - x * x + a2 * x * x), 1e-7)
    value = np.empty_like(x)
    for j in range(x.shape[1]):
        for k in range(x.shape[2]):
            value[:, j, k] = albedo(distribution, "separable", alpha[0, j, k], mu[:, j, k],
                                    48, 32, eta[0, j, k])[1]
    mean_cos = np.sqrt((mu**2 + 3 * alpha**2) / (1 + 3 * alpha**2))
    factor = 1 - fresnel(mean_cos, eta)[0]
    terms = [(i, j, k) for i in range(11) for k in range(6) for j in range(row_length(i, k))]
    v = [chebvander(2 * q.ravel() - 1, n) for q, n in zip((x, y, z), DEGREE_T)]
    matrix = np.stack([v[0][:, i] * v[1][:, j] * v[2][:, k] for i, j, k in terms], 1)
    matrix *= factor.ravel()[:, None]
    c = fit(matrix, value.ravel(), np.ones(value.size), 5)
    worst, rms = errors(matrix @ c - value.ravel())
    grid = np.zeros([n + 1 for n in DEGREE_T])
    for term, number in zip(terms, c):
        grid[term] = number
    grid = monomials(grid)
    return worst, rms, [grid[i, j, k] for i, j, k in terms]


def fit_internal(distribution):
    y, z = np.meshgrid(nodes(24), nodes(7), indexing="ij")
    t = (sqrt(T_LOW) + (sqrt(T_HIGH) - sqrt(T_LOW)) * z) ** 2
    value = [internal_mean(distribution, max(2 * b * b, 1e-4), (1 + c) / (1 - c))
             for b, c in zip(y.ravel(), t.ravel())]
    v = [chebvander(2 * q.ravel() - 1, n) for q, n in zip((y, z), DEGREE_K)]
    matrix = (v[0][:, :, None] * v[1][:, None, :]).reshape(y.size, -1)
    c = fit(matrix, np.array(value), np.ones(len(value)), 4)
    worst, rms = errors(matrix @ c - value)
    return worst, rms, list(monomials(c.reshape(9, 5)).T.ravel())


def main():
    print("/*\n * coating_fit.h - numbers of coating.h, made by tools/fit_coating.py; nothing to read"
          ".\n */\n/* clang-format off */\n#ifndef BRDF_COATING_FIT_H\n#define BRDF_COATING_FIT_H\n\n"
          "#include \"dialect.h\"")
    for name in ("beckmann", "ggx"):
        for what, (worst, rms, numbers) in (("pass", fit_transmittance(name)),
                                            ("inside", fit_internal(name))):
            print(f"{name} {what}: worst {worst:.1e}, rms {rms:.1e}", file=sys.stderr)
            show(f"brdf_coating_{what}_{name}", numbers)
    print("\n#endif")


main()
