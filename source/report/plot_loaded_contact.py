#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of a loaded tooth contact analysis over one tooth mesh: transmission error with and without
load, load sharing, mesh stiffness, stresses.

usage: plot_loaded_contact.py RESULTS_FOLDER [PICTURE.png]
"""
import csv
import sys
from pathlib import Path

import style
from style import plt


def read(path):
    """Rows of a table as dictionaries by column name without unit; numbers as floats."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [name.split(" [")[0] for name in rows[0]]
    return [{n: (v if n == "side" else float(v)) for n, v in zip(names, row)} for row in rows[1:]]


def plot_columns(axes, rows, names, label, scale=1.0):
    for name in names:
        axes.plot(
            [r["position"] for r in rows], [scale * r[name] for r in rows], ".-", label=name)
    axes.set(xlabel="position, tooth meshes", ylabel=label)
    axes.legend()


def plot_shares(axes, rows):
    for pair in sorted({(r["pinion tooth"], r["gear tooth"]) for r in rows}):
        own = [r for r in rows if (r["pinion tooth"], r["gear tooth"]) == pair]
        axes.plot(
            [r["position"] for r in own],
            [r["share of torque"] for r in own],
            ".-",
            label=f"teeth {pair[0]:.0f}/{pair[1]:.0f}")
    axes.set(xlabel="position, tooth meshes", ylabel="share of the torque")
    axes.legend()


def draw(folder):
    """One tooth mesh from the tables of a folder."""
    rows = read(folder / "loaded_contact.csv")
    figure, axes = plt.subplots(2, 2, figsize=(10, 7))
    plot_columns(
        axes[0][0], rows, ["unloaded transmission error", "transmission error"], "arcsec")
    plot_shares(axes[0][1], read(folder / "loaded_teeth.csv"))
    plot_columns(
        axes[1][0], rows, ["secant stiffness", "tangent stiffness"], "MN m/rad", scale=1e-6)
    plot_columns(
        axes[1][1],
        rows,
        ["pinion fillet von mises", "gear fillet von mises", "web von mises"],
        "MPa")
    return figure


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    picture = Path(sys.argv[2]) if len(sys.argv) == 3 else folder / "loaded_contact.png"
    style.save(draw(folder), picture)
    print(picture)


if __name__ == "__main__":
    main()
