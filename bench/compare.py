"""Compare models with those of the same name in Mitsuba 3: f, pdf and albedo, value by value.

Started by peers.sh, which prepares what it needs. For each row there are some materials with random
parameters, and for each of them random pairs of directions, half of them near the mirror direction. A
difference is relative to the larger of both values; values so small that they change no picture (below
1e-6 of the largest of the material) count as that.

Albedos are compared twice. The integral of f cos: both programs' f at the same directions, which are
samples of ours, so that chance has no part in the difference. And "sampled": the mean weight of each
program's own samples, of which what exceeds four standard errors of both counts; of delta lobes, which have
neither f nor pdf, only this.

Both programs compute with 32 bits. Where a pair differs by more than 1e-4 ("beyond"), both are asked again
at 15 pairs of directions about two units in the last place away: a difference of the medians that is no
larger than what that changes, in both programs together, is rounding. What is left is unexplained, and more
than 1 in 5,000 fails.
"""

import argparse
import os
import sys
import tempfile

import mitsuba as mi
import numpy as np

from compare_materials import (make_conductor, make_dielectric, make_diffuse, make_measured,
                               make_plastic, make_principled, make_roughconductor,
                               make_roughdielectric, make_roughplastic, make_thindielectric,
                               with_exact_mean, without_negative)
from compare_programs import Ours, Theirs

VARIANT = "llvm_ad_rgb"
LIMIT = 1e-4
MOST_UNEXPLAINED = 2e-4  # of the pairs
ALBEDOS = 6  # materials of a row whose albedo is compared


class Row:
    """What to compare: how materials are made, what of them, and how Mitsuba's f is to be seen."""

    def __init__(self, name, make, count=12, what=("f", "pdf", "albedo", "sampled"), correct=None,
                 limit=LIMIT):
        self.name, self.make, self.count, self.what, self.limit = name, make, count, what, limit
        self.correct = correct or (lambda material, values: values)
        self.differences = {"f": np.zeros(0), "pdf": np.zeros(0), "albedo": np.zeros(0),
                            "sampled": np.zeros(0)}
        self.beyond = 0
        self.unexplained = 0
        self.error = 0.0  # four standard errors of the worst sampled albedo, relative
        self.worst = (0.0, "")

    def add(self, what, values):
        self.differences[what] = np.concatenate([self.differences[what], values])

    def pairs(self):
        return len(self.differences["f"])

    def fails(self):
        albedo = np.concatenate([self.differences["albedo"], self.differences["sampled"]])
        return self.unexplained > MOST_UNEXPLAINED * self.pairs() or bool((albedo > LIMIT).any())

    def show(self):
        def of(values, quantiles):
            return " ".join(f"{np.quantile(values, q):8.1e}" if len(values) else f"{'-':>8}"
                            for q in quantiles)
        found = self.differences
        print(f"{self.name:26} {self.pairs():7} {of(found['f'], (0.5, 0.999, 1.0))}  "
              f"{of(found['pdf'], (0.5, 0.999, 1.0))}  {of(found['albedo'], (1.0,))} "
              f"{of(found['sampled'], (1.0,))} {self.beyond:6} {self.unexplained:7}"
              f"{f'  (sampled: to {self.error:.0e})' if self.error else ''}"
              f"{'  DIFFERS' if self.fails() else ''}", flush=True)


# pdf of the plastics is not compared: choosing between coating and base is each program's own. Nor is
# all of roughplastic's f: Mitsuba's masking is separable and its transmittances are tables, ours are
# height-correlated and fits.
def rows():
    return [
        Row("diffuse", make_diffuse, 4),
        Row("conductor", make_conductor, what=("sampled",)),
        Row("dielectric", make_dielectric, what=("sampled",)),
        Row("thindielectric", make_thindielectric, what=("sampled",)),
        Row("roughconductor ggx", make_roughconductor("ggx", "separable")),
        # Mitsuba's masking passes 1 by 6e-5 a direction where its approximation ends; ours is held at 1.
        # It samples the normals of the approximation as if it were exact: its pdf and, by sampling, its
        # albedo are off by that.
        Row("roughconductor beckmann", make_roughconductor("beckmann", "rational"),
            what=("f", "albedo"), limit=1.3e-4),
        Row("roughdielectric ggx", make_roughdielectric("ggx")),
        Row("plastic", make_plastic, what=("f", "albedo"), correct=with_exact_mean),
        Row("principled", make_principled, 24),
        Row("measured", make_measured, 4, correct=without_negative),
    ]


def rows_that_differ():
    return [
        Row("roughconductor exact", make_roughconductor("beckmann", "separable"), 4, ("f", "albedo")),
        Row("roughdielectric beckmann", make_roughdielectric("beckmann"), 4),
        Row("plastic with Mitsuba's fit", make_plastic, 4, ("f", "albedo", "sampled")),
        Row("roughplastic", make_roughplastic, 6, ("f", "albedo", "sampled")),
    ]


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def pairs(random, count, both_sides):
    """wo from anywhere with a cosine above 0.02, wi the same or near the mirror or straight through."""
    z = random.uniform(0.02, 1.0, (2, count))
    phi = random.uniform(0.0, 2.0 * np.pi, (2, count))
    radius = np.sqrt(1.0 - z * z)
    wo, wi = np.stack([radius * np.cos(phi), radius * np.sin(phi), z], -1)
    near = random.random(count) < 0.5
    width = 10.0 ** random.uniform(-2.5, -0.3, (count, 1))
    mirror = np.stack([-wo[:, 0], -wo[:, 1], wo[:, 2]], -1)
    close = unit(mirror + width * unit(random.normal(size=(count, 3))))
    close[:, 2] = np.maximum(np.abs(close[:, 2]), 0.02)
    wi[near] = unit(close)[near]
    if both_sides:
        wo[random.random(count) < 0.5] *= [1.0, 1.0, -1.0]
        wi[random.random(count) < 0.5] *= [1.0, 1.0, -1.0]
    return np.float32(unit(wo)), np.float32(unit(wi))


def apart(ours, theirs):
    """Relative differences, value by value."""
    floor = 1e-6 * max(np.abs(theirs).max(), 1e-30)
    return np.abs(ours - theirs) / np.maximum(np.maximum(np.abs(ours), np.abs(theirs)), floor)


def nearby(random, w):
    """Directions about two units in the last place away."""
    return np.float32(unit(np.float64(w) + random.normal(scale=1.2e-7, size=w.shape)))


def unexplained(row, material, programs, random, wo, wi, suspects):
    """How many of the suspects differ by more than rounding does to either program."""
    if not len(suspects):
        return 0
    wo, wi = np.repeat(wo[suspects], 16, 0), np.repeat(wi[suspects], 16, 0)
    wo[1:], wi[1:] = nearby(random, wo)[1:], nearby(random, wi)[1:]
    count = 0
    values = [[], []]
    for k, program in enumerate(programs):
        f, pdf = program.values(material, wo, wi)
        f = row.correct(material, f) if k else f
        values[k] = np.hstack([f, pdf[:, None]]).reshape(len(suspects), 16, 4)
    for i in range(len(suspects)):
        ours, theirs = values[0][i], values[1][i]
        spread = np.ptp(ours, 0) + np.ptp(theirs, 0)
        gap = np.abs(np.median(ours, 0) - np.median(theirs, 0))
        columns = [c for c, what in enumerate(("f", "f", "f", "pdf")) if what in row.what]
        scale = np.maximum(np.abs(theirs).max(0), 1e-30)
        count += bool(((gap > spread) & (gap > row.limit * scale))[columns].any())
    return count


def compare_values(row, material, programs, random, options):
    theirs = programs[1]
    wo, wi = pairs(random, options.pairs, theirs.transmits)
    f, pdf = programs[0].values(material, wo, wi)
    f_theirs, pdf_theirs = theirs.values(material, wo, wi)
    worst = np.zeros(len(wo))
    for what, a, b in (("f", f, row.correct(material, f_theirs)), ("pdf", pdf, pdf_theirs)):
        if what in row.what:
            found = apart(a, b).reshape(len(wo), -1).max(1)
            row.add(what, found)
            worst = np.maximum(worst, found)
    k = int(worst.argmax())
    if worst[k] > row.worst[0]:
        row.worst = (float(worst[k]), f"{material.description} wo {wo[k]} wi {wi[k]}: f {f[k]} and "
                     f"{f_theirs[k]}, pdf {pdf[k]} and {pdf_theirs[k]}")
    row.beyond += int((worst > LIMIT).sum())
    suspects = np.flatnonzero(worst > row.limit)[:2000]
    row.unexplained += unexplained(row, material, programs, random, wo, wi, suspects)


def compare_integral(row, material, programs, wo):
    """The integral of f cos, relative to its largest channel; nothing where there are but deltas."""
    wi, weight, pdf = programs[0].samples(material, wo)
    if len(wi) == 0:
        return
    f, _ = programs[1].values(material, np.repeat(np.float32(wo)[None], len(wi), 0), wi)
    theirs = row.correct(material, f) * (np.abs(np.float64(wi[:, 2])) / pdf)[:, None]
    row.add("albedo", np.array([np.abs((theirs - weight).sum(0)).max() / weight.sum(0).max()]))


def compare_sampled(row, material, programs, cosine):
    """What chance explains does not count: four standard errors of both."""
    a, error = programs[0].albedo(material, cosine)
    b, error_theirs = programs[1].albedo(material, cosine, row.correct)
    beyond = np.maximum(np.abs(a - b) - 4.0 * np.hypot(error, error_theirs), 0.0)
    row.add("sampled", np.array([beyond.max() / max(b.max(), 1e-3)]))
    row.error = max(row.error, 4.0 * np.hypot(error, error_theirs) / max(b.max(), 1e-3))


def compare_albedo(row, material, programs, random):
    cosine = float(np.float32(random.uniform(0.05, 1.0)))
    cosine = -cosine if programs[1].transmits and random.random() < 0.5 else cosine
    if "albedo" in row.what:
        wo = np.array([np.sqrt(1.0 - cosine * cosine), 0.0, cosine])
        compare_integral(row, material, programs, wo)
    if "sampled" in row.what:
        compare_sampled(row, material, programs, cosine)


def compare(row, ours, options):
    random = np.random.default_rng(options.seed)
    for i in range(row.count):
        material = row.make(random)
        if material is None:
            print(f"{row.name:26} no file to compare: set BRDFCL_DATA")
            return
        programs = ours, Theirs(material)
        if "f" in row.what:
            compare_values(row, material, programs, random, options)
        if i < ALBEDOS:
            compare_albedo(row, material, programs, random)
    row.show()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("row", nargs="*", help="only those that begin so")
    parser.add_argument("--pairs", type=int, default=8192, help="of directions for a material [8192]")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--worst", action="store_true", help="tell for what each row was the worst")
    parser.add_argument("--brdfcl", default=os.environ.get("BRDFCL", "build/brdfcl"))
    options = parser.parse_args()
    options.brdfcl = os.path.abspath(options.brdfcl)
    mi.set_variant(VARIANT)
    mi.set_log_level(mi.LogLevel.Error)
    failed = 0
    print(f"Mitsuba {mi.__version__} {VARIANT}; relative differences: median, 99.9 % and largest")
    with tempfile.TemporaryDirectory() as folder:
        ours = Ours(options.brdfcl, folder)
        for title, some in (("definitions that are the same", rows()),
                            ("definitions that differ, and why docs/validation.md says",
                             rows_that_differ())):
            print(f"\n{title}\n{'':26} {'pairs':>7} {'f':>26}  {'pdf':>26}  {'albedo':>8} "
                  f"{'sampled':>8} {'beyond':>6} unexplained")
            for row in some:
                if options.row and not any(row.name.startswith(name) for name in options.row):
                    continue
                compare(row, ours, options)
                if options.worst and row.worst[0] > 0.0:
                    print("   ", *row.worst)
                failed += row.fails() and some[0].name == "diffuse"
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
