# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot of a loaded tooth contact analysis over one mesh cycle."""
from ..data.table import Table, write_persons
from .style import add_legend, plt

POSITION = "position [mesh cycles]"


def plot_columns(axes, table, names, label, scale=1.0):
    for name in names:
        axes.plot(table["position"], scale * table[name], ".-", label=write_persons(name))
    axes.set(xlabel=POSITION, ylabel=label)
    add_legend(axes)


def plot_deviations(axes, table, names):
    """Ripples of different means on one scale; the means are in the names."""
    for name in names:
        mean = table[name].mean()
        axes.plot(table["position"], table[name] - mean, ".-", label=f"{name}, mean {mean:.3g}")
    axes.set(xlabel=POSITION, ylabel="deviation from the mean [arcsec]")
    add_legend(axes)


def plot_shares(axes, table):
    for pair in sorted(set(zip(table["pinion tooth"], table["gear tooth"]))):
        own = (table["pinion tooth"] == pair[0]) & (table["gear tooth"] == pair[1])
        axes.plot(table["position"][own], table["share of torque"][own], ".-",
                  label=f"teeth {pair[0]:.0f}/{pair[1]:.0f}")
    axes.set(xlabel=POSITION, ylabel="share of torque")
    add_legend(axes)


def draw_loaded_contact(run):
    """Transmission error with and without load, load sharing, gear mesh stiffness, stresses."""
    table = Table(run.path / "loaded_contact.csv")
    plot, axes = plt.subplots(2, 2, figsize=(10, 7))
    plot_deviations(axes[0][0], table, ["unloaded transmission error", "transmission error"])
    plot_shares(axes[0][1], Table(run.path / "loaded_teeth.csv"))
    plot_columns(axes[1][0], table, ["secant stiffness", "tangent stiffness"], "gear mesh stiffness [MN m/rad]", 1e-6)
    stresses = [name for name in ("pinion fillet von mises", "gear fillet von mises",
                                  "web von mises") if name in table]
    plot_columns(axes[1][1], table, stresses, "largest von Mises stress [MPa]")
    return plot
