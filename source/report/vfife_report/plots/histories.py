# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots over time: transmission error, forces of the teeth, energies, probes."""
import numpy as np
from matplotlib.patheffects import withStroke

from ..data.columns import CONTACT_FORCE
from ..data.labels import ENERGY_CURVES
from ..measures.passages import find_working_side
from ..measures.periodicity import compute_mesh_average
from .style import COLOURS, GREY, PALE, add_legend, label_ends, plt


NAMED_PAIRS = 24  # more of them have no room for their names


def find_times(run):
    """Abscissa of a history and its label: an equilibrium has parts of the loads in place of times."""
    return (run.history["time"], "part of the loads") if run.is_equilibrium() else (1e3 * run.history["time"], "time [ms]")


def mark_steady_part(run, axes):
    """To be called when the curves are drawn: the words are in a strip above all of them."""
    part = run.steady_part()
    if part:
        low, high = axes.get_ylim()
        axes.set_ylim(low, high + 0.08 * (high - low))
        start, end, found = part
        axes.axvspan(1e3 * start, 1e3 * end, color=PALE, zorder=0)
        text = "last third (not steady)" if not found else (
            "means steady, ripple still transient" if run.is_ripple_steady() is False else "steady part")
        axes.annotate(text, (1e3 * start, 1),
                      xycoords=("data", "axes fraction"), xytext=(3, -10),
                      textcoords="offset points", fontsize=8, color=GREY)


def finish_time_axis(run, axes):
    """Time below, mesh cycles above."""
    axes.set_xlabel("time [ms]")
    axes.margins(x=0)
    frequency = run.value("mesh frequency")
    if frequency:
        above = axes.secondary_xaxis("top", functions=(lambda t: t * frequency * 1e-3,
                                                       lambda n: n / frequency * 1e3))
        above.set_xlabel("mesh cycles", fontsize=8, color=GREY)
        above.tick_params(labelsize=8, colors=GREY)


def draw_transmission_error(run):
    history, samples = run.history, run.samples_per_mesh()
    time = 1e3 * history["time"]
    plot, (axes, below) = plt.subplots(2, 1, sharex=True, figsize=(8, 7))
    curves = (("dte", "hub", COLOURS[1]), ("rim dte", "rim", COLOURS[2]))
    for name, text, colour in curves:
        axes.plot(time, history[name], color=colour, linewidth=0.7, alpha=0.55, label=text)
        if samples:
            axes.plot(time, compute_mesh_average(history[name], samples), color=colour, linewidth=2,
                      label=f"{text}, mean over a mesh cycle")
        # Hub and rim are so far apart that their ripples would be lines.
        below.plot(time, history[name] - run.steady_values(name).mean(), color=colour, linewidth=0.8,
                   label=f"{text} minus its mean")
    axes.set_ylabel(history.label("dte"))
    axes.set_title("Dynamic transmission error (thin), and its mean over a mesh cycle (thick)")
    mark_steady_part(run, axes)
    finish_time_axis(run, axes)
    axes.set_xlabel("")
    label_ends(axes, [(time[-1], history[name][-1], text, colour)
                            for name, text, colour in curves])
    below.set(title="Ripple: dynamic transmission error minus its mean over the marked part", ylabel="[arcsec]", xlabel="time [ms]")
    below.margins(x=0)
    add_legend(below, fontsize=8, ncol=2)
    return plot


def draw_contact_force(run):
    """Sum of all tooth pairs and each pair; the side that does not transmit the torque dashed."""
    history, teeth = run.history, run.teeth
    time = 1e3 * history["time"]
    plot, axes = plt.subplots()
    axes.plot(time, history[CONTACT_FORCE], color=COLOURS[0], label="total")
    title = "Contact force"
    if teeth is not None and "pinion tooth" in teeth:
        named = draw_tooth_pairs(axes, history, teeth)
        title += " of all and of single tooth pairs" + " (pinion tooth/gear tooth)" * named
    axes.set_ylabel("contact force [N]")
    axes.set_ylim(bottom=0)
    mark_steady_part(run, axes)
    axes.set_title(title)
    finish_time_axis(run, axes)
    label_ends(axes, [(time[-1], history[CONTACT_FORCE][-1], "total", COLOURS[0])])
    return plot


def draw_tooth_pairs(axes, history, teeth):
    """Whether they are named: where there are few enough."""
    working = find_working_side(teeth)
    pairs = dict.fromkeys(zip(teeth["side"], teeth["pinion tooth"], teeth["gear tooth"]))
    for number, (side, pinion, gear) in enumerate(pairs):
        rows = (teeth["side"] == side) & (teeth["pinion tooth"] == pinion)
        rows &= teeth["gear tooth"] == gear
        colour = COLOURS[1 + number % (len(COLOURS) - 1)]
        # Samples at which the pair does not touch have no rows: their force is zero.
        force = np.zeros(history.n_rows)
        at = np.clip(np.searchsorted(history["time"], teeth["time"][rows] * (1 - 1e-9)), 0,
                     history.n_rows - 1)
        force[at] = teeth["force"][rows]
        around = np.convolve(force > 0, np.ones(3), mode="same") > 0
        axes.plot(1e3 * history["time"], np.where(around, force, np.nan), color=colour,
                  linestyle="-" if side == working else "--",
                  label=f"teeth {pinion:.0f}/{gear:.0f}, {side}")
        if len(pairs) > NAMED_PAIRS:
            continue
        top = np.argmax(force)
        axes.annotate(f"{pinion:.0f}/{gear:.0f}", (1e3 * history["time"][top], force[top]),
                      xytext=(0, -11), textcoords="offset points", color=colour, ha="center", fontsize=8,
                      path_effects=[withStroke(linewidth=2, foreground="white")])
    return len(pairs) <= NAMED_PAIRS


def list_model_probes(run):
    """Names of the probes whose displacement the history has."""
    return [name.removesuffix(" displacement x") for name in run.history.columns if name.endswith(" displacement x")]


def draw_model_probes(run):
    """Displacements of each probe of a model without a gear pair, and von Mises stresses below."""
    history, probes = run.history, list_model_probes(run)
    time, label = find_times(run)
    plot, panels = plt.subplots(len(probes) + 1, 1, sharex=True, squeeze=False, figsize=(8, 1 + 2.2 * (len(probes) + 1)))
    for number, (name, axes) in enumerate(zip(probes, panels[:, 0])):
        for axis, colour in zip("xyz", COLOURS[1:]):
            axes.plot(time, history[f"{name} displacement {axis}"], color=colour, label=axis)
        axes.set(title=name, ylabel=f"displacement [{history.units[f'{name} displacement x']}]")
        if number == 0:
            add_legend(axes, fontsize=9)
    below = panels[-1, 0]
    for name, colour in zip(probes, np.resize(COLOURS, len(probes))):
        below.plot(time, history[f"{name} von mises"], color=colour, label=name)
    below.set(title="von Mises stress at the probes", ylabel="[MPa]", xlabel=label, ylim=(0, None))
    below.margins(x=0)
    add_legend(below, fontsize=9)
    return plot


def draw_energies(run):
    history = run.history
    time, label = find_times(run)
    plot, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(8, 6.5))
    above.plot(time, 100 * history["energy error"], color=COLOURS[0])
    mark_steady_part(run, above)
    above.set_ylabel("energy error [%]")
    above.set_title("Residual of the energy balance over the largest energy exchanged so far")
    shown = ("strain energy", "contact energy", "relative kinetic energy", "damping loss",
             "removed by the driven speed damping", "driven speed damping loss", "contact loss")
    for number, name in enumerate(n for n in shown if n in history and np.any(history[n])):
        change = history[name] - history[name][0]
        below.plot(time, change, color=COLOURS[number % len(COLOURS)],
                   label=ENERGY_CURVES.get(name, name))
    add_legend(below, fontsize=9)
    below.set_ylabel("change since the start [mJ]")
    below.set_title("Changes of the energies")
    below.set_xlabel(label)
    below.margins(x=0)
    return plot


def draw_probes(run):
    probes = run.probes
    plot, axes = plt.subplots()
    curves = []
    for number, name in enumerate(dict.fromkeys(probes["probe"])):
        rows = probes["probe"] == name
        colour = COLOURS[1 + number % (len(COLOURS) - 1)]
        time = 1e3 * probes["time"][rows]
        axes.plot(time, probes["von mises"][rows], color=colour, label=name)
        curves.append((time[-1], probes["von mises"][rows][-1], name, colour))
    axes.set_ylabel(probes.label("von mises"))
    axes.set_ylim(bottom=0)
    axes.set_title("Von Mises stress at the probes (averaged at nodes)")
    finish_time_axis(run, axes)
    label_ends(axes, curves)
    return plot
