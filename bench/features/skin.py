#!/usr/bin/env python3
"""skin.py [--reps N] [--quick] [--csv FILE] [--dem PROGRAM]

What the list of candidates costs against the skin. (The side of the cells that it is made with: bench_cells.)

skin   the settled bed (libdem/scenes/bed_spheres.toml, 1000 steps), a drum that turns (libdem/scenes/drum.toml, its first 0.2 s), and
       cell lists alone: a list that is made anew at every step with hardly any skin. All ends must be the same, bit for bit

Medians over repetitions, turn by turn, with the range of ns/step. Needs build/release/bin/dem (./run builds it).
--quick: one repetition, a fifth of the time. Exit status 1: states differ, or a run failed."""
import argparse
import csv
import os
import statistics
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import timed_run  # noqa: E402

SCENES = os.path.join(timed_run.ROOT, "libdem", "scenes")
BED, DRUM = os.path.join(SCENES, "bed_spheres.toml"), os.path.join(SCENES, "drum.toml")
SKINS = [0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0]  # diameters


def turn_by_turn(given, rows):
    """rows: (name, scene, settings). {name: [Timed]}."""
    found = {name: [] for name, _, _ in rows}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(given.reps):
            for name, scene, settings in rows:
                found[name].append(timed_run.run(given.dem, folder, scene, settings))
    return found


def loop_ns(timed):
    return 1e9 * timed.seconds("loop") / timed.particle_steps


def list_ns(timed):
    return 1e9 * timed.seconds("broad_phase") / timed.particle_steps


def skins(given, name, scene, diameter, settings):
    """One table; the states at the end of all rows, and rows for the file."""
    rows = [(f"{s:g}", scene, settings + [f"run.skin={s * diameter:.9g}"]) for s in SKINS]
    rows += [("auto", scene, settings + ["run.skin=auto"]),
             ("none: every step", scene, settings + [f"run.skin={1e-3 * diameter:.9g}", "run.rebuild_every=1"])]
    found = turn_by_turn(given, rows)
    best = min(statistics.median(map(loop_ns, timed)) for timed in found.values())
    print(name)
    table = [["skin, diameters", "ns/step (range)", "x best", "of it the list", "rebuilds", "steps per rebuild", "candidates per body", "state"]]
    states, lines = set(), []
    for label, timed in found.items():
        times, last = [loop_ns(t) for t in timed], timed[-1].summary
        rebuilds = last["counters"]["rebuilds"]
        states |= {t.summary["state_hash"] for t in timed}
        table.append([label, f"{statistics.median(times):.1f} ({min(times):.1f}–{max(times):.1f})", f"{statistics.median(times) / best:.2f}",
                      f"{statistics.median(map(list_ns, timed)):.1f}", str(rebuilds), f"{last['steps'] / max(1, rebuilds):.0f}",
                      f"{last['counters']['candidates'] / last['particles']:.1f}", last["state_hash"]])
        lines += [(name, label, t.summary["counters"]["rebuilds"], loop_ns(t), list_ns(t)) for t in timed]
    timed_run.print_table(table)
    return states, lines


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--reps", type=int, default=5)
    arguments.add_argument("--quick", action="store_true")
    arguments.add_argument("--csv")
    arguments.add_argument("--dem", default=timed_run.PROGRAM)
    given = arguments.parse_args()
    if given.quick:
        given.reps = 1
    print("\n".join(f"{k}: {v}" for k, v in timed_run.about(given.dem).items()), flush=True)
    share = 0.2 if given.quick else 1
    quiet = ["output.vtk=false", "output.hdf5=false", "output.picture=false", "output.walls=false"]
    try:
        lines, same = [], True
        for name, scene, diameter, settings in (("Settled bed", BED, 0.002, [f"run.steps={round(1000 * share)}"]),
                                                ("Drum", DRUM, 0.003, quiet + [f"run.time={0.2 * share:g}"])):
            states, rows = skins(given, name, scene, diameter, settings)
            lines += rows
            same = same and len(states) == 1
            print(f"{name}: the state at the end {'is the same for every skin' if len(states) == 1 else f'DIFFERS: {sorted(states)}'}\n")
    except timed_run.Failed as fault:
        sys.exit(str(fault))
    if given.csv:
        with open(given.csv, "w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([("scene", "skin", "rebuilds", "ns_step", "list_ns_step")] + lines)
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
