# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of pressures on the own grid: during the engagement of a tooth, and on its flank."""
import numpy as np

from ..data.table import Table
from .style import COLOURS, add_legend, plt

SHOWN_POSITIONS = 4  # positions whose flanks are shown


def draw_pressure(run):
    table = Table(run.path / "pressure.csv")
    order = np.argsort(table["position after the mean contact"], kind="stable")
    after = table["position after the mean contact"][order]
    plot, (left, right) = plt.subplots(1, 2, figsize=(10, 4))
    inside = table["largest pressure inside"][order]
    left.plot(after, np.where(inside > 0, inside, np.nan), "o-", color=COLOURS[0], label="inside the flank")
    left.plot(after, table["largest pressure"][order], ".--", color=COLOURS[1], label="with edges")
    left.set(xlabel="mesh cycles after the mean contact", ylabel="largest pressure [MPa]", ylim=(0, None))
    add_legend(left)
    right.plot(after, table["force"][order], "o-", color=COLOURS[0])
    right.set(xlabel="mesh cycles after the mean contact", ylabel="force of the tooth pair [N]", ylim=(0, None))
    return plot


def draw_pressure_field(run):
    table = Table(run.path / "pressure_field.csv")
    positions = np.unique(table["position"])
    positions = positions[np.linspace(0, len(positions) - 1, min(SHOWN_POSITIONS, len(positions))).astype(int)]
    # Edges in contact have by far the largest pressures, and would hide all others.
    most = np.quantile(table["pressure"], .98)
    plot, all_axes = plt.subplots(len(positions), 2, figsize=(10, 1 + 1.8 * len(positions)), squeeze=False,
                                  sharex="col", sharey="col")
    for row, position in zip(all_axes, positions):
        rows = table["position"] == position
        for axes, body in zip(row, ("pinion", "gear")):
            along = table["along the face, pinion" if body == "pinion" else "along the face, gear"][rows]
            up = table["along the profile, pinion" if body == "pinion" else "along the profile, gear"][rows]
            cells = axes.scatter(along, up, c=table["pressure"][rows], s=2, vmin=0, vmax=most, cmap="viridis")
            axes.set(title=f"{body}, position {position:.5g} mesh cycles", ylabel="profile [mm]")
    for axes in all_axes[-1]:
        axes.set_xlabel("face, from mid-face to the heel [mm]")
    plot.colorbar(cells, ax=list(all_axes.flat), label="pressure [MPa]", shrink=0.6, extend="max")
    return plot
