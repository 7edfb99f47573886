#!/usr/bin/env python3
"""check_schema.py DEM SCENES: the JSON Schema that the program prints is one, accepts every shipped scene, knows every key of
the reference, and refuses scenes with one mistake each. Exit code 77: no jsonschema here."""
import copy
import glob
import json
import os
import subprocess
import sys
import tomllib

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def change(scene, path, value):
    """The scene with the value at a path of keys and indices; None takes the key away."""
    scene = copy.deepcopy(scene)
    place = scene
    for step in path[:-1]:
        place = place[step]
    if value is None:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    return scene


def keys_of(schema, prefix=""):
    for name, entry in schema.get("properties", {}).items():
        yield prefix + name
        yield from keys_of(entry.get("items", entry), prefix + name + ".")


WRONG = [  # of the hopper
    (["run", "dt_fraction"], 0.6),
    (["run", "dt_fraction"], 0),
    (["run", "time"], "1 s"),
    (["run", "seed"], 1.5),
    (["run", "sed"], 1),
    (["run", "dt"], "automatic"),
    (["law", "name"], "hertz"),
    (["law"], None),
    (["law", "name"], None),
    (["world", "gravity"], [0, -9.81]),
    (["world", "gravity"], None),
    (["material", 0, "poisson"], 0.7),
    (["material", 0, "name"], ""),
    (["material", 0, "name"], None),
    (["material"], None),
    (["shape", 0, "radius"], None),
    (["shape", 0, "radius"], 0),
    (["shape", 0, "height"], 1),
    (["shape", 0, "kind"], "ball"),
    (["wall", 0, "velocity"], [0, 0, 1]),
    (["wall", 0, "motion"], "rotation"),
    (["wall"], {"name": "floor"}),
    (["fill", 0, "items"], None),
    (["fill", 0, "items", 0, "scale"], [1, 2, 3]),
    (["output", "vtk"], 1),
    (["include"], []),
]


def main():
    dem, scenes = sys.argv[1:]
    schema = json.loads(output(dem, "schema"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    faults = []
    found = {}
    for path in sorted(glob.glob(os.path.join(scenes, "*.toml"))):
        with open(path, "rb") as file:
            scene = found[os.path.basename(path)] = tomllib.load(file)
        faults += [f"{path}: {error.json_path}: {error.message:.200}" for error in validator.iter_errors(scene)]
    hopper = found["hopper_grains.toml"]
    faults += [f"accepted: {path} = {value!r}" for path, value in WRONG if validator.is_valid(change(hopper, path, value))]
    if not validator.is_valid({"include": ["hopper.toml"], "run": {"time": 2}}):
        faults.append("refused: a scene completed by an included file")
    reference = {entry["key"] for entry in json.loads(output(dem, "list", "keys", "--json"))["keys"]}
    faults += [f"in only one of schema and reference: {key}" for key in reference ^ set(keys_of(schema))]
    print("\n".join(faults) or f"{len(found)} scenes, {len(WRONG)} mistakes, {len(reference)} keys")
    return 1 if faults or len(found) < 4 else 0


if __name__ == "__main__":
    sys.exit(main())
