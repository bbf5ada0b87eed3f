# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of shafts in bearings: loads and displacements of the bearings, misalignment of the members of a pair, laws of the
bearings."""
import numpy as np

from ..data.table import read_table
from .style import COLOURS, add_legend, plt


def place_of(table):
    """Where the rows of a table belong, with a label: times of a run [ms], or positions of an analysis."""
    if "time" in table:
        return 1e3 * table["time"], "time [ms]"
    return table["position"], table.label("position")


def list_bearings(table):
    """Names, each once, in the order of the rows."""
    return list(dict.fromkeys(table["bearing"]))


def draw_bearings(run):
    """Radial and axial forces, and radial displacements of the seats."""
    table = run.bearings
    place, label = place_of(table)
    plot, panels = plt.subplots(3, 1, sharex=True, figsize=(8, 7))
    for k, name in enumerate(list_bearings(table)):
        rows = table["bearing"] == name
        for axes, column in zip(panels, ("radial force", "force z", "radial displacement")):
            axes.plot(place[rows], table[column][rows], ".-" if np.count_nonzero(rows) < 30 else "-",
                      color=COLOURS[k % len(COLOURS)], linewidth=0.9, label=name)
    for axes, column, title in zip(panels, ("radial force", "force z", "radial displacement"),
                                   ("Radial force of each bearing on its shaft",
                                    "Axial force of each bearing on its shaft, from apex to back", "Radial displacement of each seat")):
        axes.set(title=title, ylabel=table.label(column))
        axes.margins(x=0)
    panels[-1].set_xlabel(label)
    add_legend(panels[0], fontsize=8, ncol=3)
    return plot


def draw_misalignment(run):
    """Changes of offset, axial positions and shaft angle."""
    table = run.misalignment
    place, label = place_of(table)
    plot, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 5))
    for k, column in enumerate(("offset", "pinion axial shift", "gear axial shift")):
        panels[0].plot(place, table[column], color=COLOURS[k + 1], label=column)
    panels[1].plot(place, table["shaft angle error"], color=COLOURS[4])
    panels[0].set(title="Misalignment of the members under load", ylabel="displacement [um]")
    panels[1].set(ylabel=table.label("shaft angle error"), xlabel=label)
    for axes in panels:
        axes.margins(x=0)
    add_legend(panels[0], fontsize=8)
    return plot


def draw_bearing_curves(run):
    """Load over displacement, a panel a direction."""
    table = read_table(run.path / "bearing_curves.csv")
    if table is None:
        return None
    plot, panels = plt.subplots(1, 2, figsize=(9, 4))
    for axes, direction in zip(panels, ("radial", "axial")):
        for k, name in enumerate(list_bearings(table)):
            rows = (table["bearing"] == name) & (table["direction"] == direction)
            axes.plot(table["displacement"][rows], 1e-3 * table["force"][rows],
                      color=COLOURS[k % len(COLOURS)], label=name)
        axes.set(title=f"{direction} load", xlabel=table.label("displacement"), ylabel="force [kN]")
    add_legend(panels[0], fontsize=8)
    return plot
