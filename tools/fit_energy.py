#!/usr/bin/env python3
"""fit_energy.py - makes include/brdf/energy_fit.h: what rough mirrors lose.

Usage: fit_energy.py > include/brdf/energy_fit.h   (needs numpy; takes a minute)

Computes, by quadrature, the part of light under each cosine that does not leave after one facet
that reflects everything, and its mean over diffuse light; energy.h says as what both are fitted.
"""
import sys

import numpy as np
from numpy.polynomial.chebyshev import chebvander
from numpy.polynomial.legendre import leggauss

from facets import albedo, fit, monomials, nodes, show

X, Y, MU = 8, 10, 2 # degrees; terms x^i y^j with i / 8 + j / 10 <= 1.5
MEAN, MEAN_LOG = 12, 1
ROWS = [("beckmann", m) for m in ("correlated", "separable", "rational", "vcavity")] + \
       [("ggx", m) for m in ("correlated", "separable", "vcavity")]


def row_length(i):
    """How many powers of y go with x^i; energy.h has the same rule."""
    return min(Y, (120 - 10 * i) // 8) + 1


def y_of(alpha):
    return 3 * alpha / (1 + alpha) - 1


def place(mu, alpha):
    """x in [0, 1] and the decay of the loss towards the normal."""
    a = 4 * alpha**2
    return mu * np.sqrt((1 + a) / (mu * mu + a)), a / (mu * mu + a)


def powers(y, n):
    return np.stack([y**j for j in range(n + 1)], -1)


def loss_fit(distribution, masking):
    v = nodes(28)
    alphas = np.maximum(v / (1.5 - v), 5e-4)
    mu, value = [], []
    for alpha in alphas:
        a = 4 * alpha**2
        x = np.clip(nodes(26), 1e-4, 1)
        mu.append(np.minimum(x * np.sqrt(a / (1 + a - x * x)), 1))
        value.append(1 - albedo(distribution, masking, alpha, mu[-1], 200, 120)[0])
    alpha = np.repeat(alphas, len(mu[0]))
    mu, value = np.concatenate(mu), np.concatenate(value)
    x, decay = place(mu, alpha)
    t, y = chebvander(2 * x - 1, X), chebvander(y_of(alpha), Y)
    log = x * np.log(x)
    columns = [t[:, i] * y[:, j] for i in range(X + 1) for j in range(row_length(i))]
    columns += [log * x**i * y[:, j] for i in range(2) for j in range(Y + 1)]
    columns += [mu ** (i + 1) * y[:, j] for i in range(2) for j in range(MU + 1)]
    weight = np.maximum(decay, 1e-3) ** -0.7
    c = fit(np.stack(columns, 1) * decay[:, None], value, weight, 8)
    error = np.abs(np.stack(columns, 1) @ c * decay - value)
    numbers, at = np.zeros((X + 1, Y + 1)), 0
    for i in range(X + 1):
        numbers[i, :row_length(i)] = c[at:at + row_length(i)]
        at += row_length(i)
    numbers = monomials(numbers)
    flat = [numbers[i, j] for i in range(X + 1) for j in range(row_length(i))]
    for length in (Y + 1, Y + 1, MU + 1, MU + 1):
        flat += list(monomials(c[at:at + length]))
        at += length
    return error.max(), flat


def loss(numbers, mu, alpha):
    """The fit, as energy.h evaluates it."""
    x, decay = place(mu, alpha)
    y, at, total = y_of(alpha), 0, 0
    for i in range(X + 1):
        total = total + (2 * x - 1) ** i * np.polyval(numbers[at:at + row_length(i)][::-1], y)
        at += row_length(i)
    log = x * np.log(np.maximum(x, 1e-6))
    for factor, length in ((log, Y + 1), (log * x, Y + 1), (mu, MU + 1), (mu * mu, MU + 1)):
        total = total + factor * np.polyval(numbers[at:at + length][::-1], y)
        at += length
    return np.clip(total * decay, 0, 1)


def mean_fit(numbers):
    """Of the fit, not of the truth, so that both errors do not add; errors are those of albedos."""
    v, w = leggauss(48)
    alphas = np.exp(np.linspace(np.log(1e-4), np.log(2), 200))
    alphas = np.concatenate([alphas, np.linspace(0.02, 2, 150)])
    value, most = [], []
    for alpha in alphas:
        s = np.log(1 + 1 / (4 * alpha**2))
        u, wu = (v + 1) / 2, w / 2  # nodes by the decay: mu^2 + a = a exp(s u)
        m2 = 4 * alpha**2 * np.expm1(s * u)
        lost = loss(numbers, np.sqrt(m2), alpha)
        value.append(np.sum(wu * lost * s * (m2 + 4 * alpha**2)))
        most.append(lost.max())
    value, most = np.array(value), np.array(most)
    y, log = y_of(alphas), np.log(1 + 1 / (4 * alphas**2))
    scale = alphas**2 / (1 + alphas**2)
    matrix = np.concatenate([chebvander(y, MEAN), chebvander(y, MEAN_LOG) * log[:, None]], 1)
    c = fit(matrix * scale[:, None], value, most / value, 8)
    error = (np.abs(matrix @ c * scale / value - 1) * most).max()
    return error, list(monomials(c[:MEAN + 1])) + list(monomials(c[MEAN + 1:]))


def main():
    print("/*\n * energy_fit.h - numbers of energy.h, made by tools/fit_energy.py; nothing to read."
          "\n */\n/* clang-format off */\n#ifndef BRDF_ENERGY_FIT_H\n#define BRDF_ENERGY_FIT_H\n\n"
          "#include \"dialect.h\"")
    losses, means = [], []
    for row in ROWS:
        worst, numbers = loss_fit(*row)
        relative, mean = mean_fit(numbers)
        print(f"{row}: worst {worst:.1e}, mean {relative:.1e}", file=sys.stderr)
        losses += numbers
        means += mean
    show("brdf_energy_loss_fit", losses)
    show("brdf_energy_mean_fit", means)
    print("\n#endif")


main()
