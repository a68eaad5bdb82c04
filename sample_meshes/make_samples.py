# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the sample meshes: `python sample_meshes/make_samples.py [FOLDER]` (needs numpy).

out: one binary PLY file per mesh (double coordinates). Guarantee: the same bytes on every
machine, since only +, -, *, / and square roots are used, which IEEE 754 rounds in one way; and
coordinates are multiples of 2^-20, so that hosts of float and of double read the same mesh.
"""

import sys
from pathlib import Path

import numpy as np

GRID = 2.0**20
PI = 3.141592653589793


# --- arithmetic ---------------------------------------------------------------------------------


def sine(turns):
    """The sine of an angle in turns; exact at quarter turns. By its power series."""
    turns = np.asarray(turns, dtype=np.float64)
    quarter = np.floor(turns * 4 + 0.5)
    angle = (turns - quarter / 4) * (2 * PI)
    square = angle * angle
    odd, even = np.ones_like(angle), np.ones_like(angle)
    for k in range(18, 0, -2):
        odd = 1 - odd * square / (k * (k + 1))
        even = 1 - even * square / (k * (k - 1))
    odd = odd * angle
    values = np.stack([odd, even, -odd, -even])
    which = (quarter.astype(np.int64) % 4)[None]
    return np.take_along_axis(values, which, axis=0)[0]


def cosine(turns):
    """The cosine of an angle in turns."""
    return sine(np.asarray(turns) + 0.25)


def length(vectors):
    """The length of each row."""
    x, y, z = vectors[:, 0], vectors[:, 1], vectors[:, 2]
    return np.sqrt(x * x + y * y + z * z)


def turned(vertices, quaternion, shift=(0, 0, 0)):
    """The vertices turned by a quaternion of any length, then shifted."""
    w, x, y, z = quaternion
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    norm = w * w + x * x + y * y + z * z
    px, py, pz = vertices.T
    columns = [(r[0] * px + r[1] * py + r[2] * pz) / norm + s for r, s in zip(rows, shift)]
    return np.stack(columns, axis=1)


def bumps(points, waves):
    """The sum of plane waves (amplitude, direction in turns per unit) at each point."""
    x, y, z = points.T
    total = np.zeros(len(points))
    for amplitude, (kx, ky, kz) in waves:
        total = total + amplitude * sine(kx * x + ky * y + kz * z)
    return total


# --- shapes: each returns vertices and faces, counter-clockwise seen from outside -----------------


def octahedral_sphere(n):
    """The unit sphere with 8 n^2 faces: an octahedron with n steps along each edge."""
    index, faces = {}, []
    for sx, sy, sz in np.ndindex(2, 2, 2):
        sign = (1 - 2 * sx, 1 - 2 * sy, 1 - 2 * sz)
        even = (sx + sy + sz) % 2 == 0
        for steps in octant_triangles(n):
            points = [tuple(int(s * k) for s, k in zip(sign, step)) for step in steps]
            face = [index.setdefault(point, len(index)) for point in points]
            faces.append(face if even else face[::-1])
    # A quarter turn for n steps spaces the vertices more evenly than flat steps do.
    points = sine(np.array(list(index), dtype=np.float64) / (4 * n))
    return points / length(points)[:, None], np.array(faces)


def octant_triangles(n):
    """The triangles of x + y + z = n, x, y, z >= 0, cut into unit steps."""
    for i in range(n):
        for j in range(n - i):
            k = n - i - j
            yield (i, j, k), (i + 1, j, k - 1), (i, j + 1, k - 1)
            if k > 1:
                yield (i + 1, j, k - 1), (i + 1, j + 1, k - 2), (i, j + 1, k - 1)


def torus(nu, nv, centre_radius, tube_radius):
    """A torus about the z axis; tube_radius may be an array over (nu, nv)."""
    u, v = np.arange(nu)[:, None], np.arange(nv)[None, :]
    cu, su = cosine(u / nu), sine(u / nu)
    cv, sv = cosine(v / nv), sine(v / nv)
    distance = centre_radius + tube_radius * cv
    height = tube_radius * sv + 0 * cu
    points = np.stack([distance * cu, distance * su, height], axis=2).reshape(-1, 3)
    next_u, next_v = (u + 1) % nu, (v + 1) % nv
    return points, quads(u * nv + v, next_u * nv + v, next_u * nv + next_v, u * nv + next_v)


def quads(a, b, c, d):
    """Two triangles for each quad a b c d of index arrays."""
    a, b, c, d = (np.broadcast_to(x, np.broadcast(a, b, c, d).shape).ravel() for x in (a, b, c, d))
    return np.stack([a, b, c, a, c, d], axis=1).reshape(-1, 3)


def cylinder(sides, radius, half_height):
    """A closed prism about the z axis: two rings and a middle vertex for each cap."""
    k = np.arange(sides)
    ring = np.stack([radius * cosine(k / sides), radius * sine(k / sides)], axis=1)
    low = np.column_stack([ring, np.full(sides, -half_height)])
    high = np.column_stack([ring, np.full(sides, half_height)])
    middles = np.array([[0, 0, -half_height], [0, 0, half_height]])
    after = (k + 1) % sides
    walls = quads(k, after, sides + after, sides + k)
    bottom = np.stack([np.full(sides, 2 * sides), after, k], axis=1)
    top = np.stack([np.full(sides, 2 * sides + 1), sides + k, sides + after], axis=1)
    return np.concatenate([low, high, middles]), np.concatenate([walls, bottom, top])


def wavy_slab(n, half_width, thickness, waves):
    """A square sheet of n x n quads with waves, as a solid of constant thickness along z."""
    i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1), indexing="ij")
    x, y = ((2 * k / n - 1).ravel() * half_width for k in (i, j))
    height = bumps(np.stack([x, y, 0 * x], axis=1), waves)
    top = np.stack([x, y, height + thickness / 2], axis=1)
    bottom = np.stack([x, y, height - thickness / 2], axis=1)
    number = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    sheet = quads(number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:])
    rim = np.concatenate([number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]])
    after, below = np.roll(rim, -1), (n + 1) ** 2
    wall = quads(below + rim, below + after, after, rim)
    return np.concatenate([top, bottom]), np.concatenate([sheet, below + sheet[:, ::-1], wall])


def joined(*meshes):
    """Several meshes as one."""
    offsets = np.cumsum([0] + [len(vertices) for vertices, _ in meshes])
    faces = [faces + offset for (_, faces), offset in zip(meshes, offsets)]
    return np.concatenate([vertices for vertices, _ in meshes]), np.concatenate(faces)


# --- the statue: an implicit solid, by marching tetrahedra ----------------------------------------

# Bones of the figure: from, to, radius at both ends. Arms akimbo and parted legs: genus 3.
BONES = (
    ((-0.17, 0.00, 0.15), (-0.11, 0.00, 0.95), 0.085, 0.115),
    ((0.17, 0.00, 0.15), (0.11, 0.00, 0.95), 0.085, 0.115),
    ((0.00, 0.00, 0.98), (0.00, 0.02, 1.42), 0.190, 0.220),
    ((-0.24, 0.02, 1.50), (-0.50, 0.06, 1.20), 0.085, 0.070),
    ((0.24, 0.02, 1.50), (0.50, 0.06, 1.20), 0.085, 0.070),
    ((-0.50, 0.06, 1.20), (-0.17, -0.02, 0.97), 0.070, 0.060),
    ((0.50, 0.06, 1.20), (0.17, -0.02, 0.97), 0.070, 0.060),
    ((0.00, 0.00, 1.50), (0.00, -0.02, 1.75), 0.085, 0.080),
    ((0.00, -0.03, 1.85), (0.00, -0.05, 1.93), 0.165, 0.150),
)
PLINTH_CENTRE, PLINTH_HALF, PLINTH_ROUND = (0.0, 0.0, 0.07), (0.34, 0.22, 0.05), 0.04
STATUE_WAVES = (
    (0.010, (2.9, 1.3, 3.7)),
    (0.010, (-3.1, 2.3, 2.2)),
    (0.007, (1.7, -4.9, 5.1)),
)


def smooth_minimum(a, b, width):
    """The smaller value, rounded off where the two differ by less than width."""
    overlap = np.maximum(width - np.abs(a - b), 0) / width
    return np.minimum(a, b) - overlap * overlap * (width / 4)


def bone_distance(points, start, end, start_radius, end_radius):
    """The distance from a capsule whose radius changes along it."""
    start, axis = np.array(start), np.array(end) - np.array(start)
    offset = points - start
    along = offset[:, 0] * axis[0] + offset[:, 1] * axis[1] + offset[:, 2] * axis[2]
    square = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]
    along = np.minimum(np.maximum(along / square, 0), 1)
    nearest = offset - along[:, None] * axis
    return length(nearest) - (start_radius + along * (end_radius - start_radius))


def statue_distance(points):
    """Negative inside the statue."""
    outside = np.maximum(np.abs(points - np.array(PLINTH_CENTRE)) - np.array(PLINTH_HALF), 0)
    distance = length(outside) - PLINTH_ROUND
    for bone in BONES:
        distance = smooth_minimum(distance, bone_distance(points, *bone), 0.05)
    return distance + bumps(points, STATUE_WAVES)


# A cube's corners are numbered by their bits x + 2 y + 4 z. Its six tetrahedra run from corner 0
# to corner 7; the second half would be mirrored and has two corners exchanged.
CUBE_TETRAHEDRA = (
    (0, 1, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 3, 2, 7), (0, 6, 4, 7), (0, 5, 1, 7),
)
# Even orders of a tetrahedron's corners.
LONE_CORNER = ((0, 1, 2, 3), (1, 0, 3, 2), (2, 0, 1, 3), (3, 0, 2, 1))
CORNER_PAIR = (
    (0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (2, 3, 0, 1), (3, 1, 0, 2), (1, 2, 0, 3),
)


def marching_tetrahedra(distance, low, counts, step):
    """The zero surface of a function on a grid of cubes, each cut into six tetrahedra."""
    axes = [low[i] + step * np.arange(counts[i] + 1) for i in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=3).reshape(-1, 3)
    values = distance(grid)
    number = np.arange(len(grid)).reshape([count + 1 for count in counts])
    corners = []
    for bits in range(8):
        shift = [(bits >> i) & 1 for i in range(3)]
        ranges = tuple(slice(s, s + count) for s, count in zip(shift, counts))
        corners.append(number[ranges].ravel())
    edges = np.concatenate(
        [
            tetrahedron_triangles(np.stack([corners[bits] for bits in tetrahedron], 1), values < 0)
            for tetrahedron in CUBE_TETRAHEDRA
        ]
    )
    ends, faces = np.unique(np.sort(edges, axis=2).reshape(-1, 2), axis=0, return_inverse=True)
    weight = (values[ends[:, 0]] / (values[ends[:, 0]] - values[ends[:, 1]]))[:, None]
    points = grid[ends[:, 0]] + weight * (grid[ends[:, 1]] - grid[ends[:, 0]])
    return points, faces.reshape(-1, 3)


def tetrahedron_triangles(tetrahedra, inside):
    """The triangles that part inside from outside, corners as grid edges: m x 3 x 2."""
    pattern = (inside[tetrahedra] * np.array([1, 2, 4, 8])).sum(axis=1)
    triangles = []
    for p, q, r, s in LONE_CORNER:
        corners = np.array([[p, q], [p, r], [p, s]])
        triangles.append(tetrahedra[pattern == 1 << p][:, corners])
        triangles.append(tetrahedra[pattern == 15 - (1 << p)][:, corners[::-1]])
    for p, q, r, s in CORNER_PAIR:
        found = tetrahedra[pattern == (1 << p) + (1 << q)]
        triangles.append(found[:, np.array([[p, r], [p, s], [q, s]])])
        triangles.append(found[:, np.array([[p, r], [q, s], [q, r]])])
    return np.concatenate(triangles)


def relaxed(points, faces, distance, rounds):
    """Moves each vertex to the middle of its neighbours, then back onto the zero surface."""
    start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    degree = np.bincount(start, minlength=len(points))
    for _ in range(rounds):
        sums = [np.bincount(start, weights=points[end, i], minlength=len(points)) for i in range(3)]
        points = points + 0.7 * (np.stack(sums, axis=1) / degree[:, None] - points)
        for _ in range(2):
            points = projected(points, distance)
    return points


def projected(points, distance):
    """One Newton step along the gradient, by central differences."""
    step = 2.0**-12
    gradient = np.stack(
        [distance(points + step * axis) - distance(points - step * axis) for axis in np.eye(3)],
        axis=1,
    ) / (2 * step)
    steepness = length(gradient)
    return points - (distance(points) / (steepness * steepness))[:, None] * gradient


# --- the samples ----------------------------------------------------------------------------------


def bumpy_sphere():
    points, faces = octahedral_sphere(28)
    waves = ((0.05, (1.1, 0.4, -0.3)), (0.05, (-0.5, 1.2, 0.6)), (0.04, (0.7, -0.8, 1.3)))
    return points * (0.95 + bumps(points, waves))[:, None], faces


def ribbed_torus():
    nu, nv = 112, 32
    u, v = np.arange(nu)[:, None], np.arange(nv)[None, :]
    radius = 0.27 + 0.03 * sine(9 * u / nu + 2 * v / nv)
    points, faces = torus(nu, nv, 0.78, radius)
    return turned(points, (7, 3, 2, 1), (0.62, 0.11, 0.17)), faces


def nested_outer():
    points, faces = octahedral_sphere(16)
    return turned(points * np.array([1.0, 0.8, 0.7]), (5, 1, 2, 3)), faces


def nested_inner():
    points, faces = torus(24, 12, 0.3, 0.11)
    return turned(points, (3, -1, 1, 2), (0.05, -0.04, 0.03)), faces


def two_balls():
    points, faces = octahedral_sphere(10)
    left = turned(0.45 * points, (9, 1, 2, 4), (-0.62, 0.03, 0.05))
    right = turned(0.38 * points, (4, -3, 1, 2), (0.58, -0.06, -0.02))
    return joined((left, faces), (right, faces))


def hollow_ball():
    points, faces = octahedral_sphere(12)
    inner, inner_faces = octahedral_sphere(8)
    cavity = turned(0.62 * inner, (5, 2, 1, 1), (0.04, 0.02, -0.05))
    outer = turned(0.9 * points, (6, 1, 3, 2))
    return joined((outer, faces), (cavity, inner_faces[:, ::-1]))


def bar():
    points, faces = cylinder(40, 0.21, 1.35)
    return turned(points, (8, 1, 7, 2), (0.03, 0.02, 0.01)), faces


def wide_cylinder():
    points, faces = cylinder(72, 0.5, 1.1)
    return turned(points, (30, 1, 2, 3)), faces


def narrow_cylinder():
    points, faces = cylinder(56, 0.3, 1.2)
    return turned(points, (9, 8, 1, 2), (0.03, 0.02, 0.06)), faces


def statue():
    low, counts = (-0.70, -0.40, -0.12), (24, 14, 39)
    points, faces = marching_tetrahedra(statue_distance, low, counts, 0.0585)
    return relaxed(points, faces, statue_distance, 8), faces


def wavy_cutter():
    waves = ((0.05, (1.1, 0.5, 0)), (0.04, (-0.7, 1.4, 0)), (0.02, (2.1, 1.9, 0)))
    points, faces = wavy_slab(36, 0.8, 0.16, waves)
    return turned(points, (12, 2, 1, 3), (0.02, 0.01, 1.18)), faces


def cylinder_along_x():
    points, faces = cylinder(48, 0.5, 1.25)
    return points[:, [2, 0, 1]], faces


def cylinder_along_y():
    # The cylinder along x with x and y exchanged; a mirror image, so the faces turn over.
    points, faces = cylinder_along_x()
    return points[:, [1, 0, 2]], faces[:, ::-1]


def torus_about_z():
    return torus(64, 24, 0.75, 0.25)


def torus_about_x():
    points, faces = torus_about_z()
    return points[:, [2, 1, 0]], faces[:, ::-1]


SAMPLES = (
    bumpy_sphere,
    ribbed_torus,
    nested_outer,
    nested_inner,
    two_balls,
    hollow_ball,
    bar,
    wide_cylinder,
    narrow_cylinder,
    statue,
    wavy_cutter,
    cylinder_along_x,
    cylinder_along_y,
    torus_about_z,
    torus_about_x,
)


def ply_bytes(vertices, faces):
    """A binary PLY file of double coordinates, rounded to multiples of 2^-20."""
    header = (
        "ply\nformat binary_little_endian 1.0\ncomment Index Boolean sample, CC0-1.0\n"
        f"element vertex {len(vertices)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    records = np.empty(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    records["count"], records["corners"] = 3, faces
    coordinates = np.rint(vertices * GRID) / GRID + 0.0
    return header.encode() + coordinates.astype("<f8").tobytes() + records.tobytes()


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    folder.mkdir(parents=True, exist_ok=True)
    for sample in SAMPLES:
        (folder / f"{sample.__name__}.ply").write_bytes(ply_bytes(*sample()))


if __name__ == "__main__":
    main()
