# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of several runs of a study on shared axes."""
import numpy as np

from ..measures.lines import HIGHEST_LINE_ORDER
from ..measures.passages import find_passages, find_run_engagement
from ..measures.periodicity import compute_mesh_average
from ..measures.spectrum import compute_spectrum
from ..measures.waves import COMPONENTS, measure_waves
from .style import COLOURS, add_legend, plt

LAST_MESHES = 3
# Told apart without colour too.
DASHES = ["-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (1, 1)), (0, (8, 2))]


def look(variant):
    """A variant looks the same in all plots, also where another one is missing."""
    colour = variant.number % len(COLOURS)
    return {"color": COLOURS[colour],
            "linestyle": DASHES[(colour + variant.number // len(COLOURS)) % len(DASHES)]}


def draw_histories(study, column):
    """Means over a mesh cycle for the whole run; the last mesh cycles less the steady mean."""
    plot, (above, below) = plt.subplots(2, 1, figsize=(8, 7))
    for variant in study.pairs:
        run = variant.run
        meshes = run.history["time"] * run.value("mesh frequency")
        values = run.history[column]
        above.plot(meshes, compute_mesh_average(values, run.samples_per_mesh()), label=variant.name,
                   **look(variant))
        last = meshes >= meshes[-1] - LAST_MESHES - 1e-6
        mean = run.steady_values(column).mean()
        below.plot(meshes[last] - meshes[-1], values[last] - mean, label=variant.name,
                   **look(variant))
    label = study.pairs[0].run.history.label(column)
    above.set(title="Mean over a mesh cycle", xlabel="mesh cycles", ylabel=label)
    below.set(title=f"Last {LAST_MESHES} mesh cycles minus the mean of the steady part",
              ylabel=label, xlabel="mesh cycles before the end")
    for axes in (above, below):
        axes.margins(x=0)
    add_legend(above, fontsize=9)
    return plot


def draw_spectra(study, column):
    """One below the other on one scale."""
    variants = study.pairs
    plot, panels = plt.subplots(len(variants), 1, sharex=True, sharey=True, squeeze=False,
                                figsize=(8, 1.1 + 1.5 * len(variants)))
    top = 0
    for axes, variant in zip(panels[:, 0], variants):
        run = variant.run
        orders, amplitudes = compute_spectrum(run.steady_values(column), run.samples_per_mesh())
        visible = (orders > 0) & (orders <= HIGHEST_LINE_ORDER)
        axes.vlines(orders[visible], 0, amplitudes[visible], color=look(variant)["color"],
                    linewidth=2, label=variant.name)
        top = max(top, amplitudes[visible].max(initial=0))
        spacing = run.value("mesh frequency") * (orders[1] if len(orders) > 1 else np.nan)
        axes.set_title(f"{variant.name} (line spacing {spacing:.0f} Hz)", fontsize=9)
    panels[0, 0].set_ylim(0, 1.05 * top if top > 0 else 1)
    panels[-1, 0].set_xlabel("mesh order")
    panels[-1, 0].set_xlim(0, HIGHEST_LINE_ORDER + 0.2)
    plot.supylabel(f"amplitude [{variants[0].run.history.units[column]}]", fontsize=10)
    return plot


def draw_tooth_stress(study):
    """Hertzian pressure of one tooth pair during its engagement."""
    plot, axes = plt.subplots()
    for variant in study.pairs_with("teeth", "hertz pressure"):
        teeth, one = variant.run.teeth, find_run_engagement(variant.run)
        if one is None:
            continue
        at = (teeth["time"][one.rows] - teeth["time"][one.rows[0]]) * variant.run.value("mesh frequency")
        name = f"{variant.name}, teeth {one.pinion_tooth}/{one.gear_tooth}"
        name += "" if one.whole else " (part of the engagement)"
        axes.plot(at, teeth["hertz pressure"][one.rows], label=name, **look(variant))
    axes.set(title="Largest Hertzian pressure of one tooth pair",
             ylabel="contact pressure [MPa]", xlabel="mesh cycles since the first contact")
    axes.set_ylim(bottom=0)
    add_legend(axes, fontsize=8)
    return plot


def draw_probes(study):
    """A panel a probe, the passages' peaks on each other."""
    variants = study.pairs_with("probes")
    names = list(dict.fromkeys(name for v in variants for name in v.run.probes["probe"]))
    plot, panels = plt.subplots(len(names), 1, sharex=True, squeeze=False,
                                figsize=(8, 1 + 2.6 * len(names)))
    for variant in variants:
        probes, peaks = variant.run.probes, {name: record["at"]["value"] for name, record, _ in find_passages(variant.run)}
        for axes, name in zip(panels[:, 0], names):
            if name in peaks:
                rows = probes["probe"] == name
                axes.plot(1e3 * (probes["time"][rows] - peaks[name]),
                          probes["von mises"][rows], label=variant.name, **look(variant))
    for axes, name in zip(panels[:, 0], names):
        axes.set(title=name, ylabel="von Mises stress [MPa]")
        axes.set_ylim(bottom=0)
    add_legend(panels[0, 0], fontsize=9)
    panels[-1, 0].set_xlabel("time from the peak [ms]")
    return plot


def draw_rim_content(study):
    """Axial and radial waves: the part that is stationary in the fixed frame, and the remainder."""
    plot, panels = plt.subplots(2, 2, sharex=True, figsize=(9, 6.5))
    for variant in study.pairs_with("rim"):
        rim = variant.run.rim
        rows = variant.run.steady_rows(rim)
        both = measure_waves(rim, rows, variant.run.gear_turn(rim["time"][rows]))
        for column, values in enumerate(both):
            for row, component in enumerate(("z", "r")):
                at = list(COMPONENTS).index(component)
                panels[row, column].plot(values[at], marker="o", markersize=3, label=variant.name,
                                         **look(variant))
    for row, component in enumerate(("z", "r")):
        for column, what in enumerate(("stationary in the fixed frame", "remainder, rms")):
            panels[row, column].set(title=f"{COMPONENTS[component]}, {what}", yscale="log")
        panels[row, 0].set_ylabel("amplitude [um]")
    for axes in panels[1]:
        axes.set_xlabel("nodal diameters")
    add_legend(panels[0, -1], fontsize=9)
    return plot
