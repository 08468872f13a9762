"""Measures the renderers on the scenes: alternating runs, references, errors, efficiency."""

import dataclasses
import hashlib
import importlib.metadata
import subprocess

import numpy as np

from . import error, runs, scenes, write_mitsuba, write_pbrt

BATCHES = 8  # independent pictures that make a reference
FEATHER = "dove-feather"


@dataclasses.dataclass
class Row:
    """What one renderer did on one scene: least seconds, mean errors over its runs."""

    renderer: str
    load: float
    warm_up: float
    render: float
    rays_per_second: float
    peak: int
    memory_ratio: float = None  # see runs.memory_ratio; of ours alone
    mse: float = None
    trimmed: float = None
    flip: float = None

    def efficiency(self):
        return 1 / (self.mse * self.render) if self.mse else None


@dataclasses.dataclass
class Result:
    """Of one scene. agreement: of the renderers' references, None where there is no peer; bare: M
    rays/s of one thread by name (runs.bare)."""

    rows: list
    agreement: object
    bare: dict


@dataclasses.dataclass
class Setting:
    """What is asked for on the command line."""

    build: object
    spp: int
    repeats: int
    threads: int
    reference_spp: int
    llvm: bool
    scalar: bool


def prepare(name, setting):
    """Writes the scene for both renderers; its folder and description (None: ours alone)."""
    if name == FEATHER:
        folder = runs.ROOT / "scenes" / name
        subprocess.run([folder / "generate.sh", runs.BIN], check=True, stdout=subprocess.DEVNULL)
        return folder, None
    scene = scenes.SCENES[name]()
    folder = setting.build / "scenes" / name
    write_pbrt.write(scene, folder, setting.spp)
    write_mitsuba.write(scene, folder)
    return folder, scene


def version(renderer):
    return importlib.metadata.version("mitsuba") if renderer.variant else "ours"


def reference_spp(scene, setting):
    """Samples of the scene's reference: a multiple of the batches."""
    share = scene.reference_share if scene else 1.0
    return max(1, int(setting.reference_spp * share) // BATCHES) * BATCHES


def cached_reference(renderer, folder, name, spp, setting):
    """A converged picture of this renderer, from the cache where it has one of the same scene.
    Ours is of whatever version made it: a converged picture does not depend on the sampler."""
    kind = ".xml" if renderer.variant else ".pbrt"
    text = (folder / (name + kind)).read_bytes()
    digest = hashlib.sha256(text).hexdigest()[:12]
    key = f"{name}-{renderer.variant or 'pbrt'}-{version(renderer)}-{spp}-{digest}"
    path = setting.build / "references" / f"{key}.npz"
    if path.exists():
        with np.load(path) as file:
            return error.Reference(file["picture"], file["variance"], spp)
    each = spp // BATCHES
    print(f"  reference of {renderer.name}: {BATCHES} x {each} samples", flush=True)
    pictures = [renderer.render(folder, name, setting.threads, each, 1000 + k).picture
                for k in range(BATCHES)]
    ref = error.reference(pictures, each)
    path.parent.mkdir(parents=True, exist_ok=True)
    np.savez(path, picture=ref.picture.astype(np.float32), variance=ref.variance.astype(np.float32))
    return ref


def row(renderer, done, scene_file):
    fastest = min(done, key=lambda r: r.render)
    peak, ratio = max(r.peak for r in done), None
    if renderer == runs.OURS:
        ratio = runs.memory_ratio(peak, fastest.traversal, runs.input_bytes(scene_file))
    return Row(renderer.name, min(r.load for r in done), min(r.warm_up for r in done),
               fastest.render, fastest.rays / fastest.render, peak, ratio)


def with_errors(line, done, ref, spp):
    pictures = [r.picture for r in done]
    line.mse = float(np.mean([error.relative_mse(p, ref, spp) for p in pictures]))
    line.trimmed = float(np.mean([error.trimmed_mse(p, ref, spp) for p in pictures]))
    line.flip = float(np.mean([error.flip(p, ref) for p in pictures]))
    return line


def alternate(renderers, folder, name, setting):
    """The runs of each renderer, taken in turn; the slow scalar one runs once, last."""
    done = {r: [] for r in renderers}
    for seed in range(setting.repeats):
        for renderer in renderers:
            if renderer not in done or (renderer == runs.SCALAR and seed > 0):
                continue
            try:
                run = renderer.render(folder, name, setting.threads, setting.spp, seed)
            except runs.Failed as failure:
                if renderer == runs.OURS:
                    raise
                print(f"  {renderer.name} is left out: {failure}", flush=True)
                done.pop(renderer)
                continue
            print(f"  {renderer.name}: load {run.load:.2f} s, render {run.render:.2f} s", flush=True)
            done[renderer].append(run)
    return done


def measure(name, setting):
    """What was found on one scene; a peer that fails is left out with a word."""
    print(name, flush=True)
    folder, scene = prepare(name, setting)
    peers = [runs.LLVM] * setting.llvm + [runs.SCALAR] * setting.scalar
    renderers = [runs.OURS] + (peers if scene else [])
    done = alternate(renderers, folder, name, setting)
    # Both variants of Mitsuba converge to the same picture: one reference serves both.
    compared = [r for r in done if r != runs.SCALAR or runs.LLVM not in done]
    spp = reference_spp(scene, setting)
    refs = {r: cached_reference(r, folder, name, spp, setting) for r in compared}
    file = folder / f"{name}.pbrt"
    rows = [with_errors(row(r, done[r], file), done[r], refs.get(r) or refs[compared[-1]],
                        setting.spp) for r in done]
    agreement = None
    if len(compared) > 1:
        agreement = error.agreement(refs[compared[0]], refs[compared[1]], scene.tolerance)
    return Result(rows, agreement, runs.bare(file))
