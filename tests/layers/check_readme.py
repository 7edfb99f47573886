#!/usr/bin/env python3
"""check_readme.py ROOT DEM: what README.md tells a reader to type exists. In its ```sh blocks every command is a file of the
project or a program the project asks for, every path of the tree is there, and every `dem` command and option is known to the
program; links to files lead somewhere; a ```toml block is a scene that `dem check` accepts."""
import os
import re
import shlex
import subprocess
import sys
import tempfile

FOLDERS = ("shapes/", "libcontact/", "libdem/", "tests/", "bench/", ".ci/")
TOOLS = {"cmake", "ctest", "git", "cd", "paraview", "python3", "sudo"}


def blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


def dem_faults(dem, words):
    if not words or words[0].startswith("-"):
        return
    answer = subprocess.run([dem, words[0], "--help"], capture_output=True, text=True, check=False)
    if answer.returncode:
        yield f"`dem {words[0]}` is not a command of the program"
        return
    for word in words[1:]:
        if word.startswith("--") and not re.search(rf"(^|[\s,]){re.escape(word.split('=')[0])}\b", answer.stdout):
            yield f"`dem {words[0]}` has no option {word}"


def command_faults(root, dem, line):
    words = shlex.split(line, comments=True)
    if not words:
        return
    first = words[0]
    if first.endswith("bin/dem") or first == "dem":
        yield from dem_faults(dem, words[1:])
    elif first in ("./run", "./check", ".ci/run"):
        if not os.access(os.path.join(root, first), os.X_OK):
            yield f"{first} is not there or cannot be run"
        if first == "./run":
            yield from dem_faults(dem, words[1:])
    elif first.startswith(FOLDERS) and first.endswith(".sh"):
        if not os.access(os.path.join(root, first), os.X_OK):
            yield f"{first} is not there or cannot be run"
    elif first not in TOOLS:
        yield f"`{first}` is no command of this project"
    for word in words:
        if word.startswith(FOLDERS) and not os.path.exists(os.path.join(root, word)):
            yield f"{word} does not exist"


def faults(root, dem):
    with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
        text = file.read()
    commands = [line for block in blocks(text, "sh") for line in block.splitlines()]
    if not commands:
        yield "no commands were found"
    for line in commands:
        yield from command_faults(root, dem, line)
    for target in re.findall(r"\]\(([^)#:]+)\)", text):
        if not os.path.exists(os.path.join(root, target)):
            yield f"link to {target}: not there"
    for number, scene in enumerate(blocks(text, "toml"), 1):
        with tempfile.NamedTemporaryFile("w", suffix=".toml", encoding="utf-8") as file:
            file.write(scene)
            file.flush()
            answer = subprocess.run([dem, "check", file.name], capture_output=True, text=True, check=False)
            if answer.returncode:
                yield f"scene {number} is refused: {answer.stderr}"


def main():
    found = list(faults(sys.argv[1], sys.argv[2]))
    print("\n".join("README.md: " + line for line in found) if found else "README.md: everything named is there")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
