# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers of a plot as a table: every curve and every set of vertical lines."""
import csv

import numpy as np
from matplotlib.collections import LineCollection

from .style import is_name


def list_curves(plot):
    """Panel, name and points (n, 2) of each curve."""
    for number, axes in enumerate(plot.axes):
        panel = axes.get_title(loc="left") or axes.get_ylabel() or f"panel {number + 1}"
        panel += f" | {axes.get_xlabel()} | {axes.get_ylabel()}"
        unnamed = 0
        for curve in list(axes.lines) + [c for c in axes.collections if type(c) is LineCollection]:
            if isinstance(curve, LineCollection):  # vertical lines: their upper ends
                points = np.array([segment[-1] for segment in curve.get_segments()]).reshape(-1, 2)
            else:
                points = np.asarray(curve.get_xydata(), dtype=float)
            name = str(curve.get_gid() or curve.get_label())  # the former where no legend names it
            if not is_name(name):
                unnamed += 1
                name = f"curve {unnamed}"
            yield panel, name, points


def attach_numbers(plot, header, rows):
    """A table of its own for a plot whose curves are not drawn to scale."""
    plot.vfife_numbers = (header, rows)


def write_plot_data(plot, path):
    """The table that is attached to the plot, or a line a point: panel (title, x axis, y axis), curve,
    x, y. Nothing is written for maps, whose data are not curves."""
    attached = getattr(plot, "vfife_numbers", None)
    if attached:
        write_rows(path, *attached)
        return
    shaded = any(type(c) is not LineCollection for axes in plot.axes for c in axes.collections)
    curves = [] if shaded else list(list_curves(plot))
    if not curves:
        return
    write_rows(path, ["panel", "curve", "x", "y"],
               ([panel, name, f"{x:.9g}", f"{y:.9g}"] for panel, name, points in curves
                for x, y in points if np.isfinite(y)))


def write_rows(path, header, rows):
    """A .csv file, put in place when it is whole."""
    temporary = path.with_name("." + path.name)
    with open(temporary, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
    temporary.replace(path)
