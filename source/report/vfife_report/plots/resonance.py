# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Resonance curves of a sweep over the speed."""
import numpy as np

from ..measures.critical_speeds import list_critical_speeds
from ..measures.ripple import RIPPLES, find_steady_ripple, read_ripple
from .curves import scale_axis
from .style import COLOURS, GREY, list_named, name_decades, plt

# Of a run's statistics, of the columns of another model's response.
KINDS = (("peak to peak", "peak to peak", COLOURS[1]), ("standard deviation", "rms", COLOURS[2]))


def draw_responses(axes, beside, limits, column, kind, what, colour):
    """Of other models. Rising speed dashed (reduced pairs: a full line); falling speed dotted, seen where
    flanks part and both differ."""
    for response in beside.responses:
        table = response.table
        for direction, dashes in (("down", ":"), ("up", "-" if response.model == "reduced pair" else "--")):
            rows = (table["direction"] == direction) & (table["speed"] >= limits[0]) & (
                table["speed"] <= limits[1])
            if np.any(rows):
                axes.plot(table["speed"][rows], table[f"{kind} {column}"][rows], dashes, color=colour,
                          label=f"{response.model}, {what}" if direction == "up" else None, linewidth=0.9,
                          gid=f"{response.model}, {what}, speed {direction}")


def draw_resonance(study):
    """Ripple of transmission error and force over speed, beside other models'; vertical: speeds at
    which a mesh order meets a coupled mode."""
    speeds, beside = study.speeds, study.beside
    axis, steady = speeds.axis, find_steady_ripple(speeds.axis)
    limits = axis.values[0] * 0.97, axis.values[-1] * 1.03
    plot, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 8))
    for axes, (column, of_model) in zip(panels, RIPPLES):
        for what, kind, colour in KINDS:
            values = read_ripple(axis, column, what)
            # Lines between runs would say what other models know better.
            axes.plot(axis.values, values, "o" if beside.responses else "o-", color=colour, markersize=4,
                      label=f"runs, {what}" if beside.responses else what)
            if not np.all(steady):
                axes.plot(axis.values[~steady], values[~steady], "o", color=colour, markersize=8,
                          markerfacecolor="none", label="not steady")
            if axis.unit == "rpm":
                draw_responses(axes, beside, limits, of_model, kind, what, colour)
        for frequency, order, value in list_critical_speeds(beside, speeds):
            axes.axvline(value, color=GREY, linestyle=":", linewidth=0.9,
                         gid=f"mode {frequency:.1f} Hz, mesh order {order}")
            axes.annotate(f"{frequency:.0f} Hz / {order}", (value, 1), fontsize=7, color=GREY,
                          xycoords=("data", "axes fraction"), xytext=(2, -2), rotation=90, va="top",
                          textcoords="offset points")
        unit = axis.variants[0].run.history.units[column]
        axes.set(title=column, ylabel=f"[{unit}]", yscale="log")
        scale_axis(axes, axis, 0.08)
        axes.set_xlim(limits)
        name_decades(axes)
    panels[0].set_xlabel("")
    handles = dict(zip(*reversed(list_named(panels[0]))))
    panels[1].legend(handles.values(), handles.keys(), frameon=False, fontsize=8, ncol=3,
                     loc="upper center", bbox_to_anchor=(0.5, -0.14))
    return plot
