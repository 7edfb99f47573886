#!/usr/bin/env python3
"""figures.py FILE.csv [--out FOLDER]: draws what `bench_trade --csv FILE.csv` measured: error against time, log-log, one
panel per pair of bodies, one figure per group of pairs, for the error of the gap and for that of a Hertz force. Writes
FOLDER/trade_GROUP_ERROR.svg and .png, and the gnuplot script .gp that drew them (needs gnuplot: apt-get install gnuplot-nox).

Each point is a way to answer, cold, one pair a call; 99 % of the pairs err less. Lower left is better. A line joins `auto`
to its tolerances. Errors below 1e-16 are drawn there. Pairs touch with an overlap of 1e-3 of their size."""
import argparse
import csv
import os
import subprocess
import sys

GROUPS = {
    "ellipsoids": ["ellipsoid_1_1_1.5", "ellipsoid_1_1_3", "ellipsoid_1_1_10", "ellipsoid_1_10_10", "ellipsoid_1_1_100", "sphere"],
    "polyhedra": ["cube", "poly12", "poly50", "poly200", "poly1000", "grain_coarse", "grain_fine", "rounded50", "potential"],
    "plane": ["ellipse_1_1.5", "ellipse_1_3", "ellipse_1_10", "ellipse_1_100", "octagon", "disc"],
}
ERRORS = {"gap": "error of the gap / size (99 %)", "hertz_force": "relative error of a Hertz force (99 %)"}
LEAST = 1e-16
COLORS = ["#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#7f7f7f", "#8b4513", "#4b0082",
          "#2e8b57", "#b22222", "#708090"]


def script(rows, pairs, error, output, terminal):
    """The gnuplot text of one figure; None when none of its pairs was measured."""
    panels = [p for p in pairs if any(r["pair"] == p for r in rows)]
    if not panels:
        return None
    ways = sorted({r["by"] for r in rows if r["pair"] in panels and not r["by"].startswith("auto")})
    columns = min(3, len(panels))
    lines = [f"set terminal {terminal}", f"set output '{output}'",
             f"set multiplot layout {-(-len(panels) // columns)},{columns}",
             "set logscale xy", "set format x '10^{%T}'", "set format y '10^{%T}'",
             f"set xtics {LEAST},1e4", "set mxtics 1", "set grid xtics ytics mytics lc rgb '#cccccc', lc rgb '#eeeeee'",
             f"set xrange [{LEAST / 3}:10]", f"set xlabel '{ERRORS[error]}'", "set ylabel 'ns per query'",
             "set bmargin 8", "set key below maxcols 3 samplen 1 font ',9' noenhanced"]
    for panel in panels:
        here = [r for r in rows if r["pair"] == panel and r[error + "_p99"]]
        plots, blocks = [], []

        def add(name, chosen, style):
            points = [(max(LEAST, float(r[error + "_p99"])), float(r["ns"])) for r in chosen]
            if points:
                block = f"$data{len(blocks)}"
                blocks.append(block + " << EOD\n" + "\n".join(f"{x:g} {y:g}" for x, y in points) + "\nEOD")
                plots.append(f"{block} with {style} title '{name}'")

        for number, way in enumerate(ways):
            color = COLORS[number % len(COLORS)]
            add(way, [r for r in here if r["by"] == way],
                f"points pt {4 + number % 10} ps 1.2 lw 2 lc rgb '{color}'")
        add("auto, to a tolerance", [r for r in here if r["by"].startswith("auto")],
            "linespoints pt 7 ps 0.6 lw 1 lc rgb '#888888'")
        lines += blocks + [f"set title '{panel}' noenhanced", "plot " + ", \\\n     ".join(plots)]
    return "\n".join(lines + ["unset multiplot", ""])


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("csv")
    arguments.add_argument("--out", default=".")
    given = arguments.parse_args()
    try:
        with open(given.csv, encoding="utf-8", newline="") as file:
            rows = [r for r in csv.DictReader(file) if r["config"] == "touch" and r["use"] == "cold"]
    except (OSError, KeyError) as fault:
        sys.exit(f"figures.py: {given.csv}: {fault}")
    os.makedirs(given.out, exist_ok=True)
    drawn = 0
    for group, pairs in GROUPS.items():
        for error in ERRORS:
            stem = os.path.join(given.out, f"trade_{group}_{error}")
            shown = [p for p in pairs if any(r["pair"] == p for r in rows)]
            for suffix, terminal in (("svg", f"svg size 1500,{450 * -(-len(shown) // 3)} font 'sans,11' background 'white'"),
                                     ("png", f"pngcairo size 1500,{450 * -(-len(shown) // 3)} font 'sans,11' background 'white'")):
                text = script(rows, pairs, error, f"{stem}.{suffix}", terminal)
                if text is None:
                    continue
                with open(stem + ".gp", "w", encoding="utf-8") as file:
                    file.write(text)
                try:
                    subprocess.run(["gnuplot", stem + ".gp"], check=True)
                except FileNotFoundError:
                    sys.exit("figures.py: gnuplot is not installed: apt-get install gnuplot-nox")
                drawn += 1
    if drawn == 0:
        sys.exit(f"figures.py: {given.csv} holds no touching pair of the groups")
    print(f"{drawn} figures in {given.out}")


if __name__ == "__main__":
    main()
