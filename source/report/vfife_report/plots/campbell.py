# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Campbell diagrams of a modal study, from campbell.csv and resonances.csv."""
import numpy as np

from ..data.table import Table, read_table
from .style import COLOURS, GREY, plt

DASHES_OF_DIRECTION = {"standing": "-", "forward": "--", "backward": ":"}


def list_bodies(run):
    """Names of the bodies that have a diagram."""
    return sorted(set(Table(run.path / "campbell.csv")["body"]))


def draw_campbell(run, body):
    """One body: frequencies in the turning axes over its speed, a colour a nodal diameter."""
    branches, resonances = Table(run.path / "campbell.csv"), read_table(run.path / "resonances.csv")
    plot, axes = plt.subplots()
    mine = branches["body"] == body
    draw_branches(axes, branches, mine)
    top = 1.05e-3 * branches["frequency"][mine].max()
    if resonances is not None:
        mark_resonances(axes, resonances, resonances["body"] == body,
                        np.abs(branches["speed"][mine]).max())
    axes.set(title=f"{body}: natural frequencies in axes that turn with it", ylim=(0, top),
             xlabel=branches.label("speed"), ylabel="frequency [kHz]")
    axes.legend(fontsize=7, ncol=2, loc="upper left", bbox_to_anchor=(1., 1.))
    return plot


def draw_branches(axes, branches, mine):
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
        axes.plot(speed[along], frequency[along] * 1e-3, DASHES_OF_DIRECTION[direction], marker=".",
                  markersize=3, color=COLOURS[diameter % len(COLOURS)], label=label)


def mark_resonances(axes, resonances, mine, end):
    """Where the tooth mesh meets a branch, and the lines of its orders up to the speed `end`."""
    axes.plot(resonances["speed"][mine], resonances["frequency"][mine] * 1e-3, "o", markersize=5,
              markerfacecolor="none", color=GREY, label="resonance")
    for order in sorted(set(resonances["mesh order"][mine])):
        rows = mine & (resonances["mesh order"] == order)
        slope = np.median(resonances["frequency"][rows] / np.abs(resonances["speed"][rows]))
        if order > 0:
            axes.plot([0, end], [0, slope * end * 1e-3], color=GREY, linewidth=0.6)
