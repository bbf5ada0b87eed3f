#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Meridian sections of gear bodies, a panel for each results folder of a study of kind `mesh`
(meridian.csv): plot_meridian.py [--body NAME] PICTURE RESULTS_FOLDER[=TITLE]..."""
import argparse
import csv
from pathlib import Path

import style
from matplotlib import pyplot as plt

FILLS = {"teeth": "#f0c04a", "rim": "#b5cde3", "web": "#6f9fd0", "hub": "#d5dde5"}
COLUMNS = 4


def read_parts(folder, body):
    """Corners (z, r) of each part of a body, in the order of the file."""
    parts = {}
    with open(folder / "meridian.csv", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if row["body"] == body:
                parts.setdefault(row["part"], []).append((float(row["z [mm]"]), float(row["r [mm]"])))
    if not parts:
        raise SystemExit(f"{folder}/meridian.csv: there is no body \"{body}\"")
    return parts


def draw(axes, title, parts):
    for name, corners in parts.items():
        axes.fill(*zip(*corners), facecolor=FILLS[name], edgecolor=style.EDGE, lw=0.8, label=name)
    axes.set_title(title)
    axes.set_aspect("equal")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--body", default="gear")
    parser.add_argument("picture", type=Path)
    parser.add_argument("folders", nargs="+", help="RESULTS_FOLDER[=TITLE]")
    asked = parser.parse_args()
    bodies = []
    for text in asked.folders:
        folder, _, title = text.partition("=")
        bodies.append((title or Path(folder).name, read_parts(Path(folder), asked.body)))
    columns = min(COLUMNS, len(bodies))
    rows = -(-len(bodies) // columns)
    figure, grid = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True,
                                figsize=(3.1 * columns, 0.4 + 2.8 * rows))
    panels = list(grid.flat)
    for axes, (title, parts) in zip(panels, bodies):
        draw(axes, title, parts)
    for axes in panels[len(bodies):]:
        axes.set_axis_off()
    figure.supxlabel("along the axis from the apex, mm")
    figure.supylabel("radius, mm")
    fullest = max(zip(panels, bodies), key=lambda pair: len(pair[1][1]))[0]
    fullest.legend(loc="lower left", fontsize=8)
    style.save(figure, asked.picture)


if __name__ == "__main__":
    main()
