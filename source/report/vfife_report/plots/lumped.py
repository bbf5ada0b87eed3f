# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a lumped model's results: motion at the speed of operation, response over speed."""
from ..data.files import read_json
from ..data.shapes import LUMPED
from ..data.table import Table
from .speed_response import draw_sweep
from .style import COLOURS, GREY, plt

SHOWN_MESHES = 10
MOTIONS = (("dte", "transmission error [arcsec]"), ("mesh force", "gear mesh force [N]"))


def draw_motion(run):
    """The last mesh cycles at the speed of operation."""
    motion = Table(run.path / "lumped.csv")
    rows = motion["position"] > motion["position"][-1] - SHOWN_MESHES
    plot, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 6))
    for axes, (column, label) in zip(panels, MOTIONS):
        axes.plot(1e3 * motion["time"][rows], motion[column][rows], color=COLOURS[1])
        axes.set_ylabel(label)
        axes.margins(x=0)
    panels[0].set_title(f"Last {SHOWN_MESHES} mesh cycles")
    panels[1].set_xlabel("time [ms]")
    return plot


def draw_response(run):
    """Over speed, upwards and downwards."""
    plot, panels, speeds = draw_sweep(run)
    modes = read_json(run.path / "lumped.json", LUMPED)["modes"]
    for axes in panels:
        mark_critical_speeds(axes, modes, speeds)
    panels[0].set_title("Response over speed (dotted: resonance of a mesh order)")
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
