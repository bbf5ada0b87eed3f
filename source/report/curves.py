# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of the runs' figures over the parameter that a sweep varies, and resonance curves over speed."""
import numpy as np

from key_figures import list_key_figures, read_statistics
from style import COLOURS, GREY, add_legend, plt
from swept import list_critical_speeds

# Ripple of what, as (column of the history, column of a lumped sweep).
RIPPLES = (("dte", "dte"), ("contact force total", "force"))
KINDS = (("peak to peak", "peak to peak", COLOURS[1]), ("standard deviation", "rms", COLOURS[2]))
NOT_DRAWN = ("trend a tooth mesh", "change from mesh to mesh (rms)", "periodic share of the variance",
             "duration of the passage", "in contact for")


def is_wide(values):
    """Whether an axis shows them better by their logarithms."""
    return values.min() > 0 and values.max() > 4 * values.min()


def scale_axis(axes, axis, room):
    """A wide range by logarithms, with the runs' own values as ticks where there is room (part of the
    axis)."""
    if is_wide(axis.values):
        axes.set_xscale("log")
        axes.minorticks_off()
        ticks = [axis.values[0]]
        for value in axis.values[1:]:  # those that leave room for their texts
            if np.log(value / ticks[-1]) > room * np.log(axis.values[-1] / axis.values[0]):
                ticks.append(value)
        axes.set_xticks(ticks, [f"{value:g}" for value in ticks])
    axes.set_xlabel(axis.label)


def collect_figures(axis):
    """Panels of curves: title -> unit and curves, name -> values over the axis. Means of a history for
    themselves, its ripple together, the rest by what the figures are of."""
    panels = {}
    for position, variant in enumerate(axis.variants):
        for name, value, unit in list_key_figures(variant.run):
            of, _, what = name.rpartition(", ")
            if what.startswith(NOT_DRAWN):
                continue
            title = f"{of}, ripple" if what in ("peak to peak", "standard deviation") else \
                name if what == "mean" else of
            curves = panels.setdefault((title, unit), {})
            curves.setdefault(what, np.full(len(axis.values), np.nan))[position] = value
    return panels


def draw_curves(axis):
    """All figures over the parameter, a panel a kind; None without any."""
    panels = collect_figures(axis)
    if not panels:
        return None
    rows = (len(panels) + 1) // 2
    figure, grid = plt.subplots(rows, 2, figsize=(9, 0.4 + 2.7 * rows), squeeze=False)
    for axes, ((title, unit), curves) in zip(grid.ravel(), panels.items()):
        for number, (name, values) in enumerate(curves.items()):
            axes.plot(axis.values, values, "o-", markersize=4, color=COLOURS[1 + number % 6], label=name)
        only = next(iter(curves)) if len(curves) == 1 else ""
        axes.set(title=title if title.endswith(only) else f"{title}, {only}", ylabel=f"[{unit}]")
        scale_axis(axes, axis, 0.16)
        if len(curves) > 1:
            add_legend(axes, fontsize=8)
    for axes in grid.ravel()[len(panels):]:
        axes.remove()
    return figure


def read_ripple(axis, column, what):
    """Of each run's steady part; not a number where there is none."""
    return np.array([(read_statistics(v.run, column) or {}).get(what, np.nan) for v in axis.variants],
                    dtype=float)


def find_steady(axis):
    """Which runs have a steady part."""
    return np.array([bool((v.run.steady_part() or (0, 0, False))[2]) for v in axis.variants])


def draw_lumped(axes, beside, first, last, column, kind, what, colour):
    """Rising speed dashed; falling speed dotted, seen where flanks part and both differ."""
    for table in beside.lumped:
        for direction, dashes in (("down", ":"), ("up", "--")):
            rows = (table["direction"] == direction) & (table["speed"] >= first) & (table["speed"] <= last)
            if np.any(rows):
                axes.plot(table["speed"][rows], table[f"{kind} {column}"][rows], dashes, color=colour,
                          label=f"lumped model, {what}" if direction == "up" else None, linewidth=0.9,
                          gid=f"lumped model, {what}, speed {direction}")


def draw_resonance(speeds, beside):
    """Ripple of transmission error and force over speed, beside the lumped model's; vertical: speeds at
    which a mesh order meets a coupled mode."""
    axis, steady = speeds.axis, find_steady(speeds.axis)
    limits = axis.values[0] * 0.97, axis.values[-1] * 1.03
    figure, panels = plt.subplots(2, 1, sharex=True, figsize=(8, 8))
    for axes, (column, of_lumped) in zip(panels, RIPPLES):
        for what, kind, colour in KINDS:
            values = read_ripple(axis, column, what)
            axes.plot(axis.values, values, "o-", color=colour, markersize=4, label=what)
            if not np.all(steady):
                axes.plot(axis.values[~steady], values[~steady], "o", color=colour, markersize=8,
                          markerfacecolor="none", label="not steady")
            if axis.unit == "rpm":
                draw_lumped(axes, beside, *limits, of_lumped, kind, what, colour)
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
    panels[0].set_xlabel("")
    handles = dict(zip(*reversed(panels[0].get_legend_handles_labels())))
    panels[1].legend(handles.values(), handles.keys(), frameon=False, fontsize=8, ncol=3,
                     loc="upper center", bbox_to_anchor=(0.5, -0.14))
    return figure
