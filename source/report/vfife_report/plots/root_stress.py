# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of root stresses: over an engagement, along the face, on the unrolled fillets, and of strain gauges."""
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from ..data.table import Table
from .style import COLOURS, SIGNED_MAP, add_legend, plt

AFTER = "position after the mean contact"
SHOWN = 4  # mesh cycles on either side of the mean contact


def list_fillets(table):
    """Body and side of the fillets, in the table's order."""
    return list(dict.fromkeys(zip(table["body"], table["fillet"])))


def rows_of(table, body, fillet):
    return (table["body"] == body) & (table["fillet"] == fillet)


def list_root_stresses(envelope):
    """Of each fillet the largest stresses, and the largest range with the place of its facet."""
    for body, fillet in list_fillets(envelope):
        rows = np.flatnonzero(rows_of(envelope, body, fillet))
        largest = rows[np.argmax(envelope["range"][rows])]
        yield [str(body), str(fillet), float(envelope["tension"][rows].max()), float(envelope["compression"][rows].min()),
               float(envelope["range"][largest]),
               float(envelope["face from"][largest] + envelope["face to"][largest]) / 2,
               float(envelope["profile from"][largest] + envelope["profile to"][largest]) / 2]


def extremes(table, rows):
    """Largest tension and compression by the position after the mean contact (positions that differ by round-off are one)."""
    places = np.round(table[AFTER][rows], 6)
    at = np.unique(places)
    tension = [table["tension"][rows][places == place].max() for place in at]
    compression = [table["compression"][rows][places == place].min() for place in at]
    return at, np.array(tension), np.array(compression)


def plot_members(table, label):
    """A plot with axes for each member, their x axis with a label, and (axes, colour, body, fillet) of each tooth fillet. Fillets
    at the hub have no engagement."""
    fillets = [(body, fillet) for body, fillet in list_fillets(table) if not fillet.startswith("hub ")]
    bodies = list(dict.fromkeys(body for body, _ in fillets))
    plot, all_axes = plt.subplots(1, len(bodies), figsize=(10, 4), squeeze=False, sharey=True)
    curves = []
    for axes, body in zip(all_axes[0], bodies):
        axes.set(title=body, xlabel=label, ylabel="principal stress [MPa]")
        curves += [(axes, colour, *one) for colour, one in zip(COLOURS[1:], [one for one in fillets if one[0] == body])]
    return plot, curves


def draw_root_stress(run):
    table = Table(run.path / "root_stress.csv")
    plot, curves = plot_members(table, "mesh cycles after the mean contact")
    for axes, colour, body, fillet in curves:
        at, tension, compression = extremes(table, rows_of(table, body, fillet))
        near = np.abs(at) <= SHOWN
        axes.plot(at[near], tension[near], color=colour, label=f"{fillet} fillet, tension")
        axes.plot(at[near], compression[near], "--", color=colour, label=f"{fillet} fillet, compression")
    add_legend(plot.axes[-1], fontsize=8)  # the same of all members
    return plot


def draw_envelope(run):
    table = Table(run.path / "fillet_envelope.csv")
    fillets = list_fillets(table)
    size = max(table["tension"].max(), -table["compression"].min(), 1e-9)
    plot, all_axes = plt.subplots(len(fillets), 2, figsize=(10, 1.3 + 1.4 * len(fillets)), squeeze=False)
    for pair, (body, fillet) in zip(all_axes, fillets):
        rows = rows_of(table, body, fillet)
        left, right, low, high = (table[name][rows] for name in ("face from", "face to", "profile from", "profile to"))
        facets = np.stack([np.stack([left, low], -1), np.stack([right, low], -1),
                           np.stack([right, high], -1), np.stack([left, high], -1)], 1)
        for axes, stress in zip(pair, ("tension", "compression")):
            shades = PolyCollection(facets, array=table[stress][rows], cmap=SIGNED_MAP, norm=Normalize(-size, size),
                                    edgecolor="face")
            axes.add_collection(shades)
            axes.autoscale_view()
            extreme = table[stress][rows].max() if stress == "tension" else table[stress][rows].min()
            axes.set(title=f"{body}, {fillet} fillet: {stress}, {extreme:.0f} MPa", ylabel="profile [mm]")
            axes.grid(False)
    for axes in all_axes[-1]:
        axes.set_xlabel("face, from the toe [mm]")
    plot.colorbar(shades, ax=list(all_axes.flat), label="principal stress [MPa]", shrink=0.6)
    return plot


def draw_sections(run):
    """Steps, since a section is as long as its facets."""
    table = Table(run.path / "root_sections.csv")
    plot, curves = plot_members(table, "face, from the toe [mm]")
    for axes, colour, body, fillet in curves:
        rows = rows_of(table, body, fillet)
        sides = np.append(table["face from"][rows], table["face to"][rows][-1])
        for stress, line in (("tension", "-"), ("compression", "--")):
            axes.stairs(table[stress][rows], sides, baseline=None, color=colour, linestyle=line,
                        label=f"{fillet} fillet, {stress}")
    add_legend(plot.axes[-1], fontsize=8)
    return plot


def draw_gauges(run):
    """Over time, or, where copies on all teeth are known, over the passage through a turn."""
    table = Table(run.path / "gauges.csv")
    over_time = "time" in table
    plot, axes = plt.subplots(figsize=(8, 4))
    for name in dict.fromkeys(table["gauge"]):
        rows = table["gauge"] == name
        x = 1e3 * table["time"][rows] if over_time else table[AFTER][rows]
        order = np.argsort(x, kind="stable")
        near = slice(None) if over_time else np.abs(x[order]) <= SHOWN
        axes.plot(x[order][near], table["strain"][rows][order][near], label=name)
    axes.set(xlabel="time [ms]" if over_time else "mesh cycles after the mean contact", ylabel=table.label("strain"))
    add_legend(axes)
    return plot
