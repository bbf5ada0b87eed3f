# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantities of all variants of a sweep with their numerical errors."""
from textwrap import fill

import numpy as np

from .style import COLOURS, GREY, plt

PANELS_IN_A_ROW = 3
LETTERS_OF_A_TITLE = 38  # in a line


def draw_error_bars(study):
    """A panel a quantity, a line a variant; None where no quantity differs."""
    shown = [one for one in study.error_bars.quantities if not one.is_constant()]
    if not shown:
        return None
    names = shown[0].variants
    rows = -(-len(shown) // PANELS_IN_A_ROW)
    plot, grid = plt.subplots(rows, PANELS_IN_A_ROW, sharey=True, squeeze=False,
                              figsize=(11, 0.4 + rows * (1.1 + 0.22 * len(names))))
    places = np.arange(len(names))
    for axes, one in zip(grid.ravel(), shown):
        known = np.isfinite(one.errors)
        axes.errorbar(one.values[known], places[known], xerr=one.errors[known], fmt="o", markersize=4, capsize=3,
                      color=COLOURS[1], ecolor=GREY)
        axes.plot(one.values[~known], places[~known], "x", color=COLOURS[2])  # error not known
        title = one.name if one.unit in ("", "-") else f"{one.name} [{one.unit}]"
        axes.set_title(fill(title, LETTERS_OF_A_TITLE), fontsize=9)
        axes.locator_params(axis="x", nbins=4)
        axes.tick_params(labelsize=8)
    for axes in grid[:, 0]:
        axes.set_yticks(places, names)
    grid[0, 0].invert_yaxis()
    for axes in grid.ravel()[len(shown):]:
        axes.remove()
    return plot
