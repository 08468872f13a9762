"""Errors of pictures against references, and whether two renderers' pictures agree."""

import dataclasses

import flip_evaluator
import numpy as np

EPSILON = 1e-2  # of the relative square error's denominator


@dataclasses.dataclass
class Reference:
    """Mean of independent pictures of equal sample counts, and the variance of that mean."""

    picture: np.ndarray
    variance: np.ndarray
    spp: int


def reference(pictures, spp_each):
    stack = np.stack(pictures)
    return Reference(stack.mean(0), stack.var(0, ddof=1) / len(pictures), spp_each * len(pictures))


def relative_squares(picture, ref):
    """(x - r)^2 / (r^2 + 0.01) of each pixel and channel."""
    return (picture - ref) ** 2 / (ref**2 + EPSILON)


def relative_mse(picture, ref, spp):
    """Mean of relative_squares. The reference's own noise adds spp / reference spp of it where both
    are independent and unbiased; that share is taken away."""
    return relative_squares(picture, ref.picture).mean() / (1 + spp / ref.spp)


def trimmed_mse(picture, ref, spp):
    """The same without the largest 0.1 % of the values: fireflies left out."""
    values = np.sort(relative_squares(picture, ref.picture), axis=None)
    return values[: int(len(values) * 0.999)].mean() / (1 + spp / ref.spp)


def flip(picture, ref):
    """Mean HDR-FLIP (Andersson et al. 2021) against the reference as it is."""
    images = (ref.picture.astype(np.float32), picture.astype(np.float32))
    return float(flip_evaluator.evaluate(*images, "HDR")[1])


def blocks(image, size=20):
    """Means of square blocks."""
    h, w, c = image.shape
    h, w = h - h % size, w - w % size
    return image[:h, :w].reshape(h // size, size, w // size, size, c).mean((1, 3))


@dataclasses.dataclass
class Agreement:
    """Of two renderers' references: ratio of the means; the largest difference of a block's mean
    beyond 5 standard deviations of noise, relative to it; whether that is within the tolerance."""

    ratio: float
    beyond_noise: float
    ok: bool


def agreement(a, b, tolerance, size=20):
    """Blocks of 400 pixels, all channels: at 5 sigma none of the 1200 exceeds the noise by chance
    (7e-4 in all)."""
    noise = np.sqrt((blocks(a.variance, size) + blocks(b.variance, size)) / size**2)
    x, y = blocks(a.picture, size), blocks(b.picture, size)
    excess = np.maximum(0, np.abs(x - y) - 5 * noise) / np.maximum(x, y)
    worst = float(excess.max())
    return Agreement(float(a.picture.mean() / b.picture.mean()), worst, worst <= tolerance)
