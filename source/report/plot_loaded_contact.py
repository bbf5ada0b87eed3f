#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of a loaded tooth contact analysis over one tooth mesh: transmission error with and without
load, load sharing, mesh stiffness, stresses.

usage: plot_loaded_contact.py RESULTS_FOLDER [PICTURE.png]
"""
import sys
from pathlib import Path

try:
    import numpy  # noqa: F401
    import matplotlib  # noqa: F401
except ImportError as error:
    sys.exit(f"no picture: {error} (Debian: python3-numpy, python3-matplotlib)")

import style
from run_folder import Table
from style import plt

POSITION = "position, tooth meshes"


def plot_columns(axes, table, names, label, scale=1.0):
    for name in names:
        axes.plot(table["position"], scale * table[name], ".-", label=name)
    axes.set(xlabel=POSITION, ylabel=label)
    style.add_legend(axes)


def plot_deviations(axes, table, names):
    """Ripples of different means on one scale; the means are in the names."""
    for name in names:
        mean = table[name].mean()
        axes.plot(table["position"], table[name] - mean, ".-", label=f"{name}, mean {mean:.2f}")
    axes.set(xlabel=POSITION, ylabel="arcsec less the mean")
    style.add_legend(axes)


def plot_shares(axes, teeth):
    for pair in sorted(set(zip(teeth["pinion tooth"], teeth["gear tooth"]))):
        own = (teeth["pinion tooth"] == pair[0]) & (teeth["gear tooth"] == pair[1])
        axes.plot(teeth["position"][own], teeth["share of torque"][own], ".-",
                  label=f"teeth {pair[0]:.0f}/{pair[1]:.0f}")
    axes.set(xlabel=POSITION, ylabel="share of the torque")
    style.add_legend(axes)


def draw(folder):
    """One tooth mesh from the tables of a folder."""
    table = Table(folder / "loaded_contact.csv")
    figure, axes = plt.subplots(2, 2, figsize=(10, 7))
    plot_deviations(axes[0][0], table, ["unloaded transmission error", "transmission error"])
    plot_shares(axes[0][1], Table(folder / "loaded_teeth.csv"))
    plot_columns(axes[1][0], table, ["secant stiffness", "tangent stiffness"], "MN m/rad", 1e-6)
    stresses = [name for name in ("pinion fillet von mises", "gear fillet von mises",
                                  "web von mises") if name in table]
    plot_columns(axes[1][1], table, stresses, "MPa")
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
