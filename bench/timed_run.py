"""What benches share: one run of the program, watched, and the machine that it ran on."""
import json
import os
import subprocess
import sys
import time
from dataclasses import dataclass

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PROGRAM = os.path.join(ROOT, "build", "release", "bin", "dem")


class Failed(RuntimeError):
    """A run that stopped, with its message."""


@dataclass
class Timed:
    """A run: its summary.json, the share of a core that it got, its peak of memory in MB."""
    summary: dict
    share: float
    memory: float

    def seconds(self, *phases):
        """Of these phases, less what other programs had of the core meanwhile."""
        return min(1.0, self.share) * sum(self.summary["seconds"][phase] for phase in phases)

    @property
    def particle_steps(self):
        return self.summary["particle_steps_per_s"] * self.summary["seconds"]["loop"]


def watched(command, messages, folder=None, environment=None):
    """Runs a program: wall time, what it used, peak of its memory in MB, exit code. The kernel's own figure for a child begins with
    the memory of the parent, so the peak is looked up while the child lives."""
    began, peak = time.time(), 0
    child = subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=messages, stderr=messages)
    while True:
        ended, status, usage = os.wait4(child.pid, os.WNOHANG)
        if ended:
            child.returncode = os.waitstatus_to_exitcode(status)
            return time.time() - began, usage, peak / 1024, child.returncode
        with open(f"/proc/{child.pid}/status", encoding="ascii") as file:
            peak = next((int(line.split()[1]) for line in file if line.startswith("VmHWM")), peak)
        time.sleep(0.02)


def run(program, folder, scene, settings=()):
    """Runs a scene (a path) on one thread into folder/run; raises Failed with its message."""
    out = os.path.join(folder, "run")
    command = [program, "run", scene, "--out", out, "--force", "--quiet", "--threads", "1"]
    for setting in settings:
        command += ["--set", setting]
    with open(os.path.join(folder, "messages"), "w+", encoding="utf-8") as messages:
        wall, usage, memory, code = watched(command, messages)
        if code != 0:
            messages.seek(0)
            raise Failed(messages.read().strip()[-500:])
    with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
        return Timed(json.load(file), (usage.ru_utime + usage.ru_stime) / wall, memory)


def run_text(program, folder, text, settings=()):
    """The same of the text of a scene."""
    path = os.path.join(folder, "scene.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return run(program, folder, path, settings)


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        return next((line.split(":")[1].strip() for line in file if line.startswith("model name")), "unknown")


def about(program):
    """Version of the program, processor, command."""
    if not os.path.exists(program):
        sys.exit(f"{program} is not there: build first (./run does)")
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    return {"version": version, "processor": processor(), "command": " ".join(["python3"] + sys.argv)}


def print_table(rows):
    """Markdown; the first row is the head."""
    for number, row in enumerate(rows):
        print("| " + " | ".join(row) + " |")
        if number == 0:
            print("|" + "---|" * len(row))
    print(flush=True)
