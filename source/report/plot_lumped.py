#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a lumped model's results: motion at the speed of operation, response over speed.

usage: plot_lumped.py RESULTS_FOLDER
"""
import json
import sys
from pathlib import Path

try:
    import numpy as np
    import matplotlib  # noqa: F401
except ImportError as error:
    sys.exit(f"no picture: {error} (Debian: python3-numpy, python3-matplotlib)")

from run_folder import Table
from style import COLOURS, GREY, add_legend, plt, save

SHOWN_MESHES = 10
COLUMNS = (("dte", "transmission error [arcsec]"), ("mesh force", "mesh force [N]"))
RESPONSES = (("peak to peak dte", "DTE, peak to peak [arcsec]"), ("largest force", "largest mesh force [N]"))


def draw_motion(folder):
    """The last tooth meshes at the speed of operation."""
    motion = Table(folder / "lumped.csv")
    rows = motion["position"] > motion["position"][-1] - SHOWN_MESHES
    figure, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 6))
    for axes, (column, label) in zip(panels, COLUMNS):
        axes.plot(1e3 * motion["time"][rows], motion[column][rows], color=COLOURS[1])
        axes.set_ylabel(label)
        axes.margins(x=0)
    panels[0].set_title(f"Last {SHOWN_MESHES} tooth meshes")
    panels[1].set_xlabel("time [ms]")
    return figure


def draw_response(folder):
    """Over speed, upwards and downwards; None where no sweep was made."""
    if not (folder / "resonance.csv").is_file():
        return None
    sweep = Table(folder / "resonance.csv")
    modes = json.loads((folder / "lumped.json").read_text(encoding="utf-8"))["modes"]
    figure, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 7))
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
    return figure


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


# Name of the picture, what it shows, function of the folder that makes it.
FIGURES = (("lumped_motion", "Motion of the lumped model at the speed of operation.", draw_motion),
           ("lumped_response", "Response of the lumped model over speed.", draw_response))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    for name, _, draw in FIGURES:
        figure = draw(folder)
        if figure is not None:
            save(figure, folder / f"{name}.svg")
            print(folder / f"{name}.svg")


if __name__ == "__main__":
    main()
