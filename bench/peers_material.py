"""Evaluate and sample one material in Mitsuba 3 and in brdfcl's OpenCL in turns: same values, how fast.

Started by peers.sh, which prepares what it needs; for measured files, which both read. Both get the
same directions and random numbers, keep them where they compute, and copy nothing while they are
timed. Exit status 1 where values differ by more than rounding: then the times mean nothing.
"""

import argparse
import ctypes
import json
import multiprocessing
import os
import statistics
import sys
import time

import numpy as np

VARIANT = "llvm_ad_rgb"
OPERATIONS = ("eval", "pdf", "sample")
LIMIT = 1e-3  # for 999 of 1000 values; single ones hang on the last digits of the directions
STANDARD_ERRORS = 5.0  # of what samples weigh on average
TURN = 0.25  # seconds: the threads of the other side take some milliseconds to come to rest
REST = 0.05


class Planes(ctypes.Structure):
    """struct brdf_vectors and struct brdf_colors."""

    _fields_ = [("plane", ctypes.c_void_p * 3)]


class Samples(ctypes.Structure):
    _fields_ = [("wi", ctypes.c_void_p * 3), ("weight", Planes), ("pdf", ctypes.c_void_p),
                ("eta", ctypes.c_void_p), ("delta", ctypes.c_void_p)]


class Error(ctypes.Structure):
    _fields_ = [("code", ctypes.c_int), ("message", ctypes.c_char * 1024)]


def planes(array):
    return (ctypes.c_void_p * 3)(*[plane.ctypes.data for plane in array])


class Evaluator:
    """libbrdfcl's evaluator of a material, through its C interface."""

    def __init__(self, build, material):
        for name in ("libbrdf.so", "libbrdfcl.so"):
            self.library = ctypes.CDLL(os.path.join(build, name), ctypes.RTLD_GLOBAL)
        self.pointer = ctypes.c_void_p()
        bsdf, device = ctypes.c_void_p(), ctypes.c_void_p()
        self.call("brdf_bsdf_create", material.encode(), ctypes.byref(bsdf))
        self.call("brdfcl_device_open", None, 0, 0, ctypes.byref(device))
        self.lanes = self.library.brdfcl_device_array_lanes(device)
        self.call("brdfcl_evaluator_create", device, bsdf, ctypes.byref(self.pointer))

    def call(self, name, *arguments):
        error = Error()
        if getattr(self.library, name)(*arguments, ctypes.byref(error)):
            raise RuntimeError(f"{name}: {error.message.decode()}")

    def run(self, operation, inputs):
        """The values, as rows; afterwards the arrays are on the device."""
        wo, wi, u = inputs
        count = wo.shape[1]
        second = u if operation == "sample" else wi
        out = np.zeros((7, count), np.float32)
        if operation == "eval":
            result = (Planes(planes(out[:3])),)
        elif operation == "pdf":
            result = (ctypes.c_void_p(out.ctypes.data),)
        else:
            result = (Samples(planes(out[4:7]), Planes(planes(out[:3])),
                              out[3].ctypes.data, None, None),)
        self.call("brdfcl_evaluator_" + operation, self.pointer, ctypes.c_size_t(count),
                  Planes(planes(wo)), Planes(planes(second)), *result)
        return out[:1] if operation == "pdf" else out[:3]

    def seconds(self, times):
        """Of the last operation so often again."""
        seconds = ctypes.c_double()
        self.call("brdfcl_evaluator_repeat", self.pointer, times, ctypes.byref(seconds))
        return seconds.value


def serve(pipe, build, material, inputs):
    """A process of its own: PoCL and Dr.Jit each bring an LLVM."""
    evaluator = Evaluator(build, material)
    pipe.send(evaluator.lanes)
    while True:
        question = pipe.recv()
        if question is None:
            return
        again = isinstance(question, int)
        pipe.send(evaluator.seconds(question) if again else evaluator.run(question, inputs))


class Ours:
    def __init__(self, build, material, inputs):
        self.pipe, other = multiprocessing.Pipe()
        self.process = multiprocessing.Process(target=serve, daemon=True,
                                               args=(other, build, material, inputs))
        self.process.start()
        other.close()
        self.lanes = self.pipe.recv()

    def ask(self, question):
        self.pipe.send(question)
        return self.pipe.recv()

    def values(self, operation):
        return self.ask(operation)

    def seconds(self, _, times):
        return self.ask(times)

    def stop(self):
        self.pipe.send(None)
        self.process.join()


class Mitsuba:
    def __init__(self, path, inputs):
        # Not before ours is started: the process of ours needs none of this.
        import drjit as dr
        import mitsuba as mi

        mi.set_variant(VARIANT)
        mi.set_log_level(mi.LogLevel.Error)
        wo, wi, u = inputs
        self.dr, self.mi = dr, mi
        self.name = f"Mitsuba {mi.__version__} {VARIANT}"
        self.bsdf = mi.load_dict({"type": "measured", "filename": path})
        self.cosine = wi[2]
        self.si = dr.zeros(mi.SurfaceInteraction3f, wo.shape[1])
        self.si.wi = mi.Vector3f(wo)
        self.wi = mi.Vector3f(wi)
        self.choice, self.u = mi.Float(u[2]), mi.Point2f(u[:2])
        dr.eval(self.si, self.wi, self.choice, self.u)

    def run(self, operation):
        context = self.mi.BSDFContext()
        if operation == "eval":
            result = self.bsdf.eval(context, self.si, self.wi)
        elif operation == "pdf":
            result = self.bsdf.pdf(context, self.si, self.wi)
        else:
            result = self.bsdf.sample(context, self.si, self.choice, self.u)
        self.dr.eval(result)
        self.dr.sync_thread()
        return result

    def values(self, operation):
        result = self.run(operation)
        if operation == "pdf":
            return np.array(result).reshape(1, -1)
        color = np.array(result if operation == "eval" else result[1]).reshape(3, -1)
        return np.maximum(color / self.cosine if operation == "eval" else color, 0.0)

    def seconds(self, operation, times):
        begin = time.perf_counter()
        for _ in range(times):
            self.run(operation)
        return time.perf_counter() - begin


def hemisphere(random, count):
    """Directions with a density of their cosine, a plane a row."""
    u = random.random((2, count))
    radius, phi = np.sqrt(u[0]), 2.0 * np.pi * u[1]
    z = np.sqrt(np.maximum(1.0 - u[0], 1e-12))
    return np.float32([radius * np.cos(phi), radius * np.sin(phi), z])


def difference(operation, ours, theirs):
    """Relative, of all but a thousandth of values; of samples, in standard errors of the mean."""
    if operation == "sample":
        mean = ours.mean(1) - theirs.mean(1)
        error = np.sqrt((ours.var(1) + theirs.var(1)) / ours.shape[1])
        return float(np.abs(mean / error).max())
    # A small channel beside large ones hangs on their last digits.
    scale = np.maximum(np.abs(theirs).max(0), 1e-4)
    return float(np.quantile(np.abs(ours - theirs).max(0) / scale, 0.999))


def measure(operation, contenders, rounds, count):
    off = difference(operation, *[one.values(operation) for one in contenders])
    times = [1 + int(TURN / (one.seconds(operation, 3) / 3)) for one in contenders]
    rates = [[], []]
    for _ in range(rounds):
        for i, one in enumerate(contenders):
            time.sleep(REST)
            rates[i].append(times[i] * count / one.seconds(operation, times[i]))
    return {"operation": operation, "difference": off,
            "same": off < (STANDARD_ERRORS if operation == "sample" else LIMIT),
            "ours": rates[0], "mitsuba": rates[1],
            "ratio": statistics.median(rates[0]) / statistics.median(rates[1])}


def show(row):
    ours, theirs = ([r / 1e6 for r in row[side]] for side in ("ours", "mitsuba"))
    ratios = [a / b for a, b in zip(ours, theirs)]
    verdict = "" if row["same"] else "   NOT THE SAME VALUES"
    print(f"  {row['operation']:8} {statistics.median(ours):8.1f} ({min(ours):.1f} to {max(ours):.1f})"
          f" {statistics.median(theirs):8.1f} ({min(theirs):.1f} to {max(theirs):.1f})"
          f"   ratio {row['ratio']:.2f} ({min(ratios):.2f} to {max(ratios):.2f})"
          f"   off by {row['difference']:.2g}{verdict}", flush=True)


def main():
    build = os.environ.get("BUILD", "build")
    data = os.environ.get("BRDFCL_DATA", "../shared/data")
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("file", nargs="?", help="an RGL .bsdf file",
                        default=os.path.join(data, "rgl", "cc_iris_purple_gem_rgb.bsdf"))
    parser.add_argument("--rounds", type=int, default=15, help="that count, of each [15]")
    parser.add_argument("--count", type=int, default=1 << 20, help="directions [1048576]")
    parser.add_argument("--json", default=os.path.join(build, "peers_material.json"))
    options = parser.parse_args()
    if not os.access(options.file, os.R_OK):
        print(f"brdfcl: {options.file} cannot be read: name a file, or set BRDFCL_DATA")
        return 1
    random = np.random.default_rng(1)
    inputs = (hemisphere(random, options.count), hemisphere(random, options.count),
              np.float32(random.random((3, options.count)) * (1.0 - 2.0**-24)))
    path = os.path.abspath(options.file)
    multiprocessing.set_start_method("spawn")
    ours = Ours(os.path.abspath(build), f"measured:filename={path}", inputs)
    mitsuba = Mitsuba(path, inputs)
    print(f"{os.path.basename(path)}: {options.count} directions, {options.rounds} rounds in turns; "
          f"M/s, median (least to most)\n  {'':8} brdfcl, {ours.lanes} lanes; {mitsuba.name}")
    rows = []
    for operation in OPERATIONS:
        rows.append(measure(operation, (ours, mitsuba), options.rounds, options.count))
        show(rows[-1])
    ours.stop()
    with open(options.json, "w", encoding="utf-8") as file:
        json.dump({"file": path, "count": options.count, "rounds": options.rounds,
                   "lanes": ours.lanes, "peer": mitsuba.name, "operations": rows}, file, indent=2)
        file.write("\n")
    print(f"{options.json} holds all of it")
    return 0 if all(row["same"] for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
