# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Response over speed of a sweep in one folder: transmission error, force, waves of the rim."""
import numpy as np

from ..data.table import Table
from .style import COLOURS, add_legend, plt

RESPONSES = (("peak to peak dte", "DTE, peak to peak [arcsec]"), ("largest force", "largest contact force [N]"))
DIRECTIONS = (("up", "o", COLOURS[1]), ("down", "x", COLOURS[2]))


def draw_sweep(run):
    """Figure, its two panels, and the speeds."""
    sweep = Table(run.path / "resonance.csv")
    plot, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 7))
    for axes, (column, label) in zip(panels, RESPONSES):
        for direction, marker, colour in DIRECTIONS:
            rows = sweep["direction"] == direction
            if np.any(rows):
                axes.plot(sweep["speed"][rows], sweep[column][rows], marker=marker, markersize=4,
                          color=colour, label=f"speed {direction}")
        axes.set(ylabel=label)
        axes.set_ylim(bottom=0)
        axes.margins(x=0.01)
    add_legend(panels[0])
    panels[1].set_xlabel("pinion speed [rpm]")
    return plot, panels, sweep["speed"]


def draw_reduced_response(run):
    """Upwards and downwards."""
    plot, panels, _ = draw_sweep(run)
    panels[0].set_title("Response over speed")
    return plot


def draw_wave_response(run):
    """Waves of the rim without their stationary part, a panel each number of diameters."""
    waves = Table(run.path / "wave_response.csv")
    numbers = [n for n in range(1, 100) if f"travelling wave {n}" in waves]
    plot, panels = plt.subplots(len(numbers), 1, sharex=True, squeeze=False,
                                figsize=(8, 1 + 1.4 * len(numbers)))
    for axes, n in zip(panels[:, 0], numbers):
        for direction, marker, colour in DIRECTIONS:
            rows = waves["direction"] == direction
            if np.any(rows):
                axes.plot(waves["speed"][rows], waves[f"travelling wave {n}"][rows], marker=marker,
                          markersize=3, color=colour, label=f"speed {direction}")
        axes.set(ylabel=f"n = {n} [um]")
        axes.set_ylim(bottom=0)
        axes.margins(x=0.01)
    add_legend(panels[0, 0])
    panels[0, 0].set_title("Axial waves of the rim with n diameters, largest deviation from the stationary part")
    panels[-1, 0].set_xlabel("pinion speed [rpm]")
    return plot
