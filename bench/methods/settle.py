#!/usr/bin/env python3
"""settle.py [--quick] [--dem PROGRAM]: what a detection method changes in a run. Bodies of one kind fall into a box and
settle, once under each method that answers their pair and once under `auto`, each from three seeds. Prints for each
method: time of the loop over that of `auto` (interleaved, medians), height of the centre of mass and contacts per body
less those of `auto` with the spread that other seeds make, mean overlap, shares of contacts handed over to another
method and not certified. Run from the project's root; needs build/release/bin/dem (./run builds it).
--quick: one seed, half the time."""
import argparse
import csv
import json
import os
import statistics
import subprocess
import sys
import tempfile

SEEDS = 3
PLANE = """
[world]
dimension = 2
gravity = [0, -9.81, 0]
thickness = 0.01
"""
SPACE = """
[world]
gravity = [0, 0, -9.81]
"""
PLANE_WALLS = """
[[wall]]
name = "floor"
kind = "line"
material = "soft"
point = [0, 0, 0]
normal = [0, 1, 0]

[[wall]]
name = "west"
kind = "line"
material = "soft"
point = [-0.08, 0, 0]
normal = [1, 0, 0]

[[wall]]
name = "east"
kind = "line"
material = "soft"
point = [0.08, 0, 0]
normal = [-1, 0, 0]
"""
SPACE_WALLS = """
[[wall]]
name = "floor"
kind = "plane"
material = "soft"
point = [0, 0, 0]
normal = [0, 0, 1]
""" + "".join(f"""
[[wall]]
name = "side{i}"
kind = "plane"
material = "soft"
point = [{-0.03 * x}, {-0.03 * y}, 0]
normal = [{x}, {y}, 0]
""" for i, (x, y) in enumerate([(1, 0), (-1, 0), (0, 1), (0, -1)]))
SCENES = {  # kind: (shape, bodies, are they of the plane?)
    "ellipse": ('kind = "ellipse"\nsemi_axis_a = 0.006\nsemi_axis_b = 0.003', 200, True),
    "polygon": ('kind = "regular_polygon"\nsides = 6\ncircumradius = 0.005', 200, True),
    "ellipsoid": ('kind = "ellipsoid"\nsemi_axes = [0.003, 0.003, 0.006]', 150, False),
    "polyhedron": ('kind = "polyhedron"\nvertices = [[0.005, 0, 0], [-0.005, 0, 0], [0, 0.005, 0], [0, -0.005, 0], '
                   '[0, 0, 0.005], [0, 0, -0.005], [0.003, 0.003, 0.003], [-0.003, -0.003, -0.003]]', 150, False),
    "potential_particle": ('kind = "potential_particle"\nhalf_spaces = [[1, 0, 0, 0.004], [-1, 0, 0, 0.004], '
                           '[0, 1, 0, 0.003], [0, -1, 0, 0.003], [0, 0, 1, 0.003], [0, 0, -1, 0.003]]\n'
                           'k = 0.2\nr = 0.0015\nR = 0.006', 60, False),
}


def scene(kind, method, seed, quick):
    """The text of one scene."""
    shape, count, plane = SCENES[kind]
    lower, upper = ("[-0.07, 0.01, 0]", "[0.07, 0.35, 0]") if plane else ("[-0.022, -0.022, 0.01]", "[0.022, 0.022, 0.25]")
    return f"""title = "{kind} by {method}"
[run]
time = {0.2 if quick else 0.4}
dt_fraction = 0.2
seed = {seed}
[output]
vtk = false
hdf5 = false
picture = false
walls = false
[contact]
method = "{method}"
max_uncertified_share = 1
[law]
name = "hertz_mindlin"
map = "equivalent_radius"
[[material]]
name = "soft"
young = 1e7
poisson = 0.3
density = 2500
restitution = 0.4
friction = 0.4
[[shape]]
name = "grain"
{shape}
{PLANE if plane else SPACE}{PLANE_WALLS if plane else SPACE_WALLS}
[[fill]]
lower = {lower}
upper = {upper}
count = {count}
items = [{{ shape = "grain", material = "soft" }}]
"""


def run(program, folder, text):
    """Summary of a run; None when it stopped, with its message."""
    path = os.path.join(folder, "scene.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    out = os.path.join(folder, "out")
    done = subprocess.run([program, "run", path, "--out", out, "--force", "--threads", "1", "--quiet"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return None, (done.stderr.strip().splitlines() or ["no message"])[0]
    with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    with open(os.path.join(out, "final.csv"), encoding="utf-8", newline="") as file:
        heights = [float(row["y" if PLANE in text else "z"]) for row in csv.DictReader(file)]
    summary["mean_height"] = statistics.mean(heights)
    return summary, ""


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--dem", default="build/release/bin/dem")
    arguments.add_argument("--quick", action="store_true")
    given = arguments.parse_args()
    listed = json.loads(subprocess.run([given.dem, "list", "pairs", "--json"], capture_output=True, text=True, check=True).stdout)["pairs"]
    seeds = range(1, 2 if given.quick else 1 + SEEDS)
    print(f"{'kind':<20}{'method':<26}{'x time':>8}{'height, mm':>12}{'less auto':>11}{'seeds':>8}{'contacts':>10}"
          f"{'less auto':>11}{'seeds':>8}{'handed':>9}{'uncert.':>9}")
    with tempfile.TemporaryDirectory() as folder:
        for kind in SCENES:
            methods = next(p["methods"] for p in listed if p["a"] == p["b"] == kind)
            ways = ["auto"] + methods[1:]
            rows = {way: [] for way in ways}
            stopped = {}
            for seed in seeds:
                for way in ways:
                    if way in stopped:
                        continue
                    summary, message = run(given.dem, folder, scene(kind, way, seed, given.quick))
                    if summary is None:
                        stopped[way] = message
                    else:
                        rows[way].append(summary)

            def values(way, pick):
                return [pick(s) for s in rows[way]]

            def height(s):
                return 1e3 * s["mean_height"]

            for way in ways:
                if way in stopped:
                    print(f"{kind:<20}{way:<26} stopped: {stopped[way]}")
                    continue
                time = statistics.median(values(way, lambda s: s["seconds"]["loop"]))
                base = statistics.median(values("auto", lambda s: s["seconds"]["loop"]))
                line = f"{kind:<20}{way:<26}{time / base:>8.2f}"
                for pick, width in ((height, 12), (lambda s: s["contacts_per_particle"], 10)):
                    mean, auto = statistics.mean(values(way, pick)), values("auto", pick)
                    spread = statistics.stdev(auto) if len(auto) > 1 else float("nan")
                    line += f"{mean:>{width}.3f}{mean - statistics.mean(auto):>11.3f}{spread:>8.3f}"
                contacts = sum(values(way, lambda s: s["counters"]["contact_steps"]))
                for counter in ("handed_over", "uncertified"):
                    line += f"{sum(values(way, lambda s, c=counter: s['counters'][c])) / max(1, contacts):>9.1e}"
                print(line, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
