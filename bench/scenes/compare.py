#!/usr/bin/env python3
"""compare.py [--only SCENE,…] [--reps N] [--quick] [--json FILE] [--cache DIR] [--dem PROGRAM]

Particle-steps per second of this program on settled beds and in a drum, turn by turn with LAMMPS (gran/hertz/history),
LIGGGHTS and YADE where they have the scene and are installed; then every bar of the project with what was reached.

A repetition runs every program of a scene once, pinned to the same cores. Equal starts, steps, skin and rebuilds of the neighbour
list (in the drum each as its bodies' motion asks). The other programs warm up first and their own loop timer times the
rest; here all steps count. Rate = particles x steps / wall time of the loop, without output; cpu_pct = share of its cores that a
program got: on a machine that does other work only interleaved ratios mean anything.

Beds of bodies that are not spheres settle first (beds.py: a tile of each, a minute a kind, kept in --cache).
--quick: one repetition, no bed of 1e6. Exit status 0: measured; 1: a program failed. Scenes: --list."""
import argparse
import json
import os
import shutil
import statistics
import sys
import tempfile

import beds
import spheres
from programs import deck, dem_result, run_dem, run_yade, versions
from timed_run import PROGRAM, ROOT, Failed  # found by programs

BEDS = {"ellipsoids": 10_000, "ellipsoids_1e5": 100_000, "cubes": 10_000, "icosahedra": 10_000, "grains_coarse": 10_000,
        "grains_fine": 10_000, "discs": 10_000, "ellipses": 10_000, "hexagons": 10_000, "crosses": 10_000, "spheres": 10_000,
        "sizes_1_20": None}
BARS = {"ellipsoids": 2.5, "ellipsoids_1e5": 2.5, "cubes": 1, "icosahedra": 1, "grains_coarse": 0.6, "grains_fine": 0.35,
        "discs": 20, "ellipses": 6, "hexagons": 4, "crosses": 1.5}  # million particle-steps per second
STEPS = {"discs": 2000, "ellipsoids_1e5": 100, "grains_fine": 200, "grains_coarse": 200}
SCENES = ["bed_1e4", "bed_1e4_two_cores", "bed_1e5", "bed_1e5_two_cores", "bed_1e6", "drum", *BEDS]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", help="names of scenes, joined by commas")
    parser.add_argument("--list", action="store_true", help="names the scenes and ends")
    parser.add_argument("--reps", type=int, default=5)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--without", default="", help="programs to leave out: lammps, liggghts, yade")
    parser.add_argument("--turn-spheres", action="store_true", help="beds and drums of spheres with their orientations, which LAMMPS and LIGGGHTS do not follow")
    parser.add_argument("--json", help="writes every result to this file")
    parser.add_argument("--cache", default=os.path.join(ROOT, "build", "beds"))
    parser.add_argument("--dem", default=PROGRAM)
    return parser.parse_args()


def orientations(args):
    return [] if args.turn_spheres else [spheres.NOT_TURNED]


def bed_of_spheres(args, name, folder):
    """The runs of a bed of spheres: {program: function}, each gives a result."""
    count = {"1e4": 10_000, "1e5": 100_000, "1e6": 1_000_000}[name.split("_")[1]]
    cores = 2 if name.endswith("two_cores") else 1
    steps = {10_000: 2000, 100_000: 200, 1_000_000: 40}[count]
    warm, every = max(4, steps // 20), steps // 2
    rows, size_x, size_y = spheres.bed(count)
    spheres.write_bed(folder, rows, size_x, size_y)
    ours = [f"run.steps={steps + warm}", f"run.dt={spheres.DT}", f"run.skin={spheres.SKIN}", f"run.rebuild_every={every}"]
    ours += orientations(args)
    variables = {"data": "bed.data", "Lx": size_x, "Ly": size_y, "warm": warm, "steps": steps, "skin": spheres.SKIN,
                 "dt": spheres.DT, "every": every}
    runs = {"dem": lambda: dem_result(run_dem(args.dem, os.path.join(folder, "bed.toml"), os.path.join(folder, "out"), cores, ours)),
            "lammps": lambda: deck("lmp", "in.bed_lammps", variables, count, steps, cores, folder),
            "liggghts": lambda: deck("liggghts", "in.bed_liggghts", variables, count, steps, cores, folder)}
    if count == 10_000:
        few = dict(variables, file="bed.txt", steps=steps // 4)
        runs["yade"] = lambda: run_yade(few, count, steps // 4, cores, folder)
    return runs


def drum(args, folder):
    """The drum, from a state that flows: the first 15,000 steps are made once and kept in the cache."""
    rows = spheres.drum()
    spheres.write_drum(folder, rows)
    start = os.path.join(args.cache, "drum")
    if not os.path.exists(os.path.join(start, "final.csv")):
        print("letting the drum flow for 15,000 steps", flush=True)
        run_dem(args.dem, os.path.join(folder, "drum.toml"), start, os.cpu_count(),
                ["run.steps=15000", f"run.skin={spheres.SKIN}"])
    rows = spheres.flowing(os.path.join(start, "final.csv"), rows)
    spheres.write_drum(folder, rows)
    warm, steps = 50, 500
    ours = [f"run.steps={steps + warm}", f"run.skin={spheres.SKIN}"] + orientations(args)
    variables = {"data": "drum.data", "R": spheres.DRUM_RADIUS, "W": spheres.DRUM_WIDTH, "rate": spheres.DRUM_RATE, "warm": warm,
                 "steps": steps, "skin": spheres.SKIN, "dt": spheres.DT}
    return {"dem": lambda: dem_result(run_dem(args.dem, os.path.join(folder, "drum.toml"), os.path.join(folder, "out"), 1, ours)),
            "lammps": lambda: deck("lmp", "in.drum_lammps", variables, len(rows), steps, 1, folder)}


def bed_of_shapes(args, name, folder):
    scene = beds.make(args.dem, name.removesuffix("_1e5"), BEDS[name], args.cache, folder, lambda text: print(text, flush=True))
    steps = STEPS.get(name, 500)
    ours = [f"run.steps={steps}", f"run.rebuild_every={steps // 2}"]
    return {"dem": lambda: dem_result(run_dem(args.dem, scene, os.path.join(folder, "out"), 1, ours))}


def measure(args, name):
    """All repetitions of a scene: {program: [results]}."""
    installed = {"dem": True, "lammps": shutil.which("lmp"), "liggghts": shutil.which("liggghts"), "yade": shutil.which("yade")}
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        if name.startswith("bed"):
            runs = bed_of_spheres(args, name, folder)
        else:
            runs = drum(args, folder) if name == "drum" else bed_of_shapes(args, name, folder)
        runs = {program: run for program, run in runs.items() if installed[program] and program not in args.without.split(",")}
        if name.endswith("two_cores") and not shutil.which("mpirun"):
            runs = {program: run for program, run in runs.items() if program in ("dem", "yade")}
        for _ in range(args.reps):
            for program, run in runs.items():
                got = run()
                found.setdefault(program, []).append(got)
                print(f"RESULT scene={name} code={program} particle_steps_per_s={got['rate']:.4g} contacts={got['contacts']:.3f} "
                      f"kinetic={got['kinetic']:.4g} cpu_pct={got['cpu_pct']:.0f} MiB={got['memory'] / 2**20:.0f} {got['note']}",
                      flush=True)
    return found


def median(found, scene, program="dem", key="rate"):
    """None where it was not measured."""
    values = [got[key] for got in found.get(scene, {}).get(program, [])]
    return statistics.median(values) if values else None


def rows_of(found):
    """Table of medians with their ranges, M particle-steps per second."""
    yield ("scene", "program", "median", "least", "most", "ns/contact", "contacts")
    for scene, programs in found.items():
        for program, results in programs.items():
            rates = [got["rate"] / 1e6 for got in results]
            contacts = median(found, scene, program, "contacts")
            each = 1e3 / statistics.median(rates) / contacts if contacts else 0
            yield (scene, program, f"{statistics.median(rates):.3g}", f"{min(rates):.3g}", f"{max(rates):.3g}", f"{each:.0f}",
                   f"{contacts:.2f}")


def bars(found):
    """(what, got, wanted, reached) of every bar whose runs were made."""
    def ratio(what, first, second, wanted, least=True):
        if first and second:
            yield what, first / second, wanted, first / second >= wanted if least else first / second <= wanted

    for size in ("1e4", "1e5", "1e6"):
        bed = f"bed_{size}"
        yield from ratio(f"{bed}: over LAMMPS", median(found, bed), median(found, bed, "lammps"), 2.5)
        two = bed + "_two_cores"
        yield from ratio(f"{two}: over one thread", median(found, two), median(found, bed), 1.7)
        yield from ratio(f"{two}: over LAMMPS on two ranks", median(found, two), median(found, two, "lammps"), 2.5)
    yield from ratio("drum: over LAMMPS", median(found, "drum"), median(found, "drum", "lammps"), 2)
    large, small = median(found, "bed_1e6", key="memory"), median(found, "bed_1e5", key="memory")
    if large and small:
        each = (large - small) / 9e5 / 1e3
        yield "memory of a sphere, kB", each, 0.45, each <= 0.45
    for name, wanted in BARS.items():
        yield from ratio(f"{name}: M particle-steps/s", median(found, name), 1e6, wanted)
    mixed, alike = median(found, "sizes_1_20"), median(found, "spheres")
    if mixed and alike:
        cost = (1 / mixed / median(found, "sizes_1_20", key="contacts")) / (1 / alike / median(found, "spheres", key="contacts"))
        yield "sizes 1 to 20: cost of a contact over that of equal spheres", cost, 2, cost <= 2


def main():
    args = arguments()
    if args.list:
        print("\n".join(SCENES))
        return 0
    args.dem, args.cache = os.path.abspath(args.dem), os.path.abspath(args.cache)
    if not os.path.exists(args.dem):
        sys.exit(f"{args.dem} is not there: build first (./run does)")
    wanted = args.only.split(",") if args.only else [s for s in SCENES if not (args.quick and s == "bed_1e6")]
    for name in wanted:
        if name not in SCENES:
            sys.exit(f"no scene {name}: " + ", ".join(SCENES))
    args.reps = 1 if args.quick else args.reps
    os.makedirs(args.cache, exist_ok=True)
    print("\n".join(versions(args.dem)))
    found, status = {}, 0
    for name in wanted:
        try:
            found[name] = measure(args, name)
        except Failed as stopped:
            status = 1
            print(f"{name} stopped: {stopped}", flush=True)
    print()
    for row in rows_of(found):
        print("{:<20}{:<10}{:>9}{:>9}{:>9}{:>12}{:>10}".format(*row))
    print()
    for what, got, bar, reached in bars(found):
        print(f"{what:<62}{got:>8.3g}   bar {bar:<6g}{'reached' if reached else 'MISSED'}")
    if args.json:
        with open(args.json, "w", encoding="utf-8") as file:
            json.dump({"versions": versions(args.dem), "results": found}, file, indent=1)
    return status


if __name__ == "__main__":
    sys.exit(main())
