"""Writes a Scene in the language of Mitsuba 3."""

import functools
import math

import numpy as np

from . import scene as s
from .write_pbrt import write_pfm


def commas(values):
    return ", ".join(f"{v:.7g}" for v in np.ravel(values))


def rgb(name, values):
    return f'<rgb name="{name}" value="{commas(values)}"/>'


def number(name, value):
    return f'<float name="{name}" value="{value:.7g}"/>'


GGX = '<string name="distribution" value="ggx"/>'
AIR = number("ext_ior", 1.0)


def two_sided(kind, inside):
    return f'<bsdf type="twosided"><bsdf type="{kind}">{inside}</bsdf></bsdf>\n'


@functools.singledispatch
def material(m):
    raise TypeError(m)


@material.register
def _(m: s.Diffuse):
    return two_sided("diffuse", rgb("reflectance", m.reflectance))


@material.register
def _(m: s.Coated):
    return two_sided("roughplastic", rgb("diffuse_reflectance", m.reflectance) + GGX + AIR
                     + number("alpha", m.alpha) + number("int_ior", 1.5)
                     + '<boolean name="nonlinear" value="true"/>')


@material.register
def _(m: s.Dielectric):
    inside = number("int_ior", m.eta) + AIR
    if m.alpha:
        return f'<bsdf type="roughdielectric">{inside}{GGX}{number("alpha", m.alpha)}</bsdf>\n'
    return f'<bsdf type="dielectric">{inside}</bsdf>\n'


@material.register
def _(m: s.Copper):
    return two_sided("roughconductor",
                     '<string name="material" value="Cu"/>' + GGX + number("alpha", m.alpha))


@material.register
def _(m: s.Hair):
    return ('<bsdf type="hair">' + rgb("sigma_a", m.sigma_a()) + AIR + number("int_ior", m.eta)
            + number("longitudinal_roughness", m.beta_m)
            + number("azimuthal_roughness", m.beta_n) + number("scale_tilt", m.alpha)
            + "</bsdf>\n")


@functools.singledispatch
def shape(o, folder):
    raise TypeError(o)


@shape.register
def _(o: s.Quad, folder):
    p = np.array(o.corners, float)
    matrix = np.eye(4)
    matrix[:3, 0], matrix[:3, 1] = (p[1] - p[0]) / 2, (p[3] - p[0]) / 2
    matrix[:3, 2] = np.cross(matrix[:3, 0], matrix[:3, 1])
    matrix[:3, 2] /= np.linalg.norm(matrix[:3, 2])
    matrix[:3, 3] = (p[0] + p[2]) / 2
    light = ""
    if o.emission:
        light = f'<emitter type="area">{rgb("radiance", o.emission)}</emitter>'
    place = f'<matrix value="{" ".join(f"{v:.9g}" for v in matrix.ravel())}"/>'
    return ('<shape type="rectangle"><transform name="to_world">'
            f"{place}</transform>{light}{material(o.material)}</shape>\n")


@shape.register
def _(o: s.Sphere, folder):
    x, y, z = o.center
    return (f'<shape type="sphere"><point name="center" x="{x:g}" y="{y:g}" z="{z:g}"/>'
            f'{number("radius", o.radius)}{material(o.material)}</shape>\n')


@shape.register
def _(o: s.Mesh, folder):
    return (f'<shape type="ply"><string name="filename" value="{o.file}"/>'
            f"{material(o.material)}</shape>\n")


@shape.register
def _(o: s.Strands, folder):
    n = o.points.shape[1]
    # Linear along the strand; outer control points lie beyond its ends.
    ramp = o.widths[0] + (o.widths[1] - o.widths[0]) * (np.arange(n) - 1) / (n - 3)
    with open(folder / "strands.txt", "w") as file:
        for strand in o.points.tolist():
            rows = (f"{x:.6g} {y:.6g} {z:.6g} {w / 2:.7g}\n" for (x, y, z), w in zip(strand, ramp))
            file.write("".join(rows) + "\n")
    return ('<shape type="bsplinecurve"><string name="filename" value="strands.txt"/>'
            f"{material(o.material)}</shape>\n")


def sky(light, folder):
    if light.radiance is None:
        return f'<emitter type="constant">{rgb("radiance", light.rgb)}</emitter>\n'
    path = folder / "sky-latlong.pfm"
    if not path.exists():
        theta, phi = np.meshgrid((np.arange(1024) + 0.5) / 1024 * math.pi,
                                 (np.arange(2048) + 0.5) / 2048 * 2 * math.pi, indexing="ij")
        d = np.stack([np.sin(theta) * np.sin(phi), np.cos(theta), -np.sin(theta) * np.cos(phi)], -1)
        write_pfm(path, light.radiance(d))
    return f'<emitter type="envmap"><string name="filename" value="{path.name}"/></emitter>\n'


def sensor(scene):
    names = ("origin", "target", "up")
    look = " ".join(f'{n}="{commas(v)}"' for n, v in zip(names, scene.look_at))
    # One bounce more counts the camera's own segment; roulette starts where pbrt's does.
    return (f'<integrator type="path"><integer name="max_depth" value="{scene.depth + 1}"/>'
            '<integer name="rr_depth" value="2"/></integrator>\n'
            f'<sensor type="perspective">{number("fov", scene.fov)}'
            f'<transform name="to_world"><lookat {look}/></transform>'
            '<sampler type="independent"/><film type="hdrfilm">'
            f'<integer name="width" value="{scene.resolution}"/>'
            f'<integer name="height" value="{scene.resolution}"/>'
            '<string name="pixel_format" value="rgb"/><rfilter type="box"/></film></sensor>\n')


def write(scene, folder):
    """Writes <folder>/<name>.xml and the files it needs; returns its path."""
    scene.write_files(folder)
    path = folder / f"{scene.name}.xml"
    parts = [sensor(scene)] + ([sky(scene.sky, folder)] if scene.sky else [])
    parts += [shape(o, folder) for o in scene.objects]
    path.write_text('<scene version="3.0.0">\n' + "".join(parts) + "</scene>\n")
    return path
