"""What a benchmark scene is made of, apart from any renderer's language. Meters, Y up, linear sRGB."""

import dataclasses
import pathlib

import numpy as np


@dataclasses.dataclass(frozen=True)
class Diffuse:
    """Lambertian reflector."""

    reflectance: tuple


@dataclasses.dataclass(frozen=True)
class Coated:
    """Diffuse base under a rough dielectric coat of index 1.5. Mitsuba has no layered material: its
    roughplastic, without the interreflection of the rough interface, comes nearest."""

    reflectance: tuple
    alpha: float


@dataclasses.dataclass(frozen=True)
class Dielectric:
    """Smooth, or a GGX interface of roughness alpha."""

    eta: float
    alpha: float = 0.0


@dataclasses.dataclass(frozen=True)
class Copper:
    """GGX conductor with the index of copper."""

    alpha: float


@dataclasses.dataclass(frozen=True)
class Hair:
    """Fibre with pigments in pbrt's units."""

    eumelanin: float
    pheomelanin: float
    beta_m: float = 0.3
    beta_n: float = 0.3
    alpha: float = 2.0
    eta: float = 1.55

    def sigma_a(self):
        """Absorption per fibre radius, linear sRGB (d'Eon et al. 2011, as pbrt states it)."""
        return self.eumelanin * np.array([0.419, 0.697, 1.37]) + self.pheomelanin * np.array(
            [0.187, 0.4, 1.05]
        )


@dataclasses.dataclass(frozen=True)
class Quad:
    """Parallelogram; corners in order, normal along (p1 - p0) x (p3 - p0)."""

    corners: tuple
    material: object
    emission: tuple = None


@dataclasses.dataclass(frozen=True)
class Sphere:
    center: tuple
    radius: float
    material: object


@dataclasses.dataclass(frozen=True)
class Mesh:
    """A PLY file, its name relative to the scene's folder."""

    file: str
    material: object


@dataclasses.dataclass(frozen=True)
class Strands:
    """Uniform cubic B-splines, points[strand, control point, xyz]; widths (diameters) at both ends."""

    points: np.ndarray
    widths: tuple
    material: object


@dataclasses.dataclass(frozen=True)
class Sky:
    """Infinite light: one color, or radiance(directions[..., 3]) -> rgb[..., 3]."""

    rgb: tuple = None
    radiance: object = None
    map: object = None  # path of an equal-area picture of it, Z up


@dataclasses.dataclass
class Scene:
    name: str
    look_at: tuple
    fov: float
    objects: list
    sky: Sky = None
    resolution: int = 400
    depth: int = 8
    tolerance: float = 0.02  # largest systematic difference between renderers, of a block's mean
    reference_share: float = 1.0  # of the samples asked for; less where a picture takes long
    files: dict = dataclasses.field(default_factory=dict)  # name: function(path) that writes it

    def write_files(self, folder: pathlib.Path):
        """Writes what both renderers read; skips what is there."""
        folder.mkdir(parents=True, exist_ok=True)
        for name, write in self.files.items():
            if not (folder / name).exists():
                write(folder / name)
