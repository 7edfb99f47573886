"""Beds and drums of spheres from the settled packings of bench/data, the same for this program and for the others."""
import csv
import gzip
import math
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from scene_text import QUIET, SOFT  # noqa: E402

DATA = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "data")
DT, SKIN = 1e-5, 2e-4  # s, m
NOT_TURNED = "run.turn_spheres=false"  # LAMMPS and LIGGGHTS do not follow where spheres point either
MATERIAL = SOFT + """
[[shape]]
name = "ball"
kind = "sphere"
radius = 0.001

[[bodies_csv]]
file = "bodies.csv"
shape = "ball"
material = "soft"
"""
HEAD = """[run]
steps = 1000
dt = 1e-5

""" + QUIET + """
[world]
gravity = [0, 0, -9.81]

[law]
name = "hertz_mindlin"

"""


def packing(name):
    """Rows (x, y, z, radius) of a settled bed, m, and its width along x and y."""
    with gzip.open(os.path.join(DATA, f"spheres_{name}.csv.gz"), "rt", encoding="ascii") as lines:
        width = float(re.findall(r"=0,([\d.]+)", lines.readline())[0])
        next(lines)
        return [tuple(map(float, line.split(","))) for line in lines], width


def bed(count):
    """Rows and widths along x and y: a packing, or for 1e6 bodies that of 1e5 in 5 x 2 copies."""
    if count in (10_000, 100_000):
        rows, width = packing("1e4" if count == 10_000 else "1e5")
        return rows, width, width
    if count != 1_000_000:
        raise SystemExit(f"no bed of {count} spheres: 10000, 100000 or 1000000")
    rows, width = packing("1e5")
    return [(x + i * width, y + j * width, z, r) for i in range(5) for j in range(2) for x, y, z, r in rows], 5 * width, 2 * width


DRUM_RADIUS, DRUM_WIDTH, DRUM_RATE, DRUM_TILT = 0.085, 0.0706, 2.4, math.radians(25)  # m, m, rad/s


def drum():
    """Rows (x, y, z, radius) of a drum about the y axis, not quite half full, its bed tilted so that it flows at once: the
    bed of 1e5 spheres, two side by side, of which those inside are taken."""
    rows, width = packing("1e5")
    top = max(z + r for _, _, z, r in rows)
    cosine, sine = math.cos(DRUM_TILT), math.sin(DRUM_TILT)
    inside = []
    for tile in (-1, 0):
        for x, y, z, r in rows:
            x, z = x + tile * width, z - DRUM_RADIUS + (DRUM_RADIUS - top - 5e-3)
            if math.hypot(x, z) + r < DRUM_RADIUS and r < y < DRUM_WIDTH - r:
                inside.append((cosine * x - sine * z, y - DRUM_WIDTH / 2, sine * x + cosine * z, r))
    return inside


COLUMNS = ("x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz")


def bodies_csv(path, rows):
    """Rows of places and radii, or with velocities and spins too."""
    with open(path, "w", encoding="ascii") as out:
        out.write(",".join(COLUMNS[:len(rows[0])]) + "\n")
        out.writelines(",".join(map(repr, row)) + "\n" for row in rows)


def flowing(final, rows):
    """The rows of a drum as a run's final.csv left them, moving; radii from the rows that it began with."""
    with open(final, encoding="ascii") as file:
        table = csv.DictReader(file)
        return [tuple(row[3] if c == "radius" else float(line[c]) for c in COLUMNS) for line, row in zip(table, rows, strict=True)]


def write_bed(folder, rows, size_x, size_y):
    """bed.toml for this program, bed.data for LAMMPS and LIGGGHTS, bed.txt for YADE."""
    bodies_csv(os.path.join(folder, "bodies.csv"), rows)
    planes = (("floor", (0, 0, 0), (0, 0, 1)), ("left", (0, 0, 0), (1, 0, 0)), ("right", (size_x, 0, 0), (-1, 0, 0)),
              ("front", (0, 0, 0), (0, 1, 0)), ("back", (0, size_y, 0), (0, -1, 0)))
    walls = "".join(f'\n[[wall]]\nname = "{name}"\nkind = "plane"\nmaterial = "soft"\npoint = {list(point)}\nnormal = {list(normal)}\n'
                    for name, point, normal in planes)
    with open(os.path.join(folder, "bed.toml"), "w", encoding="ascii") as out:
        out.write(HEAD + MATERIAL + walls)
    write_data(os.path.join(folder, "bed.data"), rows, ((0, size_x), (0, size_y), (0, 1.15 * max(row[2] for row in rows))))
    with open(os.path.join(folder, "bed.txt"), "w", encoding="ascii") as out:
        out.writelines(f"{x!r} {y!r} {z!r} {r!r}\n" for x, y, z, r in rows)


def write_drum(folder, rows):
    bodies_csv(os.path.join(folder, "bodies.csv"), rows)
    wall = f"""
[[wall]]
name = "drum"
kind = "drum"
material = "soft"
base = [0, {-DRUM_WIDTH / 2}, 0]
top = [0, {DRUM_WIDTH / 2}, 0]
radius = {DRUM_RADIUS}
segments = 128
motion = "rotation"
axis = [0, 1, 0]
centre = [0, 0, 0]
rate = {DRUM_RATE}
"""
    with open(os.path.join(folder, "drum.toml"), "w", encoding="ascii") as out:
        out.write(HEAD + MATERIAL + wall)
    reach = (-DRUM_RADIUS, DRUM_RADIUS)
    write_data(os.path.join(folder, "drum.data"), rows, (reach, (-DRUM_WIDTH / 2, DRUM_WIDTH / 2), reach))


def write_data(path, rows, box, margin=1e-3):
    with open(path, "w", encoding="ascii") as out:
        out.write(f"spheres\n\n{len(rows)} atoms\n1 atom types\n\n")
        for axis, (lower, upper) in zip("xyz", box):
            out.write(f"{lower - margin:.9g} {upper + margin:.9g} {axis}lo {axis}hi\n")
        out.write("\nAtoms\n\n")
        for number, (x, y, z, radius, *_) in enumerate(rows, 1):
            out.write(f"{number} 1 {2 * radius:.9g} 2500.0 {x:.9g} {y:.9g} {z:.9g}\n")
        if len(rows[0]) > 4:
            out.write("\nVelocities\n\n")
            for number, row in enumerate(rows, 1):
                out.write(f"{number} " + " ".join(map(repr, row[4:])) + "\n")
