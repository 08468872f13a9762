"""The scenes on which renderers are compared."""

from . import geometry as g
from .scene import Coated, Copper, Dielectric, Diffuse, Hair, Mesh, Scene, Sky, Sphere, Strands

BLACK = Diffuse((0, 0, 0))


def matte_spheres():
    """Diffuse spheres in a diffuse box under a square lamp: six bounces of light."""
    walls = g.box((-1, 0, -3), (1, 2, 1), Diffuse((0.60, 0.08, 0.06)), Diffuse((0.10, 0.42, 0.12)),
                  Diffuse((0.72, 0.70, 0.66)))
    spheres = [
        Sphere((-0.45, 0.4, 0.3), 0.4, Diffuse((0.7, 0.7, 0.7))),
        Sphere((0.45, 0.3, -0.1), 0.3, Diffuse((0.2, 0.35, 0.7))),
        Sphere((-0.1, 0.18, -0.5), 0.18, Diffuse((0.75, 0.6, 0.2))),
        Sphere((0.05, 1.25, 0.45), 0.25, Diffuse((0.6, 0.3, 0.6))),
        Sphere((0.7, 0.15, -0.65), 0.15, Diffuse((0.3, 0.65, 0.6))),
        Sphere((-0.72, 0.14, -0.55), 0.14, Diffuse((0.75, 0.35, 0.2))),
    ]
    light = g.lamp(0, 0, 0.35, 1.995, BLACK, (16, 14, 11))
    return Scene("matte-spheres", ((0, 1, -2.9), (0, 0.95, 0), (0, 1, 0)), 40,
                 walls + [light] + spheres)


def glass_caustic():
    """Dielectric spheres, one of them rough, in a box: caustics found by chance alone."""
    walls = g.box((-1.2, 0, -3), (1.2, 2.2, 1.4), Diffuse((0.65, 0.5, 0.25)),
                  Diffuse((0.2, 0.4, 0.6)), Diffuse((0.7, 0.7, 0.7)))
    spheres = [
        Sphere((-0.42, 0.42, 0.15), 0.42, Dielectric(1.5)),
        Sphere((0.48, 0.34, 0.0), 0.34, Dielectric(1.33)),
        Sphere((0.02, 0.22, -0.62), 0.22, Dielectric(1.7)),
        Sphere((0.1, 1.25, 0.35), 0.28, Dielectric(1.5)),
        Sphere((-0.75, 0.16, -0.5), 0.16, Dielectric(1.5)),
        Sphere((0.8, 0.18, -0.55), 0.18, Dielectric(1.5, 0.15)),
    ]
    light = g.lamp(0, 0, 0.22, 2.19, BLACK, (42, 38, 33))
    return Scene("glass-caustic", ((0, 1.3, -2.95), (0, 0.55, 0.1), (0, 1, 0)), 42,
                 walls + [light] + spheres)


def mesh_on(name, ground, tolerance):
    """A million triangles of rough copper under a sky with a sun."""
    def write(path):
        g.write_ply(path, *g.bumpy_sphere(1000, 501))

    return Scene(name, ((0.6, 1.1, -3.4), (0, -0.05, 0), (0, 1, 0)), 36,
                 [g.floor(6, -1, ground), Mesh("mesh-1m.ply", Copper(0.2))],
                 Sky(radiance=g.evening_sky), tolerance=tolerance,
                 files={"mesh-1m.ply": write})


def mesh_1m():
    """On a coated ground, which Mitsuba's roughplastic only comes near."""
    return mesh_on("mesh-1m", Coated((0.35, 0.18, 0.12), 0.05**0.5), tolerance=0.04)


def mesh_1m_matte():
    """On a diffuse ground, the same in both."""
    return mesh_on("mesh-1m-matte", Diffuse((0.35, 0.18, 0.12)), tolerance=0.01)


def hairball():
    """50 000 hairs of three segments under a square lamp and a dim sky."""
    hair = Strands(g.hair_ball(50000), (0.004, 0.0015), Hair(0.35, 0.15))
    light = g.lamp(1.2, -1.2, 0.8, 2.4, BLACK, (9, 8.4, 7.6))
    scalp = Sphere((0, 0, 0), 0.55, Diffuse((0.12, 0.08, 0.06)))
    return Scene("hairball", ((0, 0.5, -3.6), (0, 0, 0), (0, 1, 0)), 34,
                 [g.floor(4, -1.05, Diffuse((0.4, 0.4, 0.4))), light, hair, scalp],
                 Sky(rgb=(0.25, 0.28, 0.33)), tolerance=0.03, reference_share=0.5)


SCENES = {f.__name__.replace("_", "-"): f
          for f in (matte_spheres, glass_caustic, mesh_1m, mesh_1m_matte, hairball)}
