#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a tooth contact analysis: lag of neighbouring tooth pairs, contact pattern with
ellipses on the gear flank, ease-off map.

usage: plot_tca.py RESULTS_FOLDER [PICTURE.png]
"""
import csv
import math
import sys
from pathlib import Path

try:
    import numpy  # noqa: F401
    import matplotlib  # noqa: F401
except ImportError as error:
    sys.exit(f"no picture: {error} (Debian: python3-numpy, python3-matplotlib)")

import style
from matplotlib import pyplot as plt


def read(path):
    """Rows of a table as dictionaries by column name without unit; numbers as floats."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [name.split(" [")[0] for name in rows[0]]
    return [
        {n: (v if n == "side" else float(v)) for n, v in zip(names, row)} for row in rows[1:]
    ]


def plot_lag(axes, rows):
    for pair in sorted({row["pair"] for row in rows}):
        own = [row for row in rows if row["pair"] == pair]
        line = axes.plot([r["pitches"] for r in own], [r["lag"] for r in own], "--", lw=0.8)
        axes.plot(
            [r["pitches"] if r["inside"] else math.nan for r in own],
            [r["lag"] for r in own],
            color=line[0].get_color(),
            label=f"tooth pair {pair:.0f}",
        )
    axes.invert_yaxis()
    axes.set(xlabel="pinion rotation, pitches", ylabel="lag of the gear, arcsec (down)")
    axes.legend()


def plot_pattern(axes, rows, border):
    axes.plot(*zip(*border), color=style.EDGE, lw=0.8)
    angles = [math.pi * i / 30 for i in range(61)]
    for row in rows[::2]:
        axes.plot(
            [row["gear L"] + math.cos(a) * row["gear major L"] + math.sin(a) * row["gear minor L"] for a in angles],
            [row["gear h"] + math.cos(a) * row["gear major h"] + math.sin(a) * row["gear minor h"] for a in angles],
            color=style.COLOURS[1],
            lw=0.7,
        )
    axes.plot([r["gear L"] for r in rows], [r["gear h"] for r in rows], ".-",
              color=style.COLOURS[2], label="path of contact")
    axes.set(xlabel="gear L, mm (heel to the right)", ylabel="gear h, mm", aspect="equal")
    axes.legend()


def plot_ease_off(axes, rows):
    values = [r["ease-off"] for r in rows]
    drawn = axes.tricontourf(
        [r["gear L"] for r in rows], [r["gear h"] for r in rows], values, levels=14, cmap=style.STRESS_MAP
    )
    plt.colorbar(drawn, ax=axes, label="ease-off, um", orientation="horizontal")
    axes.set(xlabel="gear L, mm (heel to the right)", ylabel="gear h, mm", aspect="equal")


def outline(rows):
    """Border of the gear flank between fillet and tip, closed."""
    lengths = sorted({r["gear L"] for r in rows})
    heights = [[r["gear h"] for r in rows if r["gear L"] == L] for L in lengths]
    low = [(L, min(h)) for L, h in zip(lengths, heights)]
    high = [(L, max(h)) for L, h in zip(lengths, heights)]
    return low + high[::-1] + low[:1]


def draw(folder):
    """Both sides from the tables of a folder."""
    tables = {name: read(folder / f"{name}.csv") for name in ("tca", "path", "ease_off")}
    figure, grid = plt.subplots(
        3,
        2,
        figsize=(13, 9),
        gridspec_kw={"height_ratios": [3, 1.2, 1.7]},
    )
    for column, side in enumerate(("drive", "coast")):
        lag, path, ease_off = (
            [row for row in tables[name] if row["side"] == side]
            for name in ("tca", "path", "ease_off")
        )
        grid[0][column].set_title(f"{side} side")
        plot_lag(grid[0][column], lag)
        plot_pattern(grid[1][column], path, outline(ease_off))
        plot_ease_off(grid[2][column], ease_off)
    return figure


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    style.save(draw(folder), Path(sys.argv[2]) if len(sys.argv) == 3 else folder / "tca.png")


if __name__ == "__main__":
    main()
