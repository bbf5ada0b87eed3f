# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a lumped model's results: motion at the speed of operation, response over speed."""
import numpy as np

from ..data.files import read_json
from ..data.shapes import LUMPED
from ..data.table import Table
from .style import COLOURS, GREY, add_legend, plt

SHOWN_MESHES = 10
MOTIONS = (("dte", "transmission error [arcsec]"), ("mesh force", "mesh force [N]"))
RESPONSES = (("peak to peak dte", "DTE, peak to peak [arcsec]"), ("largest force", "largest mesh force [N]"))


def draw_motion(run):
    """The last tooth meshes at the speed of operation."""
    motion = Table(run.path / "lumped.csv")
    rows = motion["position"] > motion["position"][-1] - SHOWN_MESHES
    plot, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 6))
    for axes, (column, label) in zip(panels, MOTIONS):
        axes.plot(1e3 * motion["time"][rows], motion[column][rows], color=COLOURS[1])
        axes.set_ylabel(label)
        axes.margins(x=0)
    panels[0].set_title(f"Last {SHOWN_MESHES} tooth meshes")
    panels[1].set_xlabel("time [ms]")
    return plot


def draw_response(run):
    """Over speed, upwards and downwards."""
    sweep = Table(run.path / "resonance.csv")
    modes = read_json(run.path / "lumped.json", LUMPED)["modes"]
    plot, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 7))
    for axes, (column, label) in zip(panels, RESPONSES):
        for direction, marker, colour in (("up", "o", COLOURS[1]), ("down", "x", COLOURS[2])):
            rows = sweep["direction"] == direction
            if np.any(rows):
                axes.plot(sweep["speed"][rows], sweep[column][rows], marker=marker, markersize=4,
                          color=colour, label=f"speed {direction}")
        axes.set(ylabel=label)
        axes.set_ylim(bottom=0)
        axes.margins(x=0.01)
        mark_critical_speeds(axes, modes, sweep["speed"])
    add_legend(panels[0])
    panels[0].set_title("Response over speed; dotted: a mesh order meets a natural frequency")
    panels[1].set_xlabel("pinion speed [rpm]")
    return plot


def mark_critical_speeds(axes, modes, speeds):
    for mode in modes:
        for order, speed in enumerate(
                mode["critical pinion speeds of mesh orders 1, 2, 3 [rpm]"], 1):
            if speeds.min() <= speed <= speeds.max():
                axes.axvline(speed, color=GREY, linestyle=":")
                axes.annotate(
                    f"{mode['frequency [Hz]']:.0f} Hz / {order}", (speed, 1),
                    xycoords=("data", "axes fraction"), xytext=(2, -2),
                    textcoords="offset points", rotation=90, va="top", color=GREY, fontsize=8)
