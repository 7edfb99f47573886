#!/usr/bin/env python3
"""check_layers.py ROOT: reads the sources as text and names every line that breaks a rule of the house; exit 1 if any.

    shapes <- libcontact <- libdem, tests above all, bench above tests (whose cases it measures); nothing includes upward
    a method includes no law; a law includes no method and no shape (shapes/math apart)
    headers of shapes and libcontact, which other programs install, include the standard library, Eigen and each other only
    what *.kernel.cpp reach (they are compiled once per instruction set) holds no Eigen and no shape
    own includes are written from the root; no code file has more than 500 lines
"""
import os
import re
import sys

MAX_LINES = 500
LAYERS = {  # folder: the folders whose headers it may include
    "shapes": {"shapes"},
    "libcontact": {"shapes", "libcontact"},
    "libdem": {"shapes", "libcontact", "libdem"},
    "tests": {"shapes", "libcontact", "libdem", "tests"},
    "bench": {"shapes", "libcontact", "libdem", "tests", "bench"},
}
CODE = (".h", ".cpp", ".c", ".py", ".sh")
INCLUDE = re.compile(r'\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
STANDARD = re.compile(r"[a-z0-9_]+$|experimental/simd$")  # <vector>, <cstdint>, …; <x.h> is not C++
C_DOOR, C_STANDARD = "libcontact/bindings/c/", re.compile(r"std(def|int)[.]h$")
KERNEL_HEADERS = ("shapes/math/", "libcontact/", "libdem/integrators/")


def code_files(root):
    for layer in sorted(LAYERS):
        for folder, _, names in sorted(os.walk(os.path.join(root, layer))):
            for name in sorted(names):
                if name.endswith(CODE):
                    yield os.path.relpath(os.path.join(folder, name), root)


def includes(root, path):
    """(line number, own header or None, system header or None) of every include."""
    with open(os.path.join(root, path), encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            if found := INCLUDE.match(line):
                yield number, found.group(1), found.group(2)


def own_include_fault(path, header):
    layer, target = path.split("/")[0], header.split("/")[0]
    if target not in LAYERS:
        return "is not written from the root"
    if target not in LAYERS[layer]:
        return f"goes upward: {layer} may include {', '.join(sorted(LAYERS[layer]))}"
    if path.startswith("libcontact/methods/") and header.startswith("libcontact/laws/"):
        return "is a law in a method"
    if path.startswith("libcontact/laws/"):
        if header.startswith("libcontact/methods/"):
            return "is a method in a law"
        if header.startswith("shapes/") and not header.startswith("shapes/math/"):
            return "is a shape in a law"
    return None


def system_include_fault(path, header):
    if path.startswith(C_DOOR) and C_STANDARD.match(header):
        return None
    installed = path.endswith(".h") and path.split("/")[0] in ("shapes", "libcontact")
    if installed and not STANDARD.match(header) and not header.startswith("Eigen/"):
        return "is neither the standard library nor Eigen, in a header that others install"
    return None


def kernel_faults(root, kernel):
    """Follows the own includes of a kernel source; a fault names the file that holds the include."""
    todo, seen = [kernel], {kernel}
    while todo:
        path = todo.pop()
        for number, own, system in includes(root, path):
            if system and not STANDARD.match(system):
                yield f"{path}:{number}: <{system}> is reached by {kernel}: only the standard library may be"
            if not own or own in seen:
                continue
            seen.add(own)
            if not own.startswith(KERNEL_HEADERS):
                yield f'{path}:{number}: "{own}" is reached by {kernel}: only shapes/math and kernel templates may be'
            elif os.path.exists(os.path.join(root, own)):
                todo.append(own)


def violations(root):
    for path in code_files(root):
        if path.endswith((".h", ".cpp", ".c")):
            for number, own, system in includes(root, path):
                fault = own_include_fault(path, own) if own else system_include_fault(path, system)
                if fault:
                    shown = f'"{own}"' if own else f"<{system}>"
                    yield f"{path}:{number}: {shown} {fault}"
        with open(os.path.join(root, path), encoding="utf-8") as lines:
            count = sum(1 for _ in lines)
        if count > MAX_LINES:
            yield f"{path}: {count} lines, {MAX_LINES} are allowed"
        if path.endswith(".kernel.cpp"):
            yield from kernel_faults(root, path)


def main():
    found = sorted(set(violations(sys.argv[1])))
    print("\n".join(found) if found else f"{sum(1 for _ in code_files(sys.argv[1]))} files keep the rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
