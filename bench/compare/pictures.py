"""Our pictures against those that pbrt-v4 made of the same scenes (bench/reference)."""

import dataclasses
import pathlib

from . import error, runs, scenes, write_pbrt

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "reference"
SIZE, SPP, BATCHES = 100, 128, 8
TOLERANCE = 0.005


def has_reference(name):
    return (FOLDER / f"{name}.exr").exists()


def their_reference(name):
    """pbrt-v4's picture of 4096 samples (hair 2048). Its variance per pixel: the squared difference
    from one of 256 samples, less by the ratio of the samples; right as a mean over many pixels."""
    long, short = (runs.read_exr(FOLDER / f"{name}{part}.exr") for part in ("", "-256"))
    spp = 2048 if name == "hairball" else 4096
    return error.Reference(long, (long - short) ** 2 * 256 / spp, spp)


def check(name, setting):
    """Agreement of our picture with theirs: of each channel's mean, within 0.5 %. The blocks of
    10 x 10 pixels are told only: hair's few bright samples make the noise of one unknowable from two
    pictures (pbrt-v4's own differ by 26 % there)."""
    scene = scenes.SCENES[name]()
    scene.resolution = SIZE
    # The map that theirs was made with: resampled from latitudes, its horizon is blurred.
    sky = FOLDER / f"{name}-sky.exr"
    if sky.exists():
        scene.sky = dataclasses.replace(scene.sky, map=sky)
    folder = setting.build / "scenes" / f"{name}-{SIZE}"
    path = write_pbrt.write(scene, folder)
    ours = error.reference([runs.pbrt(path, setting.threads, SPP, 500 + k).picture
                            for k in range(BATCHES)], SPP)
    theirs = their_reference(name)
    blocks = error.agreement(ours, theirs, scene.tolerance, size=10)
    means = ours.picture.mean((0, 1)) / theirs.picture.mean((0, 1))
    return error.Agreement(blocks.ratio, blocks.beyond_noise, bool(abs(means - 1).max() <= TOLERANCE))
