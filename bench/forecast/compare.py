#!/usr/bin/env python3
"""What `dem check` expects of a run, against what the run then takes.

For each scene: time (processor time on one thread), memory (largest resident set) and disk, expected, measured, and
their ratio expected / measured. Ends with status 1 when a ratio of time or memory is not within a factor of 2.

    python3 bench/forecast/compare.py            # short forms of the shipped scenes, some minutes
    python3 bench/forecast/compare.py --full     # as shipped
    python3 bench/forecast/compare.py pile_2d
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEM = ROOT / "build" / "release" / "bin" / "dem"
SCENES = ROOT / "libdem" / "scenes"

# Short forms: the same scene with these keys set.
SHORT = {
    "bed_spheres": ["run.steps=500"],
    "box_stack": ["run.time=1"],
    "hopper_grains": ["run.time=0.8", "fill[0].count=200", "fill[1].count=200", "fill[2].count=150"],
    "pile_2d": ["run.time=0.5"],
}


def overrides(keys):
    return [word for key in keys for word in ("--set", key)]


def expected(scene, keys):
    out = subprocess.run([DEM, "check", scene, "--json", *overrides(keys)], check=True, capture_output=True, text=True)
    return json.loads(out.stdout)


def measured(scene, keys):
    folder = tempfile.mkdtemp(prefix="dem-forecast-")
    try:
        command = [str(DEM), "run", str(scene), "--out", folder, "--quiet", "--threads", "1", *overrides(keys)]
        pid = os.posix_spawn(command[0], command, os.environ,
                             file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)])
        _, status, usage = os.wait4(pid, 0)
        if os.waitstatus_to_exitcode(status) != 0:
            raise SystemExit(f"{scene.name}: the run failed")
        disk = sum(f.stat().st_size for f in pathlib.Path(folder).rglob("*") if f.is_file())
        return {"seconds": usage.ru_utime + usage.ru_stime, "bytes": 1024 * usage.ru_maxrss, "disk_bytes": disk}
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def main():
    parser = argparse.ArgumentParser(description="expected cost of runs against the measured one")
    parser.add_argument("scenes", nargs="*", help="names of shipped scenes (default: all)")
    parser.add_argument("--full", action="store_true", help="as shipped, not the short forms")
    arguments = parser.parse_args()
    names = arguments.scenes or sorted(p.stem for p in SCENES.glob("*.toml"))
    print(f"{'scene':<20} {'time, s':>24} {'':>6} {'memory, MB':>18} {'':>6} {'disk, MB':>18}")
    print(f"{'':<20} {'expected':>11} {'measured':>12} {'ratio':>6} {'expected':>8} {'measured':>9} {'ratio':>6} "
          f"{'expected':>8} {'measured':>9} {'ratio':>6}")
    good = True
    for name in names:
        scene, keys = SCENES / f"{name}.toml", [] if arguments.full else SHORT.get(name, [])
        guess, truth = expected(scene, keys), measured(scene, keys)
        ratio = {key: guess[key] / truth[key] for key in truth}
        good = good and all(0.5 <= ratio[key] <= 2 for key in ("seconds", "bytes"))
        print(f"{name:<20} {guess['seconds']:>11.2f} {truth['seconds']:>12.2f} {ratio['seconds']:>6.2f} "
              f"{guess['bytes'] / 1e6:>8.1f} {truth['bytes'] / 1e6:>9.1f} {ratio['bytes']:>6.2f} "
              f"{guess['disk_bytes'] / 1e6:>8.1f} {truth['disk_bytes'] / 1e6:>9.1f} {ratio['disk_bytes']:>6.2f}",
              flush=True)
    print("all within a factor of 2" if good else "NOT all within a factor of 2")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
