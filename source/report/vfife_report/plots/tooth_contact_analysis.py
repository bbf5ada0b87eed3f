# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot of a tooth contact analysis: lag of neighbouring tooth pairs, contact pattern with ellipses on the
gear flank, ease-off map."""
import math

from matplotlib.patches import PathPatch
from matplotlib.path import Path as Outline
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator

from ..data.table import Table
from .style import COLOURS, EDGE, GREY, STRESS_MAP, WIDE, plt

ROUND_LEVELS = MaxNLocator(14, steps=[1, 2, 5, 10])  # of shades


def read_rows(path):
    """Rows of a table as dictionaries by column name."""
    columns = Table(path).columns
    return [dict(zip(columns, cells)) for cells in zip(*columns.values())]


def plot_lag(axes, rows):
    """Lag on the flanks (full), on edges (dash-dotted), of flanks that are not there (dotted)."""
    edges = set()
    for colour, pair in zip(COLOURS[1:], sorted({row["pair"] for row in rows})):
        own = [row for row in rows if row["pair"] == pair]
        flanks = [row for row in own if row["contact"] == "flanks"]
        axes.plot([r["pitches"] for r in flanks], [r["lag"] for r in flanks], ":", lw=0.8, color=colour)
        axes.plot([r["pitches"] if r["inside"] else math.nan for r in flanks],
                  [r["lag"] for r in flanks], color=colour, label=f"tooth pair {pair:.0f}")
        for edge in sorted({row["contact"] for row in own} - {"flanks"}):
            points = [row for row in own if row["contact"] == edge]
            axes.plot([r["pitches"] for r in points], [r["lag"] for r in points], "-.", color=colour)
            # its contact with the flank ends here
            start = min(points, key=lambda r: r["lag"])
            axes.plot(start["pitches"], start["lag"], "o", ms=4, color=colour)
            if edge not in edges:
                axes.annotate(edge, (start["pitches"], start["lag"]), xytext=(5, 5),
                              textcoords="offset points", fontsize=8, color=colour,
                              path_effects=[withStroke(linewidth=2, foreground="white")])
            edges.add(edge)
    least, place = find_least_lag(rows)
    if place:
        axes.plot(place, least, "-", lw=3, alpha=0.25, color=COLOURS[0], label="pair in contact")
        largest = max(r["lag"] for r in rows if r["contact"] == "flanks" and r["inside"])
        axes.set_ylim(max(1.5 * max(least), 1.2 * largest), min(0, min(least)) - 0.3)
    axes.plot([], [], "-.", color=GREY, label="edge contact")
    axes.plot([], [], ":", color=GREY, label="flanks extended beyond their borders")
    axes.set(xlabel="pinion rotation [pitches]", ylabel="lag of the gear [arcsec] (down)")
    axes.locator_params(axis="x", nbins=5)
    axes.legend(fontsize=8, ncol=3, loc="lower right", bbox_to_anchor=(1, 1), frameon=False,
                borderaxespad=0.2, columnspacing=1, handlelength=1.2)


def find_least_lag(rows):
    """The least lag at each sampled rotation, over pairs on their flanks."""
    best = {}
    for row in rows:
        if row["contact"] == "flanks" and row["inside"]:
            key = round(row["pitches"], 9)
            best[key] = min(best.get(key, math.inf), row["lag"])
    places = sorted(best)
    return [best[p] for p in places], places


def plot_pattern(axes, rows, border):
    """Ellipses end at the flank's border (full), the path drawn over them."""
    axes.plot(*zip(*border), color=EDGE, lw=0.8)
    flank = PathPatch(Outline(border), transform=axes.transData)
    turns = [(math.cos(math.pi * i / 30), math.sin(math.pi * i / 30)) for i in range(61)]
    for row in rows[::2]:
        (ellipse,) = axes.plot(
            [row["gear L"] + c * row["gear major L"] + s * row["gear minor L"] for c, s in turns],
            [row["gear h"] + c * row["gear major h"] + s * row["gear minor h"] for c, s in turns],
            color=COLOURS[1], lw=0.7)
        ellipse.set_clip_path(flank)
    axes.plot([r["gear L"] for r in rows], [r["gear h"] for r in rows], ".-",
              color=COLOURS[2], label="path of contact")
    axes.set(xlabel="gear L [mm] (heel to the right)", ylabel="gear h [mm]", aspect="equal")
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1), fontsize=8, frameon=False, borderaxespad=0)


def plot_ease_off(axes, rows):
    values = [r["ease-off"] for r in rows]
    shades = axes.tricontourf([r["gear L"] for r in rows], [r["gear h"] for r in rows],
                              values, levels=ROUND_LEVELS.tick_values(min(values), max(values)), cmap=STRESS_MAP)
    plt.colorbar(shades, ax=axes, label="ease-off [um]", orientation="horizontal")
    axes.set(xlabel="gear L [mm] (heel to the right)", ylabel="gear h [mm]", aspect="equal")


def find_border(rows):
    """Border of the gear flank between fillet and tip, closed."""
    lengths = sorted({r["gear L"] for r in rows})
    heights = [[r["gear h"] for r in rows if r["gear L"] == L] for L in lengths]
    low = [(L, min(h)) for L, h in zip(lengths, heights)]
    high = [(L, max(h)) for L, h in zip(lengths, heights)]
    return low + high[::-1] + low[:1]


@plt.rc_context(WIDE)
def draw_tooth_contact_analysis(run):
    """Both sides, a column each."""
    tables = {name: read_rows(run.path / f"{name}.csv") for name in ("tca", "path", "ease_off")}
    plot, grid = plt.subplots(3, 2, figsize=(13, 9), gridspec_kw={"height_ratios": [3, 1.2, 1.7]})
    for column, side in enumerate(("drive", "coast")):
        lag, path, ease_off = (
            [row for row in tables[name] if row["side"] == side]
            for name in ("tca", "path", "ease_off")
        )
        grid[0][column].set_title(f"{side} side", loc="left")
        if path:
            plot_lag(grid[0][column], lag)
            plot_pattern(grid[1][column], path, find_border(ease_off))
        else:
            grid[0][column].set_axis_off()
            grid[1][column].set_axis_off()
            grid[0][column].text(0.5, 0.5, "no contact inside the flanks", ha="center", va="center",
                                 transform=grid[0][column].transAxes)
        plot_ease_off(grid[2][column], ease_off)
    return plot
