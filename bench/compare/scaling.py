"""Cost of this renderer against the size of the scene: triangles, curves, lights, textures, threads;
start-up, and how fast scenes and meshes are read."""

import dataclasses
import shutil
import time

import numpy as np

from . import geometry as g
from . import runs, write_pbrt
from .scene import Copper, Diffuse, Hair, Mesh, Scene, Sky, Sphere, Strands

LOOK = ((0, 0.5, -3.6), (0, 0, 0), (0, 1, 0))
SIZE, SPP = 200, 16
GREY = Diffuse((0.5, 0.5, 0.5))


@dataclasses.dataclass
class Point:
    """One size of one series."""

    series: str
    size: int
    input_bytes: int
    load: float
    render: float
    samples: int
    peak: int
    traversal: int
    parse: float  # part of load
    mse: float = 0.0  # of two pictures against each other, halved, over the mean's square

    def nanoseconds(self):
        """Of one camera sample."""
        return self.render / self.samples * 1e9

    def memory_ratio(self):
        return runs.memory_ratio(self.peak, self.traversal, self.input_bytes)


def point(series, size, path, threads, seeds=(0, 1), spp=SPP, options=()):
    """Renders a scene file once per seed; the least seconds."""
    done = [runs.pbrt(path, threads, spp, seed, options) for seed in seeds]
    best = min(done, key=lambda r: r.render)
    pixels = best.picture.shape[0] * best.picture.shape[1]
    result = Point(series, size, runs.input_bytes(path), min(r.load for r in done), best.render,
                   pixels * spp, max(r.peak for r in done), best.traversal,
                   min(r.parse for r in done))
    if len(done) > 1:
        a, b = done[0].picture, done[1].picture
        result.mse = float(((a - b) ** 2).mean() / 2 / ((a + b).mean() / 2) ** 2)
    print(f"  {series} {size}: load {result.load:.2f} s, {result.nanoseconds():.0f} ns a sample, "
          f"{result.peak >> 20} MiB", flush=True)
    return result


def write(folder, objects, sky=Sky(rgb=(0.6, 0.6, 0.6)), name="scene", **more):
    """A small scene in a folder of its own."""
    shutil.rmtree(folder, ignore_errors=True)
    scene = Scene(name, LOOK, 34, objects, sky, resolution=SIZE, depth=5, **more)
    return write_pbrt.write(scene, folder, SPP)


def mesh_file(triangles):
    """A writer of a displaced sphere of about so many triangles."""
    nv = max(3, round((triangles / 4) ** 0.5) + 1)
    return lambda path: g.write_ply(path, *g.bumpy_sphere(2 * (nv - 1), nv))


def triangles(folder, threads, sizes=(10**4, 10**5, 10**6, 10**7)):
    for n in sizes:
        path = write(folder, [Mesh("mesh.ply", GREY)], files={"mesh.ply": mesh_file(n)})
        yield point("triangles", n, path, threads)


def curves(folder, threads, sizes=(10**3, 10**4, 10**5, 10**6)):
    """Segments, three to a strand, hairs; thinner the more there are."""
    for n in sizes:
        width = 0.004 * (50000 * 3 / n) ** 0.5
        hair = Strands(g.hair_ball(n // 3), (width, width / 2), Hair(0.35, 0.15))
        yield point("curve segments", n, write(folder, [hair]), threads)


def lamps(n):
    """n square lamps of unequal strength in a plane over a ball, together as strong as one."""
    rng = np.random.default_rng(3)
    side = int(np.ceil(n**0.5))
    step = 3.0 / side
    strength = rng.uniform(0.2, 1.8, n)
    strength *= 8 * n / strength.sum()
    black = Diffuse((0, 0, 0))
    for k in range(n):
        x, z = (k % side + 0.5) * step - 1.5, (k // side + 0.5) * step - 1.5
        half = 0.3 / n**0.5
        yield g.lamp(x, z, half, 2.2, black, tuple(strength[k] * np.array([1.0, 0.95, 0.9])))


def lights(folder, threads, sizes=(1, 10, 100, 1000, 10**4)):
    """Chosen by the tree, and by power alone."""
    room = [g.floor(4, -1, GREY), Sphere((0, 0, 0), 0.8, GREY)]
    for sampler in ("bvh", "power"):
        for n in sizes:
            path = write(folder, room + list(lamps(n)), sky=None)
            text = path.read_text()
            path.write_text(text.replace('"path"', f'"path" "string lightsampler" "{sampler}"', 1))
            yield point(f"lights, {sampler}", n, path, threads)


def picture_tile(path, k):
    rng = np.random.default_rng(k)
    write_pbrt.write_pfm(path, rng.uniform(0.2, 0.8, (64, 64, 3)))


def textures(folder, threads, sizes=(1, 10, 100, 1000)):
    """One ground of a thousand quads that share n pictures."""
    for n in sizes:
        path = write(folder, [])
        lines = []
        for k in range(n):
            picture_tile(folder / f"{k}.pfm", k)
            lines.append(f'Texture "t{k}" "spectrum" "imagemap" "string filename" "{k}.pfm"\n')
        for q in range(1000):
            x, y = q % 40 / 20 - 1, q // 40 / 12.5 - 1
            corners = [[x, y, 0], [x, y + 0.08, 0], [x + 0.05, y + 0.08, 0], [x + 0.05, y, 0]]
            lines.append(f'Material "diffuse" "texture reflectance" "t{q % n}"\n'
                         'Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ] '
                         '"point2 uv" [ 0 0 0 1 1 1 1 0 ] '
                         f'"point3 P" [ {write_pbrt.numbers(corners)} ]\n')
        with open(path, "a") as file:
            file.writelines(lines)
        yield point("textures", n, path, threads)


def threads_series(folder, threads):
    """The same mesh on one and more threads."""
    path = write(folder, [Mesh("mesh.ply", Copper(0.2))], files={"mesh.ply": mesh_file(10**6)})
    for n in range(1, threads + 1):
        yield point("threads", n, path, n, spp=4 * SPP)


MATERIALS = {
    "conductor": 'Material "conductor" "float roughness" 0.3 "bool remaproughness" false\n',
    "hair": 'Material "hair" "float eumelanin" 0.35\n',
    "diffuse": 'Material "diffuse"\n',
    "featherbarbule": 'Material "featherbarbule"\n',
}


def materials(folder, threads):
    """The same cylinder-like patch covered with each material; size is the material's place."""
    for k, (name, text) in enumerate(MATERIALS.items()):
        path = write(folder, [])
        with open(path, "a") as file:
            file.write('LightSource "distant" "point3 from" [ 1 2 -3 ]\n' + text
                       + 'Rotate 90 1 0 0 Shape "cylinder" "float radius" 0.9 '
                       '"float zmin" -0.9 "float zmax" 0.9\n')
        yield point(f"material {name}", k, path, threads, spp=4 * SPP)


SERIES = (triangles, curves, lights, textures, threads_series, materials)


def start_up(folder, threads):
    """Least wall seconds of rendering an empty scene of one pixel."""
    path = write(folder, [], sky=None)
    seconds = []
    for _ in range(5):
        start = time.perf_counter()
        runs.pbrt(path, threads, 1, 0, ["--pixel", "1,1"])
        seconds.append(time.perf_counter() - start)
    return min(seconds)


def text_scene(path, megabytes):
    """A scene text of short shapes and long arrays, half by half."""
    rng = np.random.default_rng(1)
    body = write_pbrt.numbers(rng.uniform(-1, 1, 30000))
    indices = " ".join(str(i) for i in range(9999))
    mesh = f'Shape "trianglemesh" "integer indices" [ {indices} ] "point3 P" [ {body} ]\n'
    short = ("AttributeBegin\nTranslate 0.25 -0.5 1.75\n"
             'Material "diffuse" "rgb reflectance" [ 0.5 0.25 0.125 ]\n'
             'Shape "sphere" "float radius" 0.001\nAttributeEnd\n')
    chunk = mesh + short * (len(mesh) // len(short))
    with open(path, "a") as file:
        for _ in range(megabytes * 1000000 // len(chunk)):
            file.write(chunk)


def parsing(folder, threads, text_megabytes, ply_triangles):
    """Reading a long scene text, and a large binary PLY: Points named by what is read."""
    one = ["--pixel", "1,1"]
    path = write(folder, [])
    text_scene(path, text_megabytes)
    yield point("scene text, MB", text_megabytes, path, threads, (0,), 1, one)
    n = round((ply_triangles / 2) ** 0.5)
    grid = {"mesh.ply": lambda file: g.write_ply(file, *g.wavy_grid(n))}
    path = write(folder, [Mesh("mesh.ply", GREY)], files=grid)
    size = (folder / "mesh.ply").stat().st_size // 1000000
    yield point("binary PLY, MB", size, path, threads, (0,), 1, one)
    shutil.rmtree(folder)


def all_series(build, threads):
    """Every series in turn, as a list of Points."""
    return [p for series in SERIES for p in series(build / "scaling", threads)]
