"""Runs of the renderers, each in a process of its own, so that peak memory is that of one run."""

import dataclasses
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np
import OpenEXR

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BIN = ROOT / "build" / "bin"


@dataclasses.dataclass
class Run:
    """One render: seconds, peak bytes of the process, and the picture in linear sRGB. traversal: the
    most that Embree held, which is while it built."""

    load: float
    render: float
    peak: int
    picture: np.ndarray
    rays: int = 0
    traversal: int = 0
    warm_up: float = 0.0
    parse: float = 0.0  # part of load: reading the scene's text


class Failed(RuntimeError):
    """A renderer ended with an error or was killed."""


def child(command):
    """Runs a command; its standard output."""
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise Failed(f"{' '.join(str(c) for c in command)}: exit code {done.returncode}")
    return done.stdout


def read_exr(path):
    """RGB pixels in double."""
    channels = OpenEXR.File(str(path)).channels()
    if "RGB" in channels:
        return channels["RGB"].pixels.astype(np.float64)
    return np.stack([channels[c].pixels for c in "RGB"], -1).astype(np.float64)


def pbrt(scene, threads, spp, seed, options=()):
    """Renders a .pbrt file with this project's program."""
    with tempfile.TemporaryDirectory() as folder:
        picture, stats = f"{folder}/picture.exr", f"{folder}/stats.json"
        command = [BIN / "pbrt", scene, "--quiet", "--nthreads", threads, "--seed", seed,
                   "--outfile", picture, "--stats-file", stats, *options]
        child(command + ["--spp", spp])
        s = json.loads(pathlib.Path(stats).read_text())
        return Run(s["parseSeconds"] + s["buildSeconds"], s["renderSeconds"], s["peakBytes"],
                   read_exr(picture), rays=s["closestHitRays"] + s["shadowRays"],
                   traversal=s["traversalPeakBytes"], parse=s["parseSeconds"])


def input_bytes(scene):
    """Of a .pbrt file and the files that it names."""
    named = set(re.findall(r'"([^"\n]+\.\w+)"', scene.read_text()))
    files = [scene] + [scene.parent / name for name in named]
    return sum(f.stat().st_size for f in files if f.is_file())


def memory_ratio(peak, traversal, given):
    """Peak over what must be held, Embree's most and the input; None where the program itself, some
    12 MiB, outweighs these."""
    return peak / (traversal + given) if traversal + given > 10**7 else None


def mitsuba(variant, scene, threads, spp, seed):
    """Renders an .xml file with Mitsuba. A process that crashes (3.9.1 sometimes does in compiled
    code, on hair) is repeated with another seed, twice at most."""
    for attempt in range(3):
        with tempfile.TemporaryDirectory() as folder:
            picture = f"{folder}/picture.npy"
            command = [sys.executable, HERE / "mitsuba_once.py", variant, scene, threads, spp,
                       seed + 7919 * attempt, picture]
            try:
                text = child(command)
            except Failed as failure:
                print(f"  {failure}: once more with another seed", file=sys.stderr)
                last = failure
                continue
            s = json.loads(text.splitlines()[-1])
            pixels = np.load(picture).astype(np.float64)
            return Run(s["load"], s["render"], s["peak"], pixels, warm_up=s["warm_up"])
    raise last


def bare(scene, rounds=3):
    """Million rays per second and thread of Embree alone and of this project's traversal, on the
    closest-hit rays of diffuse paths through the scene (bench_rays)."""
    text = child([BIN / "bench_rays", scene, rounds])
    rates = {}
    for line in text.splitlines():
        if "M rays/s" in line:
            rates[line[:22].strip()] = float(line.split("ns")[1].split()[0])
    return rates


@dataclasses.dataclass(frozen=True)
class Renderer:
    """A renderer by the name of its row. render(folder of the scene, name, threads, spp, seed)."""

    name: str
    variant: str = ""

    def render(self, folder, name, threads, spp, seed):
        if self.variant:
            return mitsuba(self.variant, folder / f"{name}.xml", threads, spp, seed)
        return pbrt(folder / f"{name}.pbrt", threads, spp, seed)


OURS = Renderer("pbrt-feather")
LLVM = Renderer("Mitsuba llvm_ad_spectral", "llvm_ad_spectral")
SCALAR = Renderer("Mitsuba scalar_spectral", "scalar_spectral")
