"""The programs that compare.py times: this one, LAMMPS, LIGGGHTS and YADE, each pinned to the same cores."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
import timed_run  # noqa: E402


def timed(command, cores, folder, environment=None):
    """Runs a command on the first `cores` cores; (what it printed, share of these cores in percent, peak memory in bytes)."""
    pinned = ["taskset", "-c", ",".join(map(str, range(cores)))] + command
    with tempfile.TemporaryFile("w+", encoding="utf-8") as messages:
        wall, usage, memory, code = timed_run.watched(pinned, messages, folder, dict(os.environ, **(environment or {})))
        messages.seek(0)
        text = messages.read()
    if code:
        raise timed_run.Failed(f"{' '.join(command)}\n{text[-2000:]}\nexit status {code}")
    return text, 100 * (usage.ru_utime + usage.ru_stime) / wall / cores, memory * 2**20


def result(bodies, steps, wall, contacts, share, memory, note="", kinetic=None):
    """What every program gives: particle-steps per second, contacts a body, share of its cores (%), memory (bytes)."""
    return {"rate": bodies * steps / wall, "contacts": contacts, "cpu_pct": share, "memory": memory, "note": note,
            "kinetic": kinetic}


def run_dem(dem, scene, out, cores, settings):
    """One run of a scene; its summary, with `cpu_pct` and `memory` of the process."""
    command = [dem, "run", scene, "--out", out, "--force", "--quiet", "--threads", str(cores)]
    for setting in settings:
        command += ["--set", setting]
    _, share, memory = timed(command, cores, os.path.dirname(out), {"OMP_NUM_THREADS": str(cores)})
    with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    return dict(summary, cpu_pct=share, memory=memory)


def dem_result(summary):
    energies = summary["energies"]
    return result(summary["particles"], summary["steps"], summary["seconds"]["loop"], summary["contacts_per_particle"],
                  summary["cpu_pct"], summary["memory"],
                  f"rebuilds {summary['counters']['rebuilds']}, state {summary.get('state_hash', '')}",
                  energies["translational"] + energies["rotational"])


def mpi(cores):
    if cores == 1:
        return []
    return ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(cores)]


def deck(program, name, variables, bodies, steps, cores, folder):
    """LAMMPS or LIGGGHTS with a deck of this folder, that runs twice: to warm up, and the steps that its own timer times."""
    command = mpi(cores) + [program, "-in", os.path.join(HERE, name), "-log", "none"]
    for key, value in variables.items():
        command += ["-var", key, str(value)]
    text, share, memory = timed(command, cores, folder, {"OMP_NUM_THREADS": "1"})
    walls = re.findall(r"Loop time of (\S+) on", text)
    last = re.findall(rf"^\s*\d+\s+{bodies}\s+(\S+)\s+(\S+)\s*$", text, re.MULTILINE)[-1]
    builds = re.findall(r"Neighbor list builds = (\d+)", text)
    return result(bodies, steps, float(walls[1]), float(last[1]) / 2 / bodies, share, memory,
                  f"rebuilds {builds[1] if len(builds) > 1 else '?'}", float(last[0]))


def run_yade(variables, bodies, steps, cores, folder):
    text, share, memory = timed(["yade", "-n", "-x", f"-j{cores}", os.path.join(HERE, "bed_yade.py")], cores, folder,
                                {"OMP_NUM_THREADS": str(cores), "BED": json.dumps(variables)})
    found = re.search(r"TIMED wall=(\S+) contacts=(\d+) rebuilds=(\d+) kinetic=(\S+)", text)
    return result(bodies, steps, float(found[1]), int(found[2]) / bodies, share, memory, f"rebuilds {found[3]}", float(found[4]))


def versions(dem):
    """One line a program: version and instruction set."""
    lines = [subprocess.run([dem, "--version"], capture_output=True, text=True, check=False).stdout.strip()]
    if shutil.which("lmp"):
        text = subprocess.run(["lmp", "-h"], capture_output=True, text=True, check=False).stdout
        lines.append(next((line.strip() for line in text.splitlines() if "Simulator" in line), "LAMMPS"))
    for program, package in (("lmp", "lammps"), ("liggghts", "liggghts"), ("yade", "yade")):
        if shutil.which(program):
            text = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}", package], capture_output=True, text=True,
                                  check=False).stdout
            lines.append(f"{text or program}: the system's package, built for the baseline instruction set (SSE2)")
        else:
            lines.append(f"{package}: not installed, not compared (apt-get install {package})")
    lines.append(timed_run.processor())
    return lines
