#!/usr/bin/env python3
"""bed_spheres.py [--reps N] [--steps N] [--warm N] [--cores 1|2] [--dem PROGRAM]

The settled bed of 10,000 spheres (libdem/scenes/bed_spheres.toml) in this program and in LAMMPS (gran/hertz/history), turn by
turn in one run, pinned to the same cores. One RESULT line a repetition, one MEDIAN line a program, then their ratio.

Both start from bench/data/spheres_1e4.csv.gz at rest and without history, with dt 1e-5 s and a neighbour skin of 0.2 mm.
LAMMPS makes `warm` steps, then its own loop timer times `steps`; here all warm + steps steps count, so that the first ones,
with cold caches and new contacts, are in. Rate = particles x steps / wall time of the time loop, without output. cpu_pct is the
share of the cores that the whole process got: on a machine that does other work, compare runs near 100 only.

Exit status 0: measured; 77: LAMMPS is not installed (this program is still timed); 1: a program failed."""
import argparse
import gzip
import json
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PACKING = os.path.join(ROOT, "bench", "data", "spheres_1e4.csv.gz")
DT, SKIN = 1e-5, 2e-4


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--reps", type=int, default=5)
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--warm", type=int, default=100)
    parser.add_argument("--cores", type=int, choices=(1, 2), default=1)
    parser.add_argument("--dem", default=os.path.join(ROOT, "build", "release", "bin", "dem"))
    return parser.parse_args()


def read_packing():
    with gzip.open(PACKING, "rt", encoding="ascii") as lines:
        size_x, size_y = (float(v) for v in re.findall(r"=0,([\d.]+)", lines.readline())[:2])
        next(lines)
        return [tuple(map(float, line.split(","))) for line in lines], size_x, size_y


def write_lammps_data(path, rows, size_x, size_y):
    margin, top = 1e-3, 1.15 * max(row[2] for row in rows)
    with open(path, "w", encoding="ascii") as out:
        out.write(f"settled bed\n\n{len(rows)} atoms\n1 atom types\n\n")
        for axis, upper in (("x", size_x + margin), ("y", size_y + margin), ("z", top)):
            out.write(f"{-margin:.9g} {upper:.9g} {axis}lo {axis}hi\n")
        out.write("\nAtoms\n\n")
        for number, (x, y, z, radius) in enumerate(rows, 1):
            out.write(f"{number} 1 {2 * radius:.9g} 2500.0 {x:.9g} {y:.9g} {z:.9g}\n")


def timed(command, cores, folder, environment):
    """Runs pinned to `cores` cores; (standard output, share of those cores in percent)."""
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.time()
    pinned = ["taskset", "-c", "0" if cores == 1 else "0,1"] + command
    done = subprocess.run(pinned, cwd=folder, env=dict(os.environ, **environment), stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    after, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.time() - began
    if done.returncode:
        sys.exit(f"{' '.join(command)}\n{done.stdout[-3000:]}\nexit status {done.returncode}")
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.stdout, 100 * used / wall / cores


def run_dem(args, folder):
    out = os.path.join(folder, "run")
    command = [args.dem, "run", os.path.join(ROOT, "libdem", "scenes", "bed_spheres.toml"), "--out", out, "--force", "--quiet",
               "--threads", str(args.cores), "--set", f"run.steps={args.warm + args.steps}", "--set", f"run.dt={DT}",
               "--set", f"run.skin={SKIN}"]
    _, share = timed(command, args.cores, folder, {"OMP_NUM_THREADS": str(args.cores)})
    with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    return summary["particle_steps_per_s"], summary["contacts_per_particle"], share


def run_lammps(args, folder, bed):
    rows, size_x, size_y = bed
    mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", "2"] if args.cores == 2 else []
    command = mpi + ["lmp", "-in", os.path.join(HERE, "in.bed_spheres_lammps"), "-log", "none"]
    for name, value in (("data", "bed.data"), ("Lx", size_x), ("Ly", size_y), ("warm", args.warm), ("steps", args.steps),
                        ("skin", SKIN), ("dt", DT)):
        command += ["-var", name, str(value)]
    text, share = timed(command, args.cores, folder, {"OMP_NUM_THREADS": "1"})
    wall = float(re.findall(r"Loop time of (\S+) on", text)[1])
    touching = float(re.findall(rf"^\s*\d+\s+{len(rows)}\s+\S+\s+(\S+)\s*$", text, re.MULTILINE)[-1])
    return len(rows) * args.steps / wall, touching / 2 / len(rows), share


def versions(args, with_lammps):
    dem = subprocess.run([args.dem, "--version"], capture_output=True, text=True, check=False).stdout.strip()
    print(dem or args.dem)
    if with_lammps:
        text = subprocess.run(["lmp", "-h"], capture_output=True, text=True, check=False).stdout
        print("lammps:", next((line.strip() for line in text.splitlines() if "Simulator" in line), "version not stated"))
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        print("processor:", next((line.split(":")[1].strip() for line in file if line.startswith("model name")), "unknown"))


def main():
    args = arguments()
    args.dem = os.path.abspath(args.dem)
    if not os.path.exists(args.dem):
        sys.exit(f"{args.dem} is not there: build first (./run does)")
    with_lammps = shutil.which("lmp") is not None and (args.cores == 1 or shutil.which("mpirun") is not None)
    if not with_lammps:
        print("LAMMPS is not compared: apt-get install lammps" + (" openmpi-bin" if args.cores == 2 else ""))
    versions(args, with_lammps)
    bed = read_packing()
    rates = {}
    with tempfile.TemporaryDirectory() as folder:
        write_lammps_data(os.path.join(folder, "bed.data"), *bed)
        programs = {"dem": lambda: run_dem(args, folder)}
        if with_lammps:
            programs["lammps"] = lambda: run_lammps(args, folder, bed)
        for _ in range(args.reps):
            for name, program in programs.items():
                rate, contacts, share = program()
                rates.setdefault(name, []).append(rate)
                print(f"RESULT code={name} N={len(bed[0])} cores={args.cores} steps={args.steps} "
                      f"particle_steps_per_s={rate:.4g} contacts_per_particle={contacts:.3f} cpu_pct={share:.0f}", flush=True)
    for name, values in rates.items():
        print(f"MEDIAN code={name} cores={args.cores} particle_steps_per_s={statistics.median(values):.4g} "
              f"(min {min(values):.4g} max {max(values):.4g})")
    if with_lammps:
        print(f"RATIO dem/lammps = {statistics.median(rates['dem']) / statistics.median(rates['lammps']):.3f}")
    return 0 if with_lammps else 77


if __name__ == "__main__":
    sys.exit(main())
