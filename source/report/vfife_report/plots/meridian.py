# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Meridian sections of gear bodies, from meridian.csv of studies of kind `mesh`."""
from ..data.table import Table
from .style import EDGE, plt

FILLS = {"teeth": "#f0c04a", "rim": "#b5cde3", "web": "#6f9fd0", "hub": "#d5dde5", "shaft": "#b9b4a6"}
PANELS_A_ROW = 4


def read_parts(folder, body):
    """Corners (z, r) of each part of a body, in the order of the file; ValueError without that body."""
    parts, table = {}, Table(folder / "meridian.csv")
    for owner, part, z, r in zip(*(table[name] for name in ("body", "part", "z", "r"))):
        if owner == body:
            parts.setdefault(part, []).append((z, r))
    if not parts:
        raise ValueError(f"{folder}/meridian.csv: there is no body \"{body}\"")
    return parts


def list_bodies(folder):
    return list(dict.fromkeys(Table(folder / "meridian.csv")["body"]))


def draw_meridian(axes, title, parts):
    named = set()
    for part, corners in parts.items():
        # The sections of a shaft ("shaft 1", "shaft 2") are of one kind.
        name = part.split()[0]
        axes.fill(*zip(*corners), facecolor=FILLS[name], edgecolor=EDGE, lw=0.8, label=None if name in named else name)
        named.add(name)
    axes.set_title(title)
    axes.set_aspect("equal")


def draw_meridians(bodies):
    """Title and parts of each body, a panel each."""
    columns = min(PANELS_A_ROW, len(bodies))
    rows = -(-len(bodies) // columns)
    plot, grid = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True, layout="compressed",
                              figsize=(3.1 * columns, 0.4 + 2.8 * rows))
    panels = list(grid.flat)
    for axes, (title, parts) in zip(panels, bodies):
        draw_meridian(axes, title, parts)
    for axes in panels[len(bodies):]:
        axes.set_axis_off()
    plot.supxlabel("along the axis from the apex [mm]")
    plot.supylabel("radius [mm]")
    fullest = max(zip(panels, bodies), key=lambda pair: len(pair[1][1]))[0]
    # Beside the panels: where a web leaves room in one, another one's fills it.
    panels[columns - 1].legend(*fullest.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(1.01, 1), fontsize=8,
                               frameon=False)
    return plot


def draw_run_meridians(run):
    """Both bodies of a study of kind `mesh`."""
    return draw_meridians([(body, read_parts(run.path, body)) for body in list_bodies(run.path)])
