"""facets.py - microfacets by quadrature, for the tools that fit them: normals, masking, albedos.

Directions lie in the plane y = 0, so that the normals of half the circle do.
"""
import os

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(name, "1")  # the matrices are small

from math import erf, pi, sqrt

import numpy as np
from numpy.polynomial.chebyshev import cheb2poly
from numpy.polynomial.legendre import leggauss

ERF_PLACES = np.linspace(0, 6, 60001)
ERF_VALUES = np.vectorize(erf)(ERF_PLACES)


def fresnel(cosine, eta):
    """Reflectance of a dielectric and the cosine behind it; eta is far over near."""
    sin2 = (1 - cosine * cosine) / (eta * eta)
    cos_t = np.sqrt(np.maximum(1 - sin2, 0))
    p = (eta * cosine - cos_t) / np.maximum(eta * cosine + cos_t, 1e-300)
    s = (cosine - eta * cos_t) / np.maximum(cosine + eta * cos_t, 1e-300)
    total = (sin2 >= 1) | (cosine <= 0)
    return np.where(total, 1.0, 0.5 * (p * p + s * s)), cos_t


def normals(distribution, alpha, rings, spokes):
    """Nodes and weights over D cos: x, y, z and weight."""
    v, w = leggauss(rings)
    v, w = (v + 1) / 2, w / 2
    u, w = 1 - (1 - v) ** 2, w * 2 * (1 - v)
    slope = {
        "beckmann": lambda: alpha * np.sqrt(-np.log(1 - u)),
        "ggx": lambda: alpha * np.sqrt(u / (1 - u)),
        "blinn": lambda: np.sqrt(np.expm1(-alpha**2 * np.log(1 - u))),
    }[distribution]()
    angle = (np.arange(spokes) + 0.5) / spokes * pi
    r, phi = np.meshgrid(slope, angle, indexing="ij")
    z = 1 / np.sqrt(1 + r * r)
    x, y = -r * np.cos(phi) * z, -r * np.sin(phi) * z
    return x.ravel(), y.ravel(), z.ravel(), np.repeat(w / spokes, spokes)


def area(distribution, masking, z, slope2):
    """Projected area of the facets seen under the cosine z, (alpha sin)^2 being slope2."""
    if distribution == "ggx":
        return 0.5 * (z + np.sqrt(z * z + slope2))
    slope = np.sqrt(slope2)
    s = np.minimum(z / np.maximum(slope, 1e-300), 6)
    if masking == "rational":
        wide = slope * (1 + 2.276 * s + 2.577 * s * s) / (3.535 + 2.181 * s)
        return np.where(s < 1.6, np.maximum(wide, z), z)
    tail = slope * np.exp(-s * s) / (2 * sqrt(pi))
    return np.maximum(0.5 * z * (1 + np.interp(s, ERF_PLACES, ERF_VALUES)) + tail, z)


def visibility(distribution, masking, alpha, mu, iz, lean, oh, hz):
    """G2 / (mu iz); `lean` is 1 - iz^2."""
    if masking == "vcavity":
        return np.minimum(1 / np.minimum(iz, mu), 2 * hz / oh) / np.maximum(iz, mu)
    ao = area(distribution, masking, mu, alpha**2 * (1 - mu * mu))
    ai = area(distribution, masking, iz, alpha**2 * lean)
    return 1 / (mu * ai + iz * ao - mu * iz) if masking == "correlated" else 1 / (ao * ai)


def albedo(distribution, masking, alpha, cosines, rings, spokes, eta=None):
    """What one facet sends on of light under each cosine: reflected, and let through.

    eta is the index of the far side over that of the near side; None stands for mirrors.
    """
    hx, hy, hz, weight = normals(distribution, alpha, rings, spokes)
    result = np.zeros((2, len(cosines)))
    for i, mu in enumerate(cosines):
        sine = sqrt(max(1 - mu * mu, 0))
        oh = sine * hx + mu * hz
        arms = [(1.0, 2 * oh * hx - sine, 2 * oh * hy, 2 * oh * hz - mu)]
        if eta is not None:
            f, cos_t = fresnel(np.maximum(oh, 0), eta)
            along = oh / eta - cos_t
            arms = [(f,) + arms[0][1:],
                    (1 - f, along * hx - sine / eta, along * hy, mu / eta - along * hz)]
        for k, (factor, x, y, z) in enumerate(arms):
            good = (oh > 0) & (z > 0)
            iz = np.where(good, z, 1.0)
            seen = iz * visibility(distribution, masking, alpha, mu, iz, x * x + y * y,
                                   np.where(good, oh, 1.0), hz)
            result[k, i] = np.sum(np.where(good, weight * factor * oh / hz * seen, 0))
    return result


def nodes(n):
    """Places in [0, 1], dense at both ends."""
    inner = (1 - np.cos((np.arange(n) + 0.5) / n * pi)) / 2
    return np.concatenate([[0], inner, [1]])


def fit(matrix, values, weights, rounds):
    """Least squares, reweighted towards the smallest maximum of the weighted error."""
    w, best = np.ones(len(values)), None
    for _ in range(rounds):
        both = w * weights
        c = np.linalg.lstsq(matrix * both[:, None], values * both, rcond=1e-13)[0]
        error = np.abs(matrix @ c - values) * weights
        if best is None or error.max() < best[0]:
            best = (error.max(), c)
        w *= np.sqrt(0.1 + error / error.max())
        w /= w.max()
    return best[1]


def monomials(grid):
    """Coefficients of Chebyshev's polynomials along every axis, to those of powers."""
    for axis in range(grid.ndim):
        grid = np.apply_along_axis(lambda v: np.resize(
            np.concatenate([cheb2poly(v), np.zeros(len(v))]), len(v)), axis, grid)
    return grid


def show(name, numbers):
    """The numbers as an array of the dialect."""
    print(f"\nBRDF_CONSTANT float {name}[{len(numbers)}] = {{")
    for i in range(0, len(numbers), 6):
        print("    " + " ".join(f"{v:.8e}f," for v in numbers[i:i + 6]))
    print("};")
