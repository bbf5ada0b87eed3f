#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of a lumped model's results: motion at the speed of operation, response over speed.

usage: plot_lumped.py RESULTS_FOLDER [PICTURE.png]
"""
import csv
import json
import sys
from pathlib import Path

from style import COLOURS, GREY, plt, save


def read(path):
    """Columns of a table by name without unit; numbers as floats."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [name.split(" [")[0] for name in rows[0]]
    return {
        name: [row[i] if name == "direction" else float(row[i]) for row in rows[1:]]
        for i, name in enumerate(names)
    }


def plot_motion(axes, motion, column, label):
    """The last ten tooth meshes."""
    end = motion["position"][-1]
    rows = [i for i, x in enumerate(motion["position"]) if x > end - 10]
    axes.plot([1e3 * motion["time"][i] for i in rows], [motion[column][i] for i in rows])
    axes.set(xlabel="time, ms", ylabel=label)


def plot_response(axes, sweep, column, label):
    for direction, marker, colour in (("up", "o", COLOURS[1]), ("down", "x", COLOURS[2])):
        rows = [i for i, d in enumerate(sweep["direction"]) if d == direction]
        if rows:
            axes.plot(
                [sweep["speed"][i] for i in rows], [sweep[column][i] for i in rows],
                marker=marker, markersize=4, color=colour, label=f"speed {direction}")
    axes.set(xlabel="pinion speed, rpm", ylabel=label, ylim=(0, None))
    axes.legend()


def mark_critical_speeds(axes, modes, speeds):
    for mode in modes:
        for order, speed in enumerate(
                mode["critical pinion speeds of mesh orders 1, 2, 3 [rpm]"], 1):
            if min(speeds) <= speed <= max(speeds):
                axes.axvline(speed, color=GREY, linestyle=":")
                axes.annotate(
                    f"{mode['frequency [Hz]']:.0f} Hz / {order}", (speed, 1),
                    xycoords=("data", "axes fraction"), xytext=(2, -2),
                    textcoords="offset points", rotation=90, va="top", color=GREY, fontsize=8)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    picture = Path(sys.argv[2]) if len(sys.argv) == 3 else folder / "lumped.png"
    motion = read(folder / "lumped.csv")
    has_sweep = (folder / "resonance.csv").exists()
    figure, axes = plt.subplots(2, 2 if has_sweep else 1, figsize=(10, 7), squeeze=False)
    plot_motion(axes[0][0], motion, "dte", "transmission error, arcsec")
    plot_motion(axes[1][0], motion, "mesh force", "mesh force, N")
    if has_sweep:
        sweep = read(folder / "resonance.csv")
        modes = json.loads((folder / "lumped.json").read_text(encoding="utf-8"))["modes"]
        plot_response(axes[0][1], sweep, "peak to peak dte", "DTE peak to peak, arcsec")
        plot_response(axes[1][1], sweep, "largest force", "largest mesh force, N")
        for row in (0, 1):
            mark_critical_speeds(axes[row][1], modes, sweep["speed"])
    save(figure, picture)
    print(picture)


if __name__ == "__main__":
    main()
