"""Settled beds of bodies of one kind, for the timings of compare.py.

A tile of a bed, periodic along its floor, is poured and settles once (minutes a kind, kept in a cache folder); its
copies side by side are the bed. All bodies have the volume of a sphere of 1 mm radius, in the plane the area of a disc of 1 mm,
and the material of the spheres' bed."""
import csv
import json
import math
import os
import subprocess

from programs import run_dem
from scene_text import QUIET, SOFT  # found by programs

RADIUS = 1e-3
VOLUME = 4 / 3 * math.pi * RADIUS**3
AREA = math.pi * RADIUS**2
GRAINS = ("cement140_03", "ma165_01", "ma165_02", "sacci425_02", "sacci425_06", "sika-fib_04")

# A cross of five squares, edge a: area 5 a².
CROSS_EDGE = math.sqrt(AREA / 5)
CROSS = [(x * CROSS_EDGE / 2, y * CROSS_EDGE / 2, 0) for x, y in
         ((1, -3), (1, -1), (3, -1), (3, 1), (1, 1), (1, 3), (-1, 3), (-1, 1), (-3, 1), (-3, -1), (-1, -1), (-1, -3))]


def grains(prefix):
    return {f"grain_{i}": f'kind = "polyhedron"\nfile = "{prefix}:{name}"\ndiameter = {2 * RADIUS}'
            for i, name in enumerate(GRAINS)}


def polygon(vertices):
    return 'kind = "polygon"\nvertices = ' + json.dumps([list(v) for v in vertices])


KINDS = {  # bed: (its shapes: tables of a scene, lies it in the plane?)
    "spheres": ({"ball": f'kind = "sphere"\nradius = {RADIUS}'}, False),
    "ellipsoids": ({"seed": 'kind = "ellipsoid"\nsemi_axes = ' + str([RADIUS / 2**(1 / 3)] * 2 + [RADIUS * 4**(1 / 3)])}, False),
    "cubes": ({"cube": 'kind = "box"\nextents = ' + str([VOLUME**(1 / 3)] * 3)}, False),
    "icosahedra": ({"icosahedron": f'kind = "icosahedron"\ncircumradius = {(VOLUME / 2.5361507101204093)**(1 / 3)}'}, False),
    "grains_coarse": (grains("grain"), False),
    "grains_fine": (grains("grain-fine"), False),
    "sizes_1_20": ({"fine": f'kind = "sphere"\nradius = {RADIUS / 2}', "boulder": f'kind = "sphere"\nradius = {RADIUS * 10}'}, False),
    "discs": ({"disc": f'kind = "disc"\nradius = {RADIUS}'}, True),
    "ellipses": ({"ellipse": f'kind = "ellipse"\nsemi_axis_a = {RADIUS * math.sqrt(2)}\nsemi_axis_b = {RADIUS / math.sqrt(2)}'}, True),
    "hexagons": ({"hexagon": 'kind = "regular_polygon"\nsides = 6\ncircumradius = '
                  + str(math.sqrt(2 * AREA / (3 * math.sqrt(3))))}, True),
    "crosses": ({"cross": polygon(CROSS)}, True),
}
FINE, BOULDERS = 30_000, 5  # bodies of sizes_1_20: about as much of either


def tile_of(name):
    """Bodies and width of a tile, m."""
    if name == "sizes_1_20":
        return FINE + BOULDERS, 45e-3
    return (1250, 50e-3) if KINDS[name][1] else (1250, 14.2e-3)


def scene(shapes, plane, width, run, bodies):
    """The text of a scene: bodies over a floor in a box of this width (two widths in space), periodic along the floor."""
    tables = "".join(f'[[shape]]\nname = "{name}"\n{text}\n\n' for name, text in shapes.items())
    size = [width, 1, 0] if plane else list(width) + [1]
    return f"""[run]
{run}
{QUIET}
[world]
gravity = {"[0, -9.81, 0]" if plane else "[0, 0, -9.81]"}
{"dimension = 2" + chr(10) + "thickness = 0.002" if plane else ""}
[periodic]
axes = "{"x" if plane else "xy"}"
lower = [0, 0, 0]
upper = {size}

[law]
name = "hertz_mindlin"
{'map = "equivalent_radius"' if plane else ""}

{SOFT}
{tables}[[wall]]
name = "floor"
kind = "{"line" if plane else "plane"}"
material = "soft"
point = [0, 0, 0]
normal = {"[0, 1, 0]" if plane else "[0, 0, 1]"}

{bodies}"""


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def fill(name, count, width):
    """Bodies that are to fall: a tenth of the region is solid, of long grains 6 %, of the plane a quarter. Boulders begin
    under the fine."""
    shapes, plane = KINDS[name]
    if name == "sizes_1_20":
        boxes = (("boulder", BOULDERS, 0.001, 0.13), ("fine", FINE, 0.13, 0.23))
        return "".join(f'[[fill]]\nlower = [0, 0, {lower}]\nupper = [{width}, {width}, {upper}]\ncount = {number}\n'
                       f'items = [{{ shape = "{shape}", material = "soft" }}]\n' for shape, number, lower, upper in boxes)
    if plane:
        upper = [width, count * AREA / 0.25 / width, 0]
    else:
        upper = [width, width, count * VOLUME / (0.06 if name.startswith("grains") else 0.1) / width**2]
    items = ", ".join(f'{{ shape = "{name}", material = "soft" }}' for name in shapes)
    lower = [0, 0.002, 0] if plane else [0, 0, 0.002]
    return f"[[fill]]\nlower = {lower}\nupper = {upper}\ncount = {count}\nitems = [{items}]\n"


def read_final(folder):
    with open(os.path.join(folder, "final.csv"), encoding="utf-8") as file:
        lines = [line for line in file if not line.startswith("#")]
    return list(csv.DictReader(lines))


def settle(dem, name, cache, log):
    """Pours and settles the tile of a bed, unless the cache has it; the bodies it ends with."""
    shapes, plane = KINDS[name]
    count, width = tile_of(name)
    folder = os.path.join(cache, name)
    text = scene(shapes, plane, width if plane else (width, width), "time = 0.3\ndt_fraction = 0.4\nseed = 1",
                 fill(name, count, width)).replace("restitution = 0.8", "restitution = 0.3")
    path = os.path.join(cache, name + ".toml")
    done = os.path.exists(os.path.join(folder, "final.csv"))
    if done:
        with open(path, encoding="utf-8") as file:
            done = file.read() == text
    if not done:
        log(f"settling {count} bodies for the bed of {name}")
        write(path, text)
        run_dem(dem, path, folder, 1, [])
    return read_final(folder)


def make(dem, name, count, cache, folder, log):
    """Writes the scene of a settled bed of `count` bodies, a multiple of a tile's (None: one tile); its path."""
    shapes, plane = KINDS[name]
    of_tile, width = tile_of(name)
    count = count or of_tile
    rows = settle(dem, name, cache, log)
    tiles = count // of_tile
    if tiles * of_tile != count or len(rows) != of_tile:
        raise SystemExit(f"{name}: {count} bodies are not whole tiles of {of_tile}")
    along = tiles if plane else next(n for n in range(math.isqrt(tiles), 0, -1) if tiles % n == 0)
    columns = ("shape", "x", "y", "z", "qw", "qx", "qy", "qz")
    table = os.path.join(folder, "bodies.csv")
    with open(table, "w", encoding="utf-8") as out:
        out.write(",".join(columns) + "\n")
        for tile in range(tiles):
            shift = {"x": tile % along * width, "y": tile // along * width}
            for row in rows:
                out.write(",".join(repr(float(row[c]) + shift[c]) if shift.get(c) else row[c] for c in columns) + "\n")
    size = along * width if plane else (along * width, tiles // along * width)
    path = os.path.join(folder, "bed.toml")
    write(path, scene(shapes, plane, size, "steps = 1000\ndt_fraction = 0.3\nmax_initial_overlap = 0.2",
                      '[[bodies_csv]]\nfile = "bodies.csv"\nmaterial = "soft"\n'))
    return path
