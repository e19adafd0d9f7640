"""brdfcl and Mitsuba 3 asked for the same values of a material: for compare.py."""

import json
import os
import subprocess

import drjit as dr
import mitsuba as mi
import numpy as np

ALBEDO_SAMPLES = 1 << 17
SHARED_SAMPLES = 1 << 14


class Ours:
    def __init__(self, command, folder):
        self.command = command
        self.folder = folder

    def run(self, *arguments):
        done = subprocess.run([self.command, *arguments], capture_output=True, text=True, check=False)
        if done.returncode:
            raise RuntimeError(done.stderr)
        return done.stdout

    def values(self, material, wo, wi):
        path = os.path.join(self.folder, "pairs.csv")
        np.savetxt(path, np.hstack([wo, wi]), fmt="%.9g", delimiter=",")
        out = self.run("eval", material.description, "--directions", path)
        rows = np.array([line.split(",") for line in out.splitlines()[1:]], dtype=np.float64)
        return rows[:, :3], rows[:, 3]

    def samples(self, material, wo):
        """Directions that are not deltas, with weight = f cos / pdf and pdf."""
        theta, phi = np.degrees(np.arccos(wo[2])), np.degrees(np.arctan2(wo[1], wo[0]))
        out = self.run("sample", material.description, "--wo", f"{theta:.9g},{phi:.9g}",
                       "--count", str(SHARED_SAMPLES))
        rows = np.array([line.split(",") for line in out.splitlines()[1:]], dtype=np.float64)
        rows = rows[(rows[:, 11] > 0.0) & (rows[:, 13] == 0.0)]
        return np.float32(rows[:, 3:6]), rows[:, 8:11], rows[:, 11]

    def albedo(self, material, cosine):
        inside = ["--inside"] if cosine < 0.0 else []
        theta = np.degrees(np.arccos(abs(cosine)))
        out = json.loads(self.run("albedo", material.description, "--theta", f"{theta:.9g}", *inside,
                                  "--samples", str(ALBEDO_SAMPLES), "--json", "-"))
        row = out["albedo"][0]
        return np.array(row["reflection"] + row["transmission"]), row["error"]


def interaction(wo):
    si = mi.SurfaceInteraction3f()
    si.t = 0.0
    si.wi = mi.Vector3f(wo.T)
    si.p = mi.Point3f(0.0)
    si.n = mi.Normal3f(0.0, 0.0, 1.0)
    si.sh_frame = mi.Frame3f(mi.Vector3f(0.0, 0.0, 1.0))
    si.uv = mi.Point2f(0.5)
    return si


class Theirs:
    def __init__(self, material):
        self.bsdf = mi.load_dict(material.dictionary)
        self.context = mi.BSDFContext()
        self.transmits = mi.has_flag(self.bsdf.flags(), mi.BSDFFlags.Transmission)

    def values(self, _, wo, wi):
        si = interaction(wo)
        f = np.array(self.bsdf.eval(self.context, si, mi.Vector3f(wi.T))).reshape(3, -1).T
        pdf = np.array(self.bsdf.pdf(self.context, si, mi.Vector3f(wi.T)))
        return np.float64(f) / np.abs(np.float64(wi[:, 2:])), np.float64(pdf) + np.zeros(len(wo))

    def albedo(self, material, cosine, correct):
        """By so many samples of theirs; transmission as power, and the standard error."""
        count = ALBEDO_SAMPLES
        wo = np.zeros((count, 3), np.float32)
        wo[:, 0], wo[:, 2] = np.sqrt(1.0 - cosine * cosine), cosine
        i = dr.arange(mi.UInt32, count)
        jitter = mi.PCG32(size=count)
        u = mi.Point2f((mi.Float(i) + jitter.next_float32()) / count, jitter.next_float32())
        sample, weight = self.bsdf.sample(self.context, interaction(wo), jitter.next_float32(), u)
        weight = correct(material, np.float64(np.array(weight).reshape(3, -1).T))
        through = np.array(sample.wo)[2] * cosine < 0.0
        weight *= np.where(through, np.float64(np.array(sample.eta)) ** 2, 1.0)[:, None]
        weight[~np.isfinite(weight)] = 0.0
        both = np.hstack([weight * ~through[:, None], weight * through[:, None]])
        return both.mean(0), both.std(0).max() / np.sqrt(count)
