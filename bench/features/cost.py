#!/usr/bin/env python3
"""cost.py [--reps N] [--steps N] [--only TEXT] [--quick] [--csv FILE] [--dem PROGRAM]

What each feature costs in the loop: the settled bed of 10,000 spheres (libdem/scenes/bed_spheres.toml) with one thing on or off at
a time, all of them turn by turn in one run. Then discs of a plane against the same spheres in space, and law.map on ellipsoids and
cubes that are poured (bench/shapes/scenes.py), each with a base of its own.

ns/step   median processor time of the time loop and of what is written as it goes, per particle-step, with its range
loop      of the loop alone, median
x base    median over the repetitions of ns/step over that of the base in the same repetition
contacts  contact-steps over particle-steps; what holds on across a gap, or lets go, has others

--only    rows whose name contains TEXT, and their bases
--quick   one repetition, 100 steps

Needs build/release/bin/dem (./run builds it). Exit status 1: a run failed."""
import argparse
import csv
import os
import statistics
import sys
import tempfile

BENCH = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [BENCH, os.path.join(BENCH, "shapes")]
import scenes  # noqa: E402
from scene_text import SOFT  # noqa: E402
import timed_run  # noqa: E402

BED = os.path.join(timed_run.ROOT, "libdem", "scenes", "bed_spheres.toml")
PACKING = os.path.join(BENCH, "data", "spheres_1e4.csv.gz")
SIDE = 0.04174128   # m, of the bed
NO_RESTITUTION = ["linear_spring", "viscoelastic_hertz", "thornton_ning", "thornton_ning_adhesive"]
STIFFNESS = 'reference_speed = 0.1\n'  # linear laws as stiff as Hertz at this impact


def bed():
    with open(BED, encoding="utf-8") as file:
        return file.read().replace("../../bench/data/spheres_1e4.csv.gz", PACKING)


def with_law(text, name, more="", material=""):
    if name in NO_RESTITUTION:
        text = text.replace("restitution = 0.8\n", "")
    text = text.replace('name = "hertz_mindlin"\n', f'name = "{name}"\n{more}')
    return text.replace("friction = 0.5\n", "friction = 0.5\n" + material)


def without_walls(text, names):
    """The scene less the walls of these names."""
    head, *walls = text.split("[[wall]]\n")
    return head + "".join("[[wall]]\n" + wall for wall in walls if not any(f'name = "{name}"' in wall for name in names))


def periodic(text):
    sides = without_walls(text, ["left", "right", "front", "back"])
    return sides + f'\n[periodic]\naxes = "xy"\nlower = [0, 0, 0]\nupper = [{SIDE}, {SIDE}, 0]\n'


def box_of_mesh(text):
    box = (f'\n[[wall]]\nname = "box"\nkind = "box"\nmaterial = "soft"\nlower = [0, 0, 0]\nupper = [{SIDE}, {SIDE}, 0.08]\n'
           'open = ["+z"]\n')
    return without_walls(text, ["floor", "left", "right", "front", "back"]) + box


def features():
    """(name, text of the scene, settings) on the bed; the first is the base."""
    base = bed()
    law = with_law
    frames = "output.interval=0.0002"
    rows = [
        ("base: hertz_mindlin", base, []),
        ("friction off", base, ["material[0].friction=0"]),
        ("tangential force off", base, ["law.tangential=none"]),
        ("damping off", base, ["material[0].restitution=1"]),
        ("rescale off", base, ["law.rescale=false"]),
        ("clip off", base, ["law.clip=false"]),
        ("cohesion constant", law(base, "hertz_mindlin", 'cohesion = "constant"\n', "cohesion = 1e-6\n"), []),
        ("cohesion dmt", law(base, "hertz_mindlin", 'cohesion = "dmt"\n', "work_of_adhesion = 1e-4\n"), []),
        ("cohesion liquid_bridge", law(base, "hertz_mindlin", 'cohesion = "liquid_bridge"\nsurface_tension = 0.01\nbridge_volume = 1e-13\n',
                                       "contact_angle = 0.2\n"), []),
        ("rolling constant", law(base, "hertz_mindlin", 'rolling = "constant"\n', "rolling_friction = 0.1\n"), []),
        ("rolling viscous", law(base, "hertz_mindlin", 'rolling = "viscous"\n', "rolling_viscosity = 0.01\n"), []),
        ("rolling spring", law(base, "hertz_mindlin", 'rolling = "spring"\n',
                               "rolling_friction = 0.1\nrolling_damping = 0.3\ntwisting_friction = 0.1\n"), []),
        ("ledger", base, ["law.ledger=true"]),
        ("drag schiller_naumann", base + '\n[drag]\nlaw = "schiller_naumann"\ndensity = 1.2\nviscosity = 1.8e-5\n', []),
        ("side walls periodic", periodic(base), []),
        ("walls are meshes", box_of_mesh(base), []),
        ("walls.csv every 20 steps", base, ["output.walls=true", "output.walls_interval=0.0002"]),
        ("coordination, stress, energy every 20 steps",
         base + '\n[analysis]\nwhat = ["coordination", "stress", "energy"]\ninterval = 0.0002\n', []),
        ("frames for ParaView every 20 steps", base, ["output.vtk=true", frames]),
        ("record every 20 steps", base, ["output.hdf5=true", frames]),
        ("checkpoint every 100 steps", base, ["output.checkpoint_interval=0.001"]),
    ]
    laws = [
        ("linear_spring", STIFFNESS, ""), ("spring_dashpot", STIFFNESS, ""), ("viscoelastic_hertz", "", "viscous_time = 1e-5\n"),
        ("hertz_mindlin_deresiewicz", "", ""), ("mindlin_deresiewicz_exact", "", ""),
        ("jkr_thornton", "", "work_of_adhesion = 1e-4\n"), ("partially_latching_spring", STIFFNESS, ""),
        ("thornton_ning", "", "yield_pressure = 1e5\n"), ("thornton_ning_adhesive", "", "yield_pressure = 1e5\nwork_of_adhesion = 1e-4\n"),
        ("adhesive_plastic_spring", STIFFNESS, "plastic_stiffness = 5e4\nadhesive_stiffness = 100\nplastic_depth = 0.05\n"),
        ("dmt", "", "work_of_adhesion = 1e-4\n"),
    ]
    return rows + [("law " + name, law(base, name, more, material), []) for name, more, material in laws]


def layer(dimension, model=""):
    """10,000 bodies on a hexagonal lattice over a floor; in space spheres, in the plane discs."""
    plane = dimension == 2
    shape = 'kind = "disc"' if plane else 'kind = "sphere"'
    kind = "line" if plane else "plane"
    world = f"dimension = 2\n{model}\n" if plane else ""
    depth = 0 if plane else 0.001
    lines = "".join(f'[[wall]]\nname = "{name}"\nkind = "{kind}"\nmaterial = "soft"\npoint = {point}\nnormal = {normal}\n'
                    for name, point, normal in (("floor", [0, 0, 0], [0, 1, 0]), ("left", [0, 0, 0], [1, 0, 0]),
                                                ("right", [0.2015, 0, 0], [-1, 0, 0])))
    return f"""title = "layer"
[run]
steps = 1000
dt = 1e-5
skin = 2e-4
[output]
vtk = false
hdf5 = false
picture = false
[world]
gravity = [0, -9.81, 0]
{world}[law]
name = "hertz_mindlin"
map = "equivalent_radius"
{SOFT}[[shape]]
name = "ball"
{shape}
radius = 0.001
{lines}[[fill]]
arrangement = "hexagonal"
lower = [0, 0, {-depth}]
upper = [0.2015, 0.18, {depth}]
count = 10000
items = [{{ shape = "ball", material = "soft" }}]
"""


def planes():
    return [("base: layer of spheres in space", layer(3), []), ("the same, dimension = 2, discs as spheres", layer(2, 'disc_model = "sphere"'), []),
            ("discs as prisms", layer(2, "thickness = 0.002"), [])]


def maps(kind):
    """One shape that is poured for 0.4 s under each map that takes it."""
    words = {"ellipsoid 1:1:2": ["auto", "curvature"], "cube": ["auto", "edge_radius", "volume"]}[kind]
    floor = scenes.wall("floor", "plane", "grain", point=[0, 0, 0], normal=[0, 0, 1])
    text = scenes.poured(kind, scenes.solids()[kind], False, 300, 1) + floor
    rows = []
    for word in words:
        radius = f"\nedge_radius = {0.1 * scenes.DIAMETER}" if word == "edge_radius" else ""
        scene = text.replace('name = "hertz_mindlin"\n', f'name = "hertz_mindlin"\nmap = "{word}"{radius}\n')
        rows.append((f"{'base: ' if word == 'auto' else ''}{kind}, map {word}", scene, ["run.time=0.4"]))
    return rows


def measure(given, rows, rounds, settings):
    """Turn by turn: {name: [(ns per step, of the loop, contacts)]}."""
    found = {name: [] for name, _, _ in rows}
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(rounds):
            for name, text, more in rows:
                if name in failed:
                    continue
                try:
                    timed = timed_run.run_text(given.dem, folder, text, list(settings) + more)
                except timed_run.Failed as fault:
                    failed.append(name)
                    print(f"FAILED {name}: {fault}", flush=True)
                    continue
                steps = timed.particle_steps
                found[name].append((1e9 * timed.seconds("loop", "output") / steps, 1e9 * timed.seconds("loop") / steps,
                                    timed.summary["counters"]["contact_steps"] / steps))
    return found, failed


def table(found):
    base = next(iter(found.values()))
    rows = [["feature", "ns/step (range)", "loop", "x base", "contacts"]]
    for name, values in found.items():
        if not values:
            continue
        times, loops, contacts = zip(*values)
        ratio = statistics.median(t / b[0] for t, b in zip(times, base)) if base else float("nan")
        rows.append([name, f"{statistics.median(times):.1f} ({min(times):.1f}–{max(times):.1f})", f"{statistics.median(loops):.1f}",
                     f"{ratio:.2f}", f"{statistics.median(contacts):.2f}"])
    timed_run.print_table(rows)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--reps", type=int, default=5)
    arguments.add_argument("--steps", type=int, default=1000)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--quick", action="store_true")
    arguments.add_argument("--csv")
    arguments.add_argument("--dem", default=timed_run.PROGRAM)
    given = arguments.parse_args()
    print("\n".join(f"{k}: {v}" for k, v in timed_run.about(given.dem).items()), flush=True)
    reps, steps = (1, 100) if given.quick else (given.reps, given.steps)
    written, failures = [], []
    for rows, rounds, settings in ((features(), reps, [f"run.steps={steps}"]), (planes(), reps, [f"run.steps={steps}"]),
                                   (maps("ellipsoid 1:1:2"), min(reps, 3), []), (maps("cube"), min(reps, 3), [])):
        if not any(given.only in name for name, _, _ in rows):
            continue
        chosen = [row for row in rows if given.only in row[0] or row[0].startswith("base")]
        found, failed = measure(given, chosen, rounds, settings)
        table(found)
        failures += failed
        written += [(name, number, *value) for name, values in found.items() for number, value in enumerate(values)]
    if given.csv:
        with open(given.csv, "w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([("feature", "repetition", "ns_step", "ns_step_loop", "contacts")] + written)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
