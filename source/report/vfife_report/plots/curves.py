# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of the runs' quantities over what a sweep varies."""
import numpy as np

from ..measures.quantities import list_quantities
from .style import COLOURS, add_legend, plt

# Figures of analyses that belong together, by the ends of their names.
GROUPS = (("root stresses", ("root tension", "root compression", "root stress range")),
          ("von Mises stresses, largest", ("von Mises largest",)))
OSCILLATION = ("peak to peak", "peak to peak of the record", "peak to peak of the mean mesh cycle", "standard deviation")
LINES = ("-", "--", ":")  # where there are more curves than colours
NOT_DRAWN = ("drift per mesh cycle", "change between mesh cycles (rms)", "share of the variance at mesh harmonics",
             "duration of the stress cycle", "contact duration", "contact stress limit (input)")


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
    else:
        axes.locator_params(axis="x", nbins=5)  # numbers of five digits beside each other
    axes.set_xlabel(axis.label)


def split_name(name):
    """What a quantity is of, and which number of it: "dte, mean" of a run's history, "transmission error mean" of an
    analysis over positions."""
    of, comma, what = name.rpartition(", ")
    if comma:
        return of, what
    for group, ends in GROUPS:
        if name.endswith(ends):
            return group, name
    for what in ("mean", "peak to peak"):
        if name.endswith(f" {what}"):
            return name.removesuffix(f" {what}"), what
    return "", name


def collect_curves(axis):
    """Panels of curves: title and unit -> curves, name -> values over the axis. Means of a history for
    themselves, sizes of its oscillation together, the rest by what the quantities are of."""
    panels = {}
    for position, variant in enumerate(axis.variants):
        for name, value, unit in list_quantities(variant.run):
            of, what = split_name(name)
            if what.startswith(NOT_DRAWN):
                continue
            title = f"{of}, oscillation" if what in OSCILLATION else \
                f"{of}, mean" if what == "mean" else of
            curves = panels.setdefault((title, unit), {})
            curves.setdefault(what, np.full(len(axis.values), np.nan))[position] = value
    return panels


def draw_curves(study):
    """All quantities over the parameter, a panel a kind; None without any."""
    axis = study.axis
    panels = collect_curves(axis)
    if not panels:
        return None
    rows = (len(panels) + 1) // 2
    plot, grid = plt.subplots(rows, 2, figsize=(9, 0.4 + 2.7 * rows), squeeze=False)
    for axes, ((title, unit), curves) in zip(grid.ravel(), panels.items()):
        for number, (name, values) in enumerate(curves.items()):
            axes.plot(axis.values, values, "o", linestyle=LINES[number // 6 % len(LINES)], markersize=4,
                      color=COLOURS[1 + number % 6], label=name)
        only = next(iter(curves)) if len(curves) == 1 else ""
        axes.set(title=title if title.endswith(only) else ", ".join(filter(None, (title, only))), ylabel=f"[{unit}]")
        scale_axis(axes, axis, 0.16)
        if len(curves) > 1:
            add_legend(axes, beside=False, fontsize=8)
    for axes in grid.ravel()[len(panels):]:
        axes.remove()
    return plot
