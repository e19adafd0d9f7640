"""Render scenes with brdfcl and with Mitsuba 3 in turns: the same picture, and how fast.

Started by peers.sh, which prepares what it needs. Exit status 1 where the pictures differ by more
than noise: then the times mean nothing.
"""

import argparse
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile
import time

import drjit as dr
import mitsuba as mi
import numpy as np

VARIANT = "llvm_ad_rgb"
BLOCK = 16  # pixels; a block's mean is one thing to compare
BATCHES = 8  # renders of each, with other seeds, that tell what the noise is


class Ours:
    """A process for each picture, as a user would start it."""

    name = "brdfcl"

    def __init__(self, command, scene, folder):
        self.command = command
        self.scene = scene
        self.exr = os.path.join(folder, "ours.exr")
        self.json = os.path.join(folder, "ours.json")
        self.report = {}

    def render(self, spp, seed):
        """Seconds of rendering, and of the whole process."""
        begin = time.perf_counter()
        subprocess.run(
            [self.command, "render", self.scene, "-o", self.exr, "--float", "--json", self.json,
             "--spp", str(spp), "--seed", str(seed), "--quiet"], check=True)
        whole = time.perf_counter() - begin
        with open(self.json, encoding="utf-8") as file:
            self.report = json.load(file)
        return self.report["seconds_render"], whole

    def picture(self):
        return np.array(mi.Bitmap(self.exr))[..., :3].astype(np.float64)


class Mitsuba:
    """Its own process stays: only the render is timed, its kernels compiled before."""

    name = "Mitsuba " + mi.__version__ + " " + VARIANT

    def __init__(self, scene):
        self.scene = mi.load_file(scene)
        self.image = None

    def render(self, spp, seed):
        begin = time.perf_counter()
        self.image = mi.render(self.scene, spp=spp, seed=seed)
        dr.eval(self.image)
        dr.sync_thread()
        seconds = time.perf_counter() - begin
        return seconds, seconds

    def picture(self):
        return np.array(self.image)[..., :3].astype(np.float64)


def block_means(picture):
    height, width, _ = picture.shape
    side = max(1, min(BLOCK, height // 8, width // 8))
    rows, columns = height // side, width // side
    cut = picture[: rows * side, : columns * side]
    return cut.reshape(rows, side, columns, side, 3).mean((1, 3))


def compare(renderers, spp):
    """Means of both, and how far their blocks differ in units of their own noise."""
    means = []
    for renderer in renderers:
        batches = []
        for seed in range(BATCHES):
            renderer.render(spp, 1000 + seed)
            batches.append(block_means(renderer.picture()))
        means.append(np.array(batches))
    difference = means[0].mean(0) - means[1].mean(0)
    variance = (means[0].var(0, ddof=1) + means[1].var(0, ddof=1)) / BATCHES
    # What both agree on without noise (black, a light seen directly) agrees to rounding.
    floor = (2e-5 * np.abs(means[1].mean(0))) ** 2 + 1e-14
    z2 = difference**2 / np.maximum(variance, floor)
    freedom = 2 * BATCHES - 2  # the variances are estimates: Student's t, not a normal
    overall = means[0].mean((1, 2, 3)), means[1].mean((1, 2, 3))
    noise = np.sqrt((overall[0].var(ddof=1) + overall[1].var(ddof=1)) / BATCHES)
    result = {
        "mean_ours": float(overall[0].mean()),
        "mean_mitsuba": float(overall[1].mean()),
        "mean_z": float((overall[0].mean() - overall[1].mean()) / max(noise, 1e-12)),
        "blocks": int(z2.size),
        "block_chi2": float(z2.mean() * (freedom - 2) / freedom),
        "blocks_beyond_5": float((z2 > 25.0).mean()),
        "noise_of_blocks": float(np.sqrt(variance).mean() / max(overall[1].mean(), 1e-12)),
    }
    result["same"] = bool(abs(result["mean_z"]) < 5.0 and result["block_chi2"] < 1.5
                          and result["blocks_beyond_5"] < 0.01)
    return result


def in_turns(renderers, rounds, spp):
    """Seconds of each round, after one of each that does not count."""
    seconds = [[], []]
    whole = [[], []]
    for round_number in range(rounds + 1):
        for i, renderer in enumerate(renderers):
            render, process = renderer.render(spp, round_number)
            if round_number > 0:
                seconds[i].append(render)
                whole[i].append(process)
    return seconds, whole


def samples_of(scene, given):
    """How many samples a pixel: as asked for, or as the file says."""
    if given:
        return given
    return int(mi.load_file(scene).sensors()[0].sampler().sample_count())


def measure(scene, options, folder):
    spp = samples_of(scene, options.spp)
    renderers = [Ours(options.brdfcl, scene, folder), Mitsuba(scene)]
    print(f"{scene}: comparing the pictures ...", flush=True)
    picture = compare(renderers, max(1, spp // 4))
    seconds, whole = in_turns(renderers, options.rounds, spp)
    report = renderers[0].report
    samples = report["width"] * report["height"] * spp
    rate = [[samples / s for s in of_one] for of_one in seconds]
    ours, theirs = statistics.median(rate[0]), statistics.median(rate[1])
    result = {
        "scene": scene, "width": report["width"], "height": report["height"], "spp": spp,
        "depth": report["depth"], "rounds": options.rounds, "picture": picture,
        "ours": {"samples_per_second": ours, "rounds": rate[0], "device": report["device"],
                 "lanes": report["lanes"], "peak_rss_bytes": report["peak_rss_bytes"],
                 "samples_per_second_of_process": samples / statistics.median(whole[0])},
        "mitsuba": {"samples_per_second": theirs, "rounds": rate[1]},
        "ratio": ours / theirs,
        "ratio_each_round": [a / b for a, b in zip(rate[0], rate[1])],
    }
    show(result, renderers)
    return result


def show(result, renderers):
    picture = result["picture"]
    print(f"  {result['width']} x {result['height']}, {result['spp']} samples, "
          f"{result['rounds']} rounds in turns; M samples/s")
    print(f"  {'':32} {'median':>8} {'least':>8} {'most':>8}")
    for renderer, key in zip(renderers, ("ours", "mitsuba")):
        rounds = result[key]["rounds"]
        print(f"  {renderer.name:32} {statistics.median(rounds) / 1e6:8.3f} "
              f"{min(rounds) / 1e6:8.3f} {max(rounds) / 1e6:8.3f}")
    whole = result["ours"]["samples_per_second_of_process"]
    print(f"  {'brdfcl, the whole process':32} {whole / 1e6:8.3f}")
    ratios = result["ratio_each_round"]
    print(f"  ratio {result['ratio']:.2f} (of single rounds: {min(ratios):.2f} to {max(ratios):.2f})")
    verdict = "the same picture within noise" if picture["same"] else "NOT THE SAME PICTURE"
    print(f"  {verdict}: means {picture['mean_ours']:.6f} and {picture['mean_mitsuba']:.6f} "
          f"(z = {picture['mean_z']:.1f}), chi2 of {picture['blocks']} blocks {picture['block_chi2']:.2f} "
          f"(1: noise; a block's noise is {100 * picture['noise_of_blocks']:.2f} %)", flush=True)


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return re.search(r"model name\s*:\s*(.*)", file.read()).group(1)
    except (OSError, AttributeError):
        return platform.processor()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scene", nargs="*", default=["scenes/cornell.xml"])
    parser.add_argument("--rounds", type=int, default=5, help="that count, of each [5]")
    parser.add_argument("--spp", type=int, default=0, help="samples a pixel [as the scene says]")
    parser.add_argument("--json", default=os.path.join(os.environ.get("BUILD", "build"), "peers.json"))
    parser.add_argument("--brdfcl", default=os.environ.get("BRDFCL", "build/brdfcl"))
    options = parser.parse_args()
    options.brdfcl = os.path.abspath(options.brdfcl)
    mi.set_variant(VARIANT)
    mi.set_log_level(mi.LogLevel.Error)
    llvm = os.path.realpath(os.environ.get("DRJIT_LIBLLVM_PATH", "?"))
    version = subprocess.run([options.brdfcl, "--version"], capture_output=True, text=True,
                             check=False).stdout.strip()
    result = {"processor": processor(), "cores": os.cpu_count(), "brdfcl": version,
              "mitsuba": mi.__version__, "drjit": dr.__version__, "variant": VARIANT, "llvm": llvm}
    print(f"{result['processor']}, {result['cores']} cores; {version}; Mitsuba {mi.__version__} "
          f"{VARIANT}, Dr.Jit {dr.__version__}, {os.path.basename(llvm)}")
    with tempfile.TemporaryDirectory() as folder:
        result["scenes"] = [measure(scene, options, folder) for scene in options.scene]
    result["device"] = result["scenes"][0]["ours"]["device"]
    with open(options.json, "w", encoding="utf-8") as file:
        json.dump(result, file, indent=2)
        file.write("\n")
    print(f"{options.json} holds all of it")
    return 0 if all(scene["picture"]["same"] for scene in result["scenes"]) else 1


if __name__ == "__main__":
    sys.exit(main())
