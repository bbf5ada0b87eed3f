#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Campbell diagrams of a modal study: plot_campbell.py DIR reads campbell.csv and resonances.csv of the
folder DIR and writes campbell_BODY.svg beside them, one for each body. Needs numpy and matplotlib."""
import sys
from pathlib import Path

try:
    import numpy as np
    import matplotlib  # noqa: F401
except ImportError as error:
    sys.exit(f"no diagram: {error} (Debian: python3-numpy, python3-matplotlib)")

import style
from matplotlib import pyplot as plt
from run_folder import Table

LINES = {"standing": "-", "forward": "--", "backward": ":"}


def draw(body, branches, resonances):
    """One body: frequencies in the turning axes over its speed, a colour a nodal diameter."""
    figure, axes = plt.subplots()
    mine = branches["body"] == body
    keys = sorted({(int(n), d, int(o)) for n, d, o in zip(
        branches["nodal diameter"][mine], branches["direction"][mine], branches["order"][mine])})
    named = set()
    for diameter, direction, order in keys:
        rows = mine & (branches["nodal diameter"] == diameter) & (
            branches["direction"] == direction) & (branches["order"] == order)
        speed, frequency = branches["speed"][rows], branches["frequency"][rows]
        label = None
        if (diameter, direction) not in named:
            named.add((diameter, direction))
            label = f"{diameter} diameters" if diameter >= 0 else "modes"
            label += "" if direction == "standing" else ", " + direction
        along = np.argsort(speed)
        axes.plot(speed[along], frequency[along] * 1e-3, LINES[direction], marker=".", markersize=3,
                  color=style.COLOURS[diameter % len(style.COLOURS)], label=label)
    top = 1.05e-3 * branches["frequency"][mine].max()
    if resonances is not None:
        hit = resonances["body"] == body
        axes.plot(resonances["speed"][hit], resonances["frequency"][hit] * 1e-3, "o", markersize=5,
                  markerfacecolor="none", color=style.GREY, label="resonance")
        end = np.abs(branches["speed"][mine]).max()
        for order in sorted(set(resonances["mesh order"][hit])):
            rows = hit & (resonances["mesh order"] == order)
            slope = np.median(resonances["frequency"][rows] / np.abs(resonances["speed"][rows]))
            if order > 0:
                axes.plot([0, end], [0, slope * end * 1e-3], color=style.GREY, linewidth=0.6)
    axes.set(title=f"{body}: natural frequencies in axes that turn with it", ylim=(0, top),
             xlabel=branches.label("speed"), ylabel="frequency [kHz]")
    axes.legend(fontsize=7, ncol=2, loc="upper left", bbox_to_anchor=(1., 1.))
    return figure


def draw_bodies(folder):
    """Name of each body and its diagram."""
    branches = Table(folder / "campbell.csv")
    resonances = folder / "resonances.csv"
    resonances = Table(resonances) if resonances.is_file() else None
    if resonances is not None and resonances.n_rows == 0:
        resonances = None
    for body in sorted(set(branches["body"])):
        yield body, draw(body, branches, resonances)


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    folder = Path(arguments[0])
    try:
        for body, figure in draw_bodies(folder):
            style.save(figure, folder / f"campbell_{body}.svg")
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"campbell diagram: {error or type(error).__name__}")


if __name__ == "__main__":
    main(sys.argv[1:])
