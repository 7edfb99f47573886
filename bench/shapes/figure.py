"""The figure of the comparison: what bodies do together against what they cost, by gnuplot."""
import math
import os
import shutil
import subprocess

PANELS = [("fraction", "solid fraction"), ("coordination", "contacts per body"), ("angle", "angle of repose, degrees"),
          ("discharge", "discharge, kg/s")]
SERIES = [  # group, name, colour, mark, style, height of the labels
    ("space", "shapes", "#0072b2", 7, "points", 0.6), ("grain", "one grain, coarse to fine", "#d55e00", 5, "linespoints", -0.7)]


def script(groups, output, terminal):
    lines = [f"set terminal {terminal}", f"set output '{output}'", "set multiplot layout 2,2 margins 0.07,0.98,0.06,0.96 spacing 0.08,0.1",
             "set logscale x", "set xlabel 'processor time per particle-step, ns'", "set grid lc rgb '#dddddd'",
             "set offsets graph 0.02, graph 0.15, graph 0.1, graph 0.1", "set key above samplen 2"]
    blocks, panels = [], []
    for key, title in PANELS:
        plots = []
        for group, name, colour, mark, style, height in SERIES:
            rows = [(shape, found) for shape, found in groups.get(group, []) if key in found]
            if not rows:
                continue
            block = f"$data{len(blocks)}"
            labels = [shape.removeprefix("grain as ").removeprefix("grain, ") for shape, _ in rows]
            blocks.append(f"{block} << EOD\n" + "\n".join(
                f'{found["ns_step"][0]:g} {found[key][0]:g} {found[key][1] if math.isfinite(found[key][1]) else 0:g} "{label}"'
                for label, (_, found) in zip(labels, rows)) + "\nEOD")
            plots += [f"{block} using 1:2:3 with yerrorbars pt {mark} lc rgb '{colour}' notitle",
                      f"{block} using 1:2 with {style} pt {mark} lc rgb '{colour}' title '{name}'",
                      f"{block} using 1:2:4 with labels left offset 0.7,{height} font ',8' tc rgb '{colour}' noenhanced notitle"]
        if plots:
            panels += [f"set ylabel '{title}'", "plot " + ", \\\n     ".join(plots)]
    return "\n".join(lines[:1] + blocks + lines[1:] + panels + ["unset multiplot", ""])


def draw(folder, groups):
    """groups: {group: [(shape, {key: (mean, half the interval)})]}. Writes shapes.svg and .png and their scripts."""
    if shutil.which("gnuplot") is None:
        print("no figure: gnuplot is not installed (apt-get install gnuplot-nox)")
        return
    for suffix, terminal in (("svg", "svg size 1300,950 font 'sans,11' background 'white'"),
                             ("png", "pngcairo size 1300,950 font 'sans,11' background 'white'")):
        path = os.path.join(folder, f"shapes_{suffix}.gp")
        with open(path, "w", encoding="utf-8") as file:
            file.write(script(groups, os.path.join(folder, f"shapes.{suffix}"), terminal))
        done = subprocess.run(["gnuplot", path], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print(f"no figure: gnuplot says {done.stderr.strip()}")
            return
