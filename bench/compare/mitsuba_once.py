"""Renders one scene once with Mitsuba, in a process of its own:
    mitsuba_once.py <variant> <scene.xml> <threads> <spp> <seed> <picture.npy>
prints JSON. Before the timed picture one of a single sample is made, which compiles the kernel (or
takes it from Mitsuba's cache): `warm_up` is what that takes. Pictures are in linear sRGB."""

import json
import sys
import time

import mitsuba
import numpy as np


def timed(function):
    start = time.perf_counter()
    result = function()
    return result, time.perf_counter() - start


def peak_bytes():
    """Largest resident set; from /proc, for getrusage counts what the parent held, too."""
    with open("/proc/self/status") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmHWM")) * 1024


def main():
    variant, file, threads, spp, seed, picture = sys.argv[1:]
    mitsuba.set_variant(variant)
    mitsuba.set_log_level(mitsuba.LogLevel.Error)
    import drjit

    drjit.set_thread_count(int(threads))
    scene, load = timed(lambda: mitsuba.load_file(file))

    def render(samples):
        return np.array(mitsuba.render(scene, spp=samples, seed=int(seed)))

    warm_up = timed(lambda: render(1))[1] if variant.startswith("llvm") else 0.0
    pixels, seconds = timed(lambda: render(int(spp)))
    np.save(picture, pixels[:, ::-1])  # its camera looks along a left-handed frame: mirrored
    print(json.dumps({"load": load, "warm_up": warm_up, "render": seconds,
                      "peak": peak_bytes()}))


if __name__ == "__main__":
    main()
