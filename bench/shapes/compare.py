#!/usr/bin/env python3
"""compare.py [--seeds N] [--count N] [--quick] [--only TEXT]... [--out DIR] [--from FILE]... [--dem PROGRAM]

What the shape of a body costs and what it changes, in one scene (scenes.py): bodies are poured into a flat-bottomed bin, come to
rest, and run out through a slot beside the right wall. All have the same solid volume (in the plane: area), density, friction and
spread of size, and the inertia of their shape. Then one grain from X-ray tomography, as a sphere, an ellipsoid, 12 spheres, and
hulls of 12 to 200 vertices. Prints means over the seeds with 95 % intervals (Student's t); all shapes of a seed run before the next
seed begins. Writes DIR/shapes.csv (a row per run), shapes.json (all of it) and a figure, shapes.svg and .png (needs gnuplot).

ns/step     processor time of the time loop over the particle-steps of the whole scene; x sphere: over that of spheres, seed by seed
ns/contact  the same over contact-steps, walls included; touching: contact-steps over particle-steps
cpu s       of the time loop, in which the length of a step counts as well; MB: peak of the process
fraction    solid fraction away from walls and surface as the slot opens (dem analyse: density), and Z, contacts with other bodies
            per body there (coordination)
angle       of repose of what stays, mean of the last 0.1 s (repose)
discharge   while the part from 10 % to 60 % of what leaves ran out (flow)

--count    bodies in space (that in the plane goes with it)
--quick    one seed, only some of the shapes: shows that it works (1 min)
--only     shapes whose name contains a TEXT, and spheres and discs
--from     no runs: tables and figure of earlier files shapes.csv; of a run that is in several the last counts

Run from anywhere; needs build/release/bin/dem (./run builds it). Exit status 1: a run failed."""
import argparse
import csv
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import figure  # noqa: E402
import scenes  # noqa: E402
import timed_run  # noqa: E402

STUDENT = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228]  # 97.5 % at 1, 2, ... degrees of freedom
QUICK = ["sphere", "ellipsoid 1:1:2", "cube", "grain as ellipsoid", "disc", "hexagon"]
BASE = {"space": "sphere", "grain": "sphere", "plane": "disc"}
COLUMNS = [  # key, head, format; ratio is of ns_step
    ("ns_step", "ns/step", "{:.0f}"), ("ratio", "x sphere", "{:.2f}"), ("ns_contact", "ns/contact", "{:.0f}"), ("cpu", "cpu s", "{:.1f}"),
    ("memory", "MB", "{:.1f}"), ("touching", "touching", "{:.2f}"), ("fraction", "fraction", "{:.3f}"), ("coordination", "Z", "{:.2f}"),
    ("angle", "angle, deg", "{:.1f}"), ("discharge", "discharge, kg/s", "{:.3f}")]
BULK = ["fraction", "coordination", "angle", "discharge"]
FIELDS = ["group", "shape", "seed"] + [key for key, _, _ in COLUMNS] + ["opened", "dt", "speed_at_rest", "speed_at_end", "left", "cpu_pct"]


def half_width(values):
    """Half the 95 % interval of the mean; infinite for a single value."""
    n = len(values)
    if n < 2:
        return math.inf
    return STUDENT[min(n - 1, len(STUDENT)) - 1] * statistics.stdev(values) / math.sqrt(n)


def series(program, run, frames, what, extra=()):
    """Rows of what dem analyse finds over time: {quantity: [{column: number or None}]}."""
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([program, "analyse", run, "--frames", frames, "--what", ",".join(what), "--out", out, "--quiet",
                               "--threads", "1", *extra], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise timed_run.Failed(done.stderr.strip())
        found = {}
        for quantity in what:
            with open(os.path.join(out, f"{quantity}_series.csv"), encoding="utf-8", newline="") as file:
                next(file)  # units
                found[quantity] = [{k: float(v) if v else None for k, v in row.items()} for row in csv.DictReader(file)]
    return found


def discharge(rows):
    """Mean rate while the part from 10 % to 60 % of what leaves ran out, and how many leave."""
    total, passed, mass, span = sum(r["left"] or 0 for r in rows), 0, 0.0, 0.0
    for before, now in zip(rows, rows[1:]):
        passed += now["left"]
        if 0.1 * total < passed <= 0.6 * total:
            mass += now["discharge_rate"] * (now["time"] - before["time"])
            span += now["time"] - before["time"]
    return (mass / span if span > 0 else None), total


def measure(program, folder, text, plane):
    """Runs one scene: what it cost and what its bodies did."""
    timed = timed_run.run_text(program, folder, text)
    summary, out = timed.summary, os.path.join(folder, "run")
    loop, particle_steps, contact_steps = timed.seconds("loop"), timed.particle_steps, timed.summary["counters"]["contact_steps"]
    opened = next((event["time"] for event in summary["events"] if event["name"] == "open"), None)
    if opened is None:
        raise timed_run.Failed(f"the bed did not come to rest within {scenes.LATEST} s")
    opens = math.floor(opened / scenes.INTERVAL)  # the last frame before
    where = ",".join(f"{v:.9g}" for v in scenes.region(plane))
    rest = series(program, out, str(opens), ["density", "coordination"], ["--region", where])
    still = series(program, out, str(opens), ["velocity"])["velocity"][0]["mean_speed"]
    end = series(program, out, "-5:", ["repose", "velocity"])
    angles = [r["angle_of_repose"] for r in end["repose"] if r.get("angle_of_repose") is not None]  # no column: no frame has one
    rate, left = discharge(series(program, out, f"{opens}:", ["flow"])["flow"])
    return {"ns_step": 1e9 * loop / particle_steps, "ns_contact": 1e9 * loop / contact_steps, "cpu": loop, "memory": timed.memory,
            "touching": contact_steps / particle_steps, "fraction": rest["density"][0]["solid_fraction"],
            "coordination": rest["coordination"][0]["coordination"], "angle": statistics.mean(angles) if angles else None,
            "discharge": rate, "opened": opened, "dt": summary["dt"], "speed_at_rest": still, "speed_at_end": end["velocity"][-1]["mean_speed"],
            "left": left, "cpu_pct": 100 * timed.share}


def cases(quick, only):
    """(group, shape, texts) of all that runs."""
    rows = []
    for group, bodies in (("space", scenes.solids()), ("grain", scenes.one_grain()), ("plane", scenes.plane_bodies())):
        rows += [(group, name, shapes) for name, shapes in bodies.items()
                 if (not quick or name in QUICK) and (not only or any(text in name for text in only) or name in BASE.values())]
    return rows


def values_of(runs, group, shape, key):
    """Over the seeds; `ratio` is taken seed by seed."""
    mine = {r["seed"]: r for r in runs if r["group"] == group and r["shape"] == shape}
    if key != "ratio":
        return [r[key] for r in mine.values() if r[key] is not None]
    base_group = "plane" if group == "plane" else "space"
    base = {r["seed"]: r["ns_step"] for r in runs if r["group"] == base_group and r["shape"] == BASE[group]}
    return [r["ns_step"] / base[seed] for seed, r in mine.items() if seed in base]


def cell(values, form):
    if not values:
        return "none"
    half = half_width(values)
    return form.format(statistics.mean(values)) + (f" ± {form.format(half)}" if math.isfinite(half) else "")


def shapes_of(runs, group):
    present = {r["shape"] for r in runs if r["group"] == group}
    return [shape for shape in scenes.order() if shape in present]


def table(runs, group, title):
    print(title)
    head = {"ratio": "x disc"} if group == "plane" else {}
    rows = [["shape", "seeds"] + [head.get(key, name) for key, name, _ in COLUMNS]]
    for shape in shapes_of(runs, group):
        seeds = str(len(values_of(runs, group, shape, "cpu")))
        rows.append([shape, seeds] + [cell(values_of(runs, group, shape, key), form) for key, _, form in COLUMNS])
    timed_run.print_table(rows)


def errors(runs):
    """Of one grain: each quantity over that of the finest, and whether their intervals overlap."""
    ladder = [("space", "sphere")] + [("grain", shape) for shape in shapes_of(runs, "grain")]
    finest = ladder[-1]
    rows = [["one grain as", "cost, x sphere"] + [name for key, name, _ in COLUMNS if key in BULK]]
    for group, shape in ladder:
        row = [shape, cell(values_of(runs, group, shape, "ratio"), "{:.2f}")]
        for key in BULK:
            here, best = values_of(runs, group, shape, key), values_of(runs, *finest, key)
            if not here or not best:
                row.append("none")
                continue
            off = statistics.mean(here) - statistics.mean(best)
            known = len(here) > 1 and len(best) > 1
            overlap = known and abs(off) <= half_width(here) + half_width(best)
            same = (group, shape) == finest
            row.append("reference" if same else f"{100 * off / statistics.mean(best):+.1f} %{', indistinguishable' if overlap else ''}")
        rows.append(row)
    print(f"Bulk error relative to the finest ({finest[1]}); indistinguishable: the 95 % intervals overlap")
    timed_run.print_table(rows)


def warn(runs):
    """What makes a number doubtful."""
    speed = math.sqrt(9.81 * scenes.DIAMETER)
    for r in runs:
        who = f"{r['group']}, {r['shape']}, seed {r['seed']}"
        if r["speed_at_end"] > speed:
            print(f"note: {who}: still runs out at the end (mean speed {r['speed_at_end']:.3g} m/s)")
        if r["angle"] is None or r["discharge"] is None:
            print(f"note: {who}: no angle or no discharge ({r['left']:.0f} bodies left)")


def report(runs, out):
    table(runs, "space", "Shapes")
    if shapes_of(runs, "grain"):
        table(runs, "grain", "One grain with rising fidelity")
        errors(runs)
    table(runs, "plane", "In the plane")
    warn(runs)
    figure.draw(out, {group: [(shape, {key: (statistics.mean(v), half_width(v) if len(v) > 2 else math.inf) for key in ["ns_step"] + BULK
                                       if (v := values_of(runs, group, shape, key))}) for shape in shapes_of(runs, group)]
                      for group in ("space", "grain")})


def write(runs, out, about):
    with open(os.path.join(out, "shapes.csv"), "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows([{k: row[k] for k in FIELDS if k in row} for row in runs])
    summary = [{"group": group, "shape": shape} | {key: {"mean": statistics.mean(v), "half_width": half_width(v) if len(v) > 1 else None,
                                                         "seeds": len(v)}
                                                   for key, _, _ in COLUMNS if (v := values_of(runs, group, shape, key))}
               for group in BASE for shape in shapes_of(runs, group)]
    with open(os.path.join(out, "shapes.json"), "w", encoding="utf-8") as file:
        json.dump({"about": about, "table": summary, "runs": runs}, file, indent=1)


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        return [{k: v if k in ("group", "shape") else int(v) if k == "seed" else float(v) if v else None for k, v in row.items()}
                for row in csv.DictReader(file)]


def run_all(given, about):
    runs, failed = [], []
    share = given.count / scenes.SPACE["count"]
    with tempfile.TemporaryDirectory() as folder:
        chosen = cases(given.quick, given.only)
        for seed in range(1, 1 + (1 if given.quick else given.seeds)):
            for group, shape, texts in chosen:
                if (group, shape) in failed:
                    continue
                plane = group == "plane"
                count = round(share * scenes.geometry(plane)["count"])
                try:
                    found = measure(given.dem, folder, scenes.scene(shape, texts, plane, count, seed), plane)
                except timed_run.Failed as fault:
                    failed.append((group, shape))
                    print(f"FAILED {group}, {shape}, seed {seed}: {fault}", flush=True)
                    continue
                runs.append({"group": group, "shape": shape, "seed": seed} | found)
                print(f"RESULT group={group} shape=\"{shape}\" seed={seed} N={count} " +
                      " ".join(f"{k}={v:.4g}" if v is not None else f"{k}=none" for k, v in found.items()), flush=True)
                write(runs, given.out, about)
    return runs, failed


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--seeds", type=int, default=5)
    arguments.add_argument("--count", type=int, default=scenes.SPACE["count"])
    arguments.add_argument("--quick", action="store_true")
    arguments.add_argument("--only", action="append")
    arguments.add_argument("--out", default="build/shapes")
    arguments.add_argument("--from", dest="earlier", action="append")
    arguments.add_argument("--dem", default=timed_run.PROGRAM)
    given = arguments.parse_args()
    os.makedirs(given.out, exist_ok=True)
    if given.earlier:
        report([run for path in given.earlier for run in read(path)], given.out)
        return 0
    about = timed_run.about(given.dem)
    print("\n".join(f"{k}: {v}" for k, v in about.items()) + ("\nquick: numbers are not to be quoted" if given.quick else ""), flush=True)
    runs, failed = run_all(given, about)
    report(runs, given.out)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
