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
from matplotlib.patches import PathPatch
from matplotlib.path import Path as Outline


TEXTS = ("side", "contact")


def read(path):
    """Rows of a table as dictionaries by column name without unit; numbers as floats."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [name.split(" [")[0] for name in rows[0]]
    return [
        {n: (v if n in TEXTS else float(v)) for n, v in zip(names, row)} for row in rows[1:]
    ]


def plot_lag(axes, rows):
    """Lag on the flanks (full), on edges (dash-dotted), of flanks that are not there (dotted)."""
    edges = set()
    for colour, pair in zip(style.COLOURS[1:], sorted({row["pair"] for row in rows})):
        own = [row for row in rows if row["pair"] == pair]
        flanks = [row for row in own if row["contact"] == "flanks"]
        axes.plot([r["pitches"] for r in flanks], [r["lag"] for r in flanks], ":", lw=0.8, color=colour)
        axes.plot(
            [r["pitches"] if r["inside"] else math.nan for r in flanks],
            [r["lag"] for r in flanks],
            color=colour,
            label=f"tooth pair {pair:.0f}",
        )
        for edge in sorted({row["contact"] for row in own} - {"flanks"}):
            points = [row for row in own if row["contact"] == edge]
            axes.plot([r["pitches"] for r in points], [r["lag"] for r in points], "-.", color=colour)
            # its contact with the flank ends here
            start = min(points, key=lambda r: r["lag"])
            axes.plot(start["pitches"], start["lag"], "o", ms=4, color=colour)
            if edge not in edges:
                axes.annotate(edge, (start["pitches"], start["lag"]), xytext=(5, 5),
                              textcoords="offset points", fontsize=8, color=colour)
            edges.add(edge)
    least, place = least_lag(rows)
    if place:
        axes.plot(place, least, "-", lw=3, alpha=0.25, color=style.COLOURS[0], label="touching pair")
        axes.set_ylim(max(1.5 * max(least), 1.2 * max(r["lag"] for r in rows if r["contact"] == "flanks" and r["inside"])), min(0, min(least)) - 0.3)
    axes.set(xlabel="pinion rotation, pitches", ylabel="lag of the gear, arcsec (down)")
    axes.legend(fontsize=8, ncol=4, loc="lower right", bbox_to_anchor=(1, 1), frameon=False,
                borderaxespad=0.2, columnspacing=1, handlelength=1.2)


def least_lag(rows):
    """The least lag at each sampled rotation, over pairs on their flanks."""
    best = {}
    for row in rows:
        if row["contact"] == "flanks" and row["inside"]:
            key = round(row["pitches"], 9)
            best[key] = min(best.get(key, math.inf), row["lag"])
    places = sorted(best)
    return [best[p] for p in places], places


def plot_pattern(axes, rows, border):
    """Ellipses end at the flank's border (full), the path drawn over them."""
    axes.plot(*zip(*border), color=style.EDGE, lw=0.8)
    flank = PathPatch(Outline(border), transform=axes.transData)
    angles = [math.pi * i / 30 for i in range(61)]
    for row in rows[::2]:
        (ellipse,) = axes.plot(
            [row["gear L"] + math.cos(a) * row["gear major L"] + math.sin(a) * row["gear minor L"] for a in angles],
            [row["gear h"] + math.cos(a) * row["gear major h"] + math.sin(a) * row["gear minor h"] for a in angles],
            color=style.COLOURS[1],
            lw=0.7,
        )
        ellipse.set_clip_path(flank)
    axes.plot([r["gear L"] for r in rows], [r["gear h"] for r in rows], ".-",
              color=style.COLOURS[2], label="path of contact")
    axes.set(xlabel="gear L, mm (heel to the right)", ylabel="gear h, mm", aspect="equal")
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1), fontsize=8, frameon=False, borderaxespad=0)


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
        grid[0][column].set_title(f"{side} side", loc="left")
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
