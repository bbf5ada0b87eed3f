# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""A run beside the static pair in the same positions of a mesh cycle."""
import numpy as np

from ..data.columns import TRANSMISSION_ERROR
from ..data.table import Table
from ..data.variants import list_below, list_compared
from .style import COLOURS, add_legend, plt

BINS = 50


def find_static_curve(study):
    """loaded_contact.csv of a comparison with more than one position; None."""
    if not study.folder.has_file("comparison.json"):
        return None
    for path in list_compared(study.path) or list_below(study.path):
        if not (path / "loaded_contact.csv").is_file():
            continue
        table = Table(path / "loaded_contact.csv")
        if table.n_rows > 1:
            return table
    return None


def has_static_curve(study):
    return bool(study.pairs) and find_static_curve(study) is not None


def compute_mean_mesh(run, column):
    """Position in the mesh cycle and mean of the column there over the steady part."""
    rows = run.steady_rows(run.history)
    position = run.history["time"][rows] * run.value("mesh frequency") % 1
    values = run.history[column][rows]
    place = np.minimum((position * BINS).astype(int), BINS - 1)
    count = np.bincount(place, minlength=BINS)
    means = np.bincount(place, values, minlength=BINS)[count > 0] / count[count > 0]
    return (np.flatnonzero(count > 0) + 0.5) / BINS, means


def draw_static_curve(study):
    """Transmission error over a mesh cycle: the run's mean mesh and the static curve."""
    table = find_static_curve(study)
    plot, axes = plt.subplots()
    axes.plot(table["position"] % 1, table["transmission error"], "o", color=COLOURS[0], label="static pair")
    for number, variant in enumerate(study.pairs):
        position, means = compute_mean_mesh(variant.run, TRANSMISSION_ERROR)
        axes.plot(position, means, color=COLOURS[1 + number % 6], label=f"{variant.name}, mean mesh cycle")
    axes.set(title="Transmission error over a mesh cycle (runs: mean mesh cycle of the steady part)", xlabel="position [mesh cycles]",
             ylabel="dte [arcsec]")
    add_legend(axes)
    return plot
