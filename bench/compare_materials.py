"""Materials with random parameters, as brdfcl and Mitsuba 3 each describe them: for compare.py."""

import os

import numpy as np


def text_of(value):
    """A value as brdfcl's descriptions have it."""
    if isinstance(value, (list, tuple, np.ndarray)):
        return "/".join(repr(float(np.float32(v))) for v in value)
    return value if isinstance(value, str) else repr(float(np.float32(value)))


class Material:
    """The same material twice: `shared` parameters have one name in both programs."""

    def __init__(self, model, shared, ours=None, theirs=None):
        self.shared = shared
        settings = dict(shared)
        settings.update(ours or {})
        self.description = model
        if settings:
            self.description += ":" + ",".join(f"{k}={text_of(v)}" for k, v in settings.items())
        self.dictionary = {"type": model}
        for name, value in list(shared.items()) + list((theirs or {}).items()):
            if isinstance(value, np.ndarray):
                value = {"type": "rgb", "value": [float(np.float32(v)) for v in value]}
            elif isinstance(value, np.floating):
                value = float(value)
            elif value in ("true", "false"):
                value = value == "true"
            self.dictionary[name] = value


def color(random, high=1.0):
    return np.float32(high * random.random(3))


def alphas(random):
    """From nearly smooth to rougher than it makes sense, isotropic half of the time."""
    alpha = np.float32(np.exp(random.uniform(np.log(0.03), np.log(1.0), 2)))
    return (alpha[0], alpha[0]) if random.random() < 0.5 else (alpha[0], alpha[1])


def indices(random):
    """Of the inside and of the outside; the inside is the denser one more often."""
    pair = np.float32([random.uniform(1.1, 2.4), random.uniform(1.0, 1.05)])
    return {"int_ior": pair[0], "ext_ior": pair[1]} if random.random() < 0.7 else \
        {"int_ior": pair[1], "ext_ior": pair[0]}


def denser_inside(random):
    return {"int_ior": np.float32(random.uniform(1.1, 2.4)), "ext_ior": np.float32(1.0)}


def metal(random):
    return {"eta": color(random, 3.0) + np.float32(0.05), "k": color(random, 7.0)}


def make_diffuse(random):
    return Material("diffuse", {"reflectance": color(random)})


def make_conductor(random):
    return Material("conductor", {**metal(random), "specular_reflectance": color(random)})


def make_dielectric(random):
    return Material("dielectric", {**indices(random), "specular_reflectance": color(random),
                                   "specular_transmittance": color(random)})


def make_thindielectric(random):
    return Material("thindielectric", {**denser_inside(random), "specular_reflectance": color(random),
                                       "specular_transmittance": color(random)})


def rough(distribution, random, shared):
    alpha = alphas(random)
    return {"distribution": distribution, "alpha_u": alpha[0], "alpha_v": alpha[1], **shared}


def make_roughconductor(distribution, masking):
    def make(random):
        shared = {**metal(random), "specular_reflectance": color(random)}
        return Material("roughconductor", rough(distribution, random, shared), {"masking": masking})
    return make


def make_roughdielectric(distribution):
    def make(random):
        shared = {**indices(random), "specular_reflectance": color(random),
                  "specular_transmittance": color(random)}
        return Material("roughdielectric", rough(distribution, random, shared),
                        {"masking": "separable"})
    return make


def fresnel_mean_inside(ior):
    """What a smooth interface reflects of diffuse light from inside, exactly and as Mitsuba fits it."""
    cosine = (np.arange(100000) + 0.5) / 100000
    cosine_t = np.sqrt(1.0 - (1.0 - cosine * cosine) / ior**2)
    s = (cosine - ior * cosine_t) / (cosine + ior * cosine_t)
    p = (ior * cosine - cosine_t) / (ior * cosine + cosine_t)
    outside = float((cosine * (s * s + p * p)).mean())
    eta = 1.0 / ior  # Egan and Hilgeman 1973
    fit = -1.4399 * eta**2 + 0.7099 * eta + 0.6681 + 0.0636 / eta
    return 1.0 - (1.0 - outside) / ior**2, fit


def with_exact_mean(material, values):
    """Mitsuba's f of plastic, had it the exact mean instead of a fit."""
    shared = material.shared
    exact, fit = fresnel_mean_inside(float(shared["int_ior"]) / float(shared["ext_ior"]))
    base = np.float64(shared["diffuse_reflectance"]) if shared["nonlinear"] == "true" else 1.0
    return values * (1.0 - base * fit) / (1.0 - base * exact)


def without_negative(_, values):
    """Some measured colours are outside of Rec. 709; ours are 0 there."""
    return np.maximum(values, 0.0)


def make_plastic(random):
    return Material("plastic", {**denser_inside(random), "diffuse_reflectance": color(random),
                                "specular_reflectance": color(random),
                                "nonlinear": "true" if random.random() < 0.5 else "false"})


def make_roughplastic(random):
    alpha = np.float32(np.exp(random.uniform(np.log(0.05), np.log(0.7))))
    return Material("roughplastic",
                    {"distribution": "ggx" if random.random() < 0.5 else "beckmann", "alpha": alpha,
                     **denser_inside(random), "diffuse_reflectance": color(random),
                     "specular_reflectance": color(random),
                     "nonlinear": "true" if random.random() < 0.5 else "false"})


def make_principled(random):
    names = ["roughness", "anisotropic", "metallic", "spec_tint", "sheen", "sheen_tint", "flatness",
             "clearcoat", "clearcoat_gloss"]
    shared = {name: np.float32(random.random()) for name in names}
    # Nearer to 1, 1 - (1 - alpha^2) cos^2 has too few digits left in Mitsuba's clearcoat.
    shared["clearcoat_gloss"] *= np.float32(0.5)
    shared["roughness"] = np.float32(random.uniform(0.2, 1.0))
    shared["specular"] = np.float32(random.uniform(0.2, 1.0))
    if random.random() < 0.5:
        shared["spec_trans"] = np.float32(random.random())
    return Material("principled", {"base_color": color(random), **shared})


def make_measured(random):
    folder = os.environ.get("BRDFCL_DATA", "../shared/data") + "/rgl"
    files = sorted(f for f in os.listdir(folder) if f.endswith("_rgb.bsdf")) if \
        os.path.isdir(folder) else []
    if not files:
        return None
    return Material("measured", {"filename": os.path.join(folder, random.choice(files))})
