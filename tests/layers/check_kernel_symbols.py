#!/usr/bin/env python3
"""check_kernel_symbols.py SET OBJECT [OBJECT…] SET OBJECT …: a linker keeps one copy of a weak symbol. If an object compiled
for a wide instruction set offered an ordinary inline function, that copy could reach a processor that cannot run it. So every
weak symbol of such an object belongs to its own set: to the set's namespace, or to a pack type of that set's width."""
import re
import subprocess
import sys

SETS = ("sse2", "avx2", "avx512")
PACK = re.compile(r"_VecBuiltin<|_VecBltnBtmsk<")


def weak_symbols(path):
    listing = subprocess.run(["nm", "-C", "--defined-only", path], capture_output=True, text=True, check=True).stdout
    for line in listing.splitlines():
        found = re.match(r"[0-9a-f]*\s+([WwVvu])\s+(.*)", line)
        if found and not found.group(2).startswith("DW.ref."):  # a pointer to the exception handler, no code
            yield found.group(2)


def main():
    owner, faults, objects, current = {}, [], 0, None
    for word in sys.argv[1:]:
        if word in SETS:
            current = word
            continue
        for path in filter(None, word.split(";")):
            objects += 1
            for symbol in weak_symbols(path):
                if f"::{current}::" not in symbol and not PACK.search(symbol):
                    faults.append(f"{path}: {symbol} belongs to no set")
                if owner.setdefault(symbol, current) != current:
                    faults.append(f"{path}: {symbol} stands in {owner[symbol]} and in {current}")
    print("\n".join(faults) if faults else f"{objects} objects, {len(owner)} weak symbols, each in one set")
    return 1 if faults or not objects else 0


if __name__ == "__main__":
    sys.exit(main())
