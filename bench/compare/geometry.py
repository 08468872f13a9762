"""Shapes and the sky of the benchmark scenes; deterministic."""

import math

import numpy as np

from .scene import Quad


def sphere_directions(n):
    """n directions spread evenly (Fibonacci)."""
    k = np.arange(n) + 0.5
    y, phi = 1 - 2 * k / n, k * math.pi * (3 - math.sqrt(5))
    r = np.sqrt(1 - y * y)
    return np.stack([r * np.cos(phi), y, r * np.sin(phi)], 1)


def normalized(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def hair_ball(n):
    """n curly strands of six control points on a sphere of radius 0.55."""
    rng = np.random.default_rng(11)
    root = normalized(sphere_directions(n) + rng.normal(0, 0.012, (n, 3)))
    steep = np.abs(root[:, :1]) > 0.8
    t = normalized(np.cross(root, np.where(steep, [[0, 1.0, 0]], [[1.0, 0, 0]])))
    b = np.cross(root, t)
    length = 0.38 * (1 + 0.25 * rng.standard_normal((n, 1)).clip(-1.5, 1.5))
    comb = np.stack([np.sin(3 * root[:, 1] + 1), np.full(n, -0.6), np.cos(3 * root[:, 0])], 1)
    comb -= root * np.sum(comb * root, 1, keepdims=True)
    phase = rng.uniform(0, 2 * math.pi, (n, 1))
    radius = 0.03 * rng.uniform(0.3, 1, (n, 1))
    turns = rng.uniform(0.6, 1.2, (n, 1))
    points = np.zeros((n, 6, 3))
    for i in range(6):
        u = max((i - 1) / 3, -0.05)  # a B-spline starts near its second point
        angle = phase + 2 * math.pi * turns * u
        points[:, i] = root * (0.55 + length * u * (1 - 0.25 * u))
        points[:, i] += comb * (length * 0.55 * u * abs(u))
        points[:, i] += (t * np.cos(angle) + b * np.sin(angle)) * radius * u
    return points


def _ridges(directions):
    """Height: plane waves with ridges, six octaves of five."""
    rng = np.random.default_rng(5)
    height = np.zeros(directions.shape[:-1])
    for octave in range(6):
        amplitude, frequency = 0.08 * 0.55**octave, 3 * 1.9**octave
        for _ in range(5):
            k = normalized(rng.normal(size=3))
            wave = np.abs(np.sin(frequency * (directions @ k) + rng.uniform(0, 6.28)))
            height += amplitude * (1 - wave) * 0.5
    return height


def bumpy_sphere(nu, nv):
    """(positions, normals, triangles) of a displaced sphere of 2 nu (nv - 1) triangles."""
    v = np.linspace(1e-3, math.pi - 1e-3, nv)
    V, U = np.meshgrid(v, np.arange(nu) / nu * 2 * math.pi, indexing="ij")
    d = np.stack([np.sin(V) * np.cos(U), np.cos(V), np.sin(V) * np.sin(U)], -1)
    P = d * (0.8 + _ridges(d))[..., None]
    across = np.cross(np.roll(P, -1, 1) - np.roll(P, 1, 1), np.gradient(P, axis=0))
    N = normalized(across)
    N *= np.sign(np.sum(N * d, -1, keepdims=True))
    i, j = np.meshgrid(np.arange(nv - 1), np.arange(nu), indexing="ij")
    next_j = (j + 1) % nu
    a, b, c, e = i * nu + j, i * nu + next_j, (i + 1) * nu + next_j, (i + 1) * nu + j
    triangles = [np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, e))]
    return P.reshape(-1, 3), N.reshape(-1, 3), np.concatenate(triangles)


def wavy_grid(n):
    """(positions, normals, triangles) of a height field of 2 n n triangles; cheap to make."""
    x, z = np.meshgrid(*[np.linspace(-1, 1, n + 1, dtype=np.float32)] * 2, indexing="ij")
    positions = np.stack([x, np.sin(40 * x) * np.sin(40 * z) / 20, z], -1).reshape(-1, 3)
    normals = np.broadcast_to(np.array([0, 1, 0], np.float32), positions.shape)
    first = (np.arange(n, dtype=np.int32)[:, None] * (n + 1) + np.arange(n, dtype=np.int32)).ravel()
    triangles = [np.stack([first, first + 1, first + n + 2], 1),
                 np.stack([first, first + n + 2, first + n + 1], 1)]
    return positions, normals, np.concatenate(triangles)


def write_ply(path, positions, normals, triangles):
    """Binary PLY, little endian."""
    vertices = np.concatenate([positions, normals], 1).astype("<f4")
    faces = np.zeros(len(triangles), dtype=[("n", "u1"), ("i", "<i4", 3)])
    faces["n"], faces["i"] = 3, triangles
    names = "".join(f"property float {p}\n" for p in ("x", "y", "z", "nx", "ny", "nz"))
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n{names}"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    with open(path, "wb") as file:
        file.write(header.encode())
        vertices.tofile(file)
        faces.tofile(file)


def evening_sky(directions):
    """Gradient, a warm sun lobe and a cool soft box; Y up."""
    up = directions[..., 1:2]
    sky = np.where(up > 0, 0.35 + np.array([0.25, 0.45, 0.8]) * up * 0.6, [0.10, 0.09, 0.08])

    def lobe(toward, kappa, color):
        cosine = directions @ normalized(np.array(toward))
        return np.exp(kappa * (cosine - 1))[..., None] * np.array(color)

    return sky + lobe((0.6, 0.75, 0.5), 900, (140, 118, 90)) + lobe(
        (-0.8, 0.35, 0.3), 30, (1.5, 2.2, 3.2)
    )


def box(low, high, left, right, rest):
    """The six walls, normals inward; the front one is behind the camera."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    return [
        Quad(((x0, y0, z0), (x0, y0, z1), (x1, y0, z1), (x1, y0, z0)), rest),
        Quad(((x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1)), rest),
        Quad(((x0, y0, z1), (x0, y1, z1), (x1, y1, z1), (x1, y0, z1)), rest),
        Quad(((x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0)), rest),
        Quad(((x0, y0, z0), (x0, y1, z0), (x0, y1, z1), (x0, y0, z1)), left),
        Quad(((x1, y0, z0), (x1, y0, z1), (x1, y1, z1), (x1, y1, z0)), right),
    ]


def floor(half, y, material):
    return Quad(((-half, y, -half), (-half, y, half), (half, y, half), (half, y, -half)), material)


def lamp(x, z, half, y, material, emission):
    """A square light that faces down."""
    x0, x1, z0, z1 = x - half, x + half, z - half, z + half
    return Quad(((x0, y, z0), (x1, y, z0), (x1, y, z1), (x0, y, z1)), material, emission)
