"""Writes a Scene in the language of pbrt."""

import functools
import math

import numpy as np

from . import scene as s


def numbers(values):
    return " ".join(f"{v:.6g}" for v in np.ravel(values).tolist())


@functools.singledispatch
def material(m):
    raise TypeError(m)


@material.register
def _(m: s.Diffuse):
    return f'Material "diffuse" "rgb reflectance" [ {numbers(m.reflectance)} ]\n'


@material.register
def _(m: s.Coated):
    return (f'Material "coateddiffuse" "rgb reflectance" [ {numbers(m.reflectance)} ] '
            f'"float roughness" {m.alpha:.7g} "bool remaproughness" false\n')


@material.register
def _(m: s.Dielectric):
    rough = f' "float roughness" {m.alpha:g} "bool remaproughness" false' if m.alpha else ""
    return f'Material "dielectric" "float eta" {m.eta:g}{rough}\n'


@material.register
def _(m: s.Copper):
    return ('Material "conductor" "spectrum eta" "metal-Cu-eta" "spectrum k" "metal-Cu-k" '
            f'"float roughness" {m.alpha:g} "bool remaproughness" false\n')


@material.register
def _(m: s.Hair):
    return (f'Material "hair" "float eumelanin" {m.eumelanin:g} "float pheomelanin" '
            f'{m.pheomelanin:g} "float beta_m" {m.beta_m:g} "float beta_n" {m.beta_n:g} '
            f'"float alpha" {m.alpha:g} "float eta" {m.eta:g}\n')


@functools.singledispatch
def shape(o):
    raise TypeError(o)


@shape.register
def _(o: s.Quad):
    light = f'AreaLightSource "diffuse" "rgb L" [ {numbers(o.emission)} ]\n' if o.emission else ""
    return (f'{light}Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ] '
            f'"point3 P" [ {numbers(o.corners)} ]\n')


@shape.register
def _(o: s.Sphere):
    return f'Translate {numbers(o.center)}\nShape "sphere" "float radius" {o.radius:g}\n'


@shape.register
def _(o: s.Mesh):
    return f'Shape "plymesh" "string filename" "{o.file}"\n'


@shape.register
def _(o: s.Strands):
    first, last = o.widths
    return "".join(
        'Shape "curve" "string type" "cylinder" "string basis" "bspline" "point3 P" '
        f'[ {numbers(p)} ] "float width0" {first:g} "float width1" {last:g}\n' for p in o.points)


def equal_area_directions(n):
    """Directions of the texels' centres of pbrt's square maps (Clarberg 2008), Z up."""
    centre = (np.arange(n) + 0.5) / n * 2 - 1
    u, v = np.meshgrid(centre, centre)
    up, vp = np.abs(u), np.abs(v)
    signed = 1 - (up + vp)
    r = 1 - np.abs(signed)
    phi = np.where(r > 0, (vp - up) / np.where(r > 0, r, 1) + 1, 1) * math.pi / 4
    z = np.copysign(1 - r * r, signed)
    side = r * np.sqrt(np.maximum(0, 2 - r * r))
    return np.stack([np.copysign(np.cos(phi), u) * side, np.copysign(np.sin(phi), v) * side, z], -1)


def write_pfm(path, pixels):
    height, width, _ = pixels.shape
    with open(path, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1\n".encode())
        pixels[::-1].astype("<f4").tofile(file)


def sky(light, folder):
    if light.radiance is None:
        return f'LightSource "infinite" "rgb L" [ {numbers(light.rgb)} ]\n'
    name = light.map or "sky-equal-area.pfm"
    path = folder / name  # a map's own path is absolute
    if not path.exists():
        # The map's Z axis is the scene's Y: Rotate -90 1 0 0 takes (x, y, z) to (x, z, -y).
        d = equal_area_directions(1024)
        world = np.stack([d[..., 0], d[..., 2], -d[..., 1]], -1)
        write_pfm(path, light.radiance(world))
    return ('AttributeBegin\nRotate -90 1 0 0\n'
            f'LightSource "infinite" "string filename" "{name}"\nAttributeEnd\n')


def header(scene, spp):
    size = scene.resolution
    return (f"# {scene.name}: written by bench/compare\n"
            f"LookAt {'  '.join(numbers(v) for v in scene.look_at)}\n"
            f'Camera "perspective" "float fov" {scene.fov:g}\n'
            f'Sampler "zsobol" "integer pixelsamples" {spp}\n'
            f'Integrator "path" "integer maxdepth" {scene.depth}\n'
            'PixelFilter "box" "float xradius" 0.5 "float yradius" 0.5\n'
            f'Film "rgb" "integer xresolution" {size} "integer yresolution" {size} '
            f'"string filename" "{scene.name}.exr"\nWorldBegin\n')


def write(scene, folder, spp=64):
    """Writes <folder>/<name>.pbrt and the files it needs; returns its path."""
    scene.write_files(folder)
    path = folder / f"{scene.name}.pbrt"
    with open(path, "w") as file:
        file.write(header(scene, spp))
        if scene.sky:
            file.write(sky(scene.sky, folder))
        for o in scene.objects:
            file.write("AttributeBegin\n" + material(o.material) + shape(o) + "AttributeEnd\n")
    return path
