"""The scenes of the shape comparison: bodies are poured into a flat-bottomed bin; when all are in and slower than AT_REST the
part of the floor beside the right wall is taken away. The bed runs out through this slot, and what stays leans on the left wall
at its angle of repose. In space the walls in front and behind are smooth."""
import math

import grain

DIAMETER = 0.01        # m: of the sphere of the same volume, in the plane of the disc of the same area; bodies are 0.9 to 1.1 times as large
YOUNG = 1e6            # Pa
DENSITY = 2500         # kg/m^3
POUR = 0.3             # s that the pouring takes
AT_REST = 0.015        # m/s: mean speed, a twentieth of that of a fall over a diameter
LATEST = 3             # s: a bed that does not come to rest before ends the run
INTERVAL = 0.025       # s between frames
# Sizes in diameters: width, depth, part of the floor that stays, height of the region in which bodies appear, half-width and
# heights of the region that is looked at; time that the discharge is given, s; length of a step over the smallest limit.
SPACE = {"width": 15, "depth": 3.5, "ledge": 10, "count": 500, "spout": (11, 23), "look": (2, 13, 0.9, 1.5, 6), "run_out": 0.65,
         "dt_fraction": 0.5}
PLANE = {"width": 30, "depth": 0, "ledge": 20, "count": 500, "spout": (19, 36), "look": (2, 28, 0, 2, 12), "run_out": 0.9,
         "dt_fraction": 0.3}  # an L that slides over a corner has more contacts than are counted with

GRAINS = ["cement140_03", "cement140_10", "ma165_01", "ma165_10", "sacci425_05", "sacci425_12", "sika-fib_01", "sika-fib_27"]
VERTICES = (12, 24, 60, 200)
FIDELITY = ["grain as ellipsoid", "grain as 12 spheres"] + [f"grain, {count} vertices" for count in VERTICES]


def numbers(rows):
    return "[" + ", ".join("[" + ", ".join(f"{v:.9g}" for v in row) + "]" for row in rows) + "]"


def prolate_clump(count):
    """Spheres inside the ellipsoid 1:1:2 that touch it, centres evenly along its axis; unit: its short semi-axis."""
    long, reach = 2.0, 1.5  # farther out than 1.5 an inscribed sphere would touch the tip alone
    rows = []
    for i in range(count):
        c = reach * (2 * i / (count - 1) - 1)
        rows.append((0, 0, c, math.sqrt(1 - c * c / (long * long - 1))))
    return rows


def solids():
    """Bodies of space: name -> list of shape texts, taken in equal numbers; all have the volume of a sphere of DIAMETER."""
    d = DIAMETER
    a = d / 2 / 2 ** (1 / 3)
    edge = (math.pi / 6 * 12 / (5 * (3 + math.sqrt(5)))) ** (1 / 3) * d  # of the icosahedron
    icosahedron = edge / 4 * math.sqrt(10 + 2 * math.sqrt(5))
    cube = (math.pi / 6) ** (1 / 3) * d
    return {
        "sphere": [f'kind = "sphere"\nradius = {d / 2}'],
        "clump of 1:1:2": [f'kind = "clump"\ndiameter = {d}\nspheres = {numbers(prolate_clump(7))}'],
        "ellipsoid 1:1:2": [f'kind = "ellipsoid"\nsemi_axes = [{a:.9g}, {a:.9g}, {2 * a:.9g}]'],
        "cube": [f'kind = "box"\nextents = [{cube:.9g}, {cube:.9g}, {cube:.9g}]'],
        "icosahedron": [f'kind = "icosahedron"\ncircumradius = {icosahedron:.9g}'],
        "grains coarse": [f'kind = "polyhedron"\ndiameter = {d}\nfile = "grain:{name}"' for name in GRAINS],
        "grains fine": [f'kind = "polyhedron"\ndiameter = {d}\nfile = "grain-fine:{name}"' for name in GRAINS],
    }


def one_grain():
    """The same of one grain, coarse to fine (FIDELITY); its sphere is that of solids()."""
    d = DIAMETER
    points = grain.surface(5000)
    sizes = grain.extents(points)
    unit = d / (sizes[0] * sizes[1] * sizes[2]) ** (1 / 3) / 2
    axes = ", ".join(f"{unit * size:.9g}" for size in sizes)
    texts = [f'kind = "ellipsoid"\nsemi_axes = [{axes}]', f'kind = "clump"\ndiameter = {d}\nspheres = {numbers(grain.clump(points, 12))}']
    texts += [f'kind = "polyhedron"\ndiameter = {d}\nvertices = {numbers(grain.hull_vertices(points, count))}' for count in VERTICES]
    return {name: [text] for name, text in zip(FIDELITY, texts)}


def plane_bodies():
    """Bodies of the plane, all with the area of a disc of DIAMETER."""
    d = DIAMETER
    area = math.pi * d * d / 4
    short = d / 2 / math.sqrt(2)
    hexagon = math.sqrt(area / (1.5 * math.sqrt(3)))
    side = math.sqrt(area / 5)  # of the five squares of an L: three along each leg
    angle = [(x * side, y * side, 0) for x, y in ((0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3))]
    return {
        "disc": [f'kind = "disc"\nradius = {d / 2}'],
        "ellipse 1:2": [f'kind = "ellipse"\nsemi_axis_a = {2 * short:.9g}\nsemi_axis_b = {short:.9g}'],
        "hexagon": [f'kind = "regular_polygon"\nsides = 6\ncircumradius = {hexagon:.9g}'],
        "L, not convex": [f'kind = "polygon"\nvertices = {numbers(angle)}'],
    }


def order():
    """All names, as they stand in tables."""
    return list(solids()) + FIDELITY + list(plane_bodies())


def wall(name, kind, material, **keys):
    lines = [f'[[wall]]\nname = "{name}"\nkind = "{kind}"\nmaterial = "{material}"']
    return "\n".join(lines + [f"{key} = {value}" for key, value in keys.items()]) + "\n"


def side_walls(plane):
    d, size = DIAMETER, geometry(plane)
    width, half = size["width"] * d, size["depth"] * d / 2
    kind = "line" if plane else "plane"
    sides = (wall("left", kind, "grain", point=[0, 0, 0], normal=[1, 0, 0]) +
             wall("right", kind, "grain", point=[width, 0, 0], normal=[-1, 0, 0]))
    if plane:
        return sides
    return (sides + wall("front", kind, "smooth", point=[0, -half, 0], normal=[0, 1, 0]) +
            wall("back", kind, "smooth", point=[0, half, 0], normal=[0, -1, 0]))


def floor_part(name, plane, start, end):
    """The floor from x = start to x = end, in diameters."""
    d, y = DIAMETER, (geometry(plane)["depth"] / 2 + 1) * DIAMETER
    if plane:
        return wall(name, "polyline", "grain", vertices=[[start * d, 0, 0], [end * d, 0, 0]], depth=d)
    return wall(name, "panel", "grain", corner=[start * d, -y, 0], side_1=[(end - start) * d, 0, 0], side_2=[0, 2 * y, 0])


def geometry(plane):
    return PLANE if plane else SPACE


def region(plane):
    """Where the settled bed is looked at, away from its walls and its surface."""
    x0, x1, y, z0, z1 = (DIAMETER * v for v in geometry(plane)["look"])
    return [x0, z0, x1, z1] if plane else [x0, -y, z0, x1, y, z1]


def poured(name, shapes, plane, count, seed):
    """The text of a scene in which bodies fall between the side walls; it has no floor."""
    d, size = DIAMETER, geometry(plane)
    low, high = (d * v for v in size["spout"])
    half = size["depth"] * d / 2
    lower, upper = ([0, low, 0], [size["width"] * d, high, 0]) if plane else ([0, -half, low], [size["width"] * d, half, high])
    down = (lambda v: [0, -v, 0]) if plane else (lambda v: [0, 0, -v])
    items = ", ".join(f'{{ shape = "body {i}", material = "grain", scale = [0.9, 1.1] }}' for i in range(len(shapes)))
    text = f"""title = "{name}"
[run]
time = {LATEST}
dt_fraction = {size["dt_fraction"]}
check_every = 50
seed = {seed}
[output]
interval = {INTERVAL}
vtk = false
picture = false
walls = false
[world]
gravity = {down(9.81)}
{f"dimension = 2{chr(10)}thickness = {d}" if plane else ""}
[law]
name = "hertz_mindlin"
{'map = "equivalent_radius"' if plane else ""}
[[material]]
name = "grain"
young = {YOUNG}
poisson = 0.3
density = {DENSITY}
restitution = 0.4
friction = 0.5
[[material]]
name = "smooth"
young = {YOUNG}
poisson = 0.3
restitution = 0.4
friction = 0
[[region]]
name = "spout"
kind = "box"
lower = {lower}
upper = {upper}
[[rain]]
name = "pour"
region = "spout"
rate = {count / POUR}
count = {count}
velocity = {down(0.5)}
items = [{items}]
"""
    text += "".join(f'[[shape]]\nname = "body {i}"\n{shape}\n' for i, shape in enumerate(shapes))
    return text + side_walls(plane)


def scene(name, shapes, plane, count, seed):
    """The text of a scene of the comparison."""
    d, size = DIAMETER, geometry(plane)
    calm = f'when = "rain.pour.count >= {count} and mean_speed < {AT_REST}"'
    outlet = "point = [0, {0}, 0]\nnormal = [0, 1, 0]" if plane else "point = [0, 0, {0}]\nnormal = [0, 0, 1]"
    return (poured(name, shapes, plane, count, seed) + floor_part("floor", plane, -1, size["ledge"]) +
            floor_part("gate", plane, size["ledge"], size["width"] + 1) + f"""[[event]]
name = "open"
{calm}
remove_wall = "gate"
[[event]]
name = "end"
{calm}
delay = {size["run_out"]}
stop = true
[[outlet]]
name = "below"
{outlet.format(-3 * d)}
""")
