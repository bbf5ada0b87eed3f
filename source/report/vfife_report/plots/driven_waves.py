# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Travelling waves of the web: where mesh orders meet them, what was found there, how they grow."""
import numpy as np

from ..data.table import Table, read_table
from .style import COLOURS, GREY, add_legend, label_orders, plt

COLOURS_OF_SOLVER = {"reduced": COLOURS[1], "run": COLOURS[3], None: COLOURS[1]}
NAMES_OF_SOLVER = {"reduced": "reduced pair", "run": "run", None: "reduced pair"}
FULL, OPEN = {"markersize": 4}, {"markersize": 8, "fillstyle": "none"}  # one shows around the other where both agree
MARKS_OF_SOLVER = {"reduced": FULL, "run": OPEN, None: FULL}
DASHES_OF_WAVE = {"forward": "--", "backward": "-"}
LARGEST_BUBBLE = 900  # area of the marker of the largest amplitude [points^2]
PANELS_IN_ROW = 2
ON_CURVE = 5e-3  # of the frequency


def name_line(lines, row):
    """\"4 forward, mesh order 1\""""
    wave = str(lines["wave"][row])
    return f"{lines['nodal diameter'][row]:.0f}{'' if wave == '-' else ' ' + wave}, mesh order {lines['mesh order'][row]:.0f}"


def find_line(table, lines, row, solver=None):
    """Rows of another table that belong to a line, all or those of one solver."""
    found = np.ones(table.n_rows, dtype=bool)
    for column in ("wave", "nodal diameter", "order", "mesh order"):
        found &= table[column] == lines[column][row]
    return found if solver is None else found & (table["solver"] == solver)


def list_lines(lines):
    """The first row of each line: that of the solver that speeds to avoid are taken from."""
    return [row for row in range(lines.n_rows) if np.flatnonzero(find_line(lines, lines, row))[0] == row]


def list_solvers(lines, row):
    if "solver" not in lines:  # tables of versions that drove reduced pairs alone
        return [None]
    return [str(lines["solver"][other]) for other in np.flatnonzero(find_line(lines, lines, row))]


def draw_waves_met(run):
    """Frequencies of the waves as an observer at rest sees them, rays of the mesh orders, at their crossings in contact the
    amplitudes found, and all other vibrations that they meet there."""
    frequencies, lines = Table(run.path / "waves_frequencies.csv"), read_table(run.path / "waves_lines.csv")
    met = read_table(run.path / "waves_in_contact.csv")
    plot, axes = plt.subplots(figsize=(8, 6))
    draw_frequencies(axes, frequencies)
    end = frequencies["speed"].max()
    # Tables of earlier versions have no frequency of what is met in contact.
    met = met if met is not None and met.n_rows and "mesh frequency" in met else None
    table, speed = (met, "speed") if met is not None else (lines, "speed in contact")
    heights = frequencies["fixed frequency"]
    if table is not None and table.n_rows:
        heights = np.append(heights, table["mesh order"] * table["mesh frequency"])
    top = 1.05e-3 * heights.max()
    if table is not None and table.n_rows:
        slope = np.median(table["mesh frequency"] / table[speed])
        label_orders(axes, [(order, 1e-3 * order * slope) for order in np.unique(table["mesh order"])], end, top)
    if lines is not None and lines.n_rows:
        draw_bubbles(axes, lines, frequencies)
    if met is not None:
        draw_meetings(axes, met)
    axes.set(xlim=(0, end), ylim=(0, top), xlabel="pinion speed [rpm]", ylabel="frequency [kHz]")
    axes.set_title("Waves and mesh orders in the fixed frame", pad=16)
    axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1.13, 1.), frameon=False)
    return plot


def draw_meetings(axes, met):
    """Resonances in contact, those of the torsional mode with another mark."""
    height = 1e-3 * met["mesh order"] * met["mesh frequency"]
    swing = met["share of the rotation"] > met["share of the wave"]
    for rows, mark, size, name in ((~swing, ".", 12, "resonance in contact"), (swing, "*", 90, "torsional mode in contact")):
        if np.any(rows):
            axes.scatter(met["speed"][rows], height[rows], s=size, marker=mark, color=COLOURS[0], label=name, zorder=3)


def draw_frequencies(axes, frequencies):
    """Thin: of the gear by itself; thick: in contact, of the waves that an order meets."""
    in_contact = "fixed frequency in contact" in frequencies
    keys = sorted({(int(n), d, int(o)) for n, d, o in zip(
        frequencies["nodal diameter"], frequencies["wave"], frequencies["order"])})
    for diameter, wave, order in keys:
        rows = (frequencies["nodal diameter"] == diameter) & (frequencies["wave"] == wave) & (
            frequencies["order"] == order)
        style = {"color": COLOURS[diameter % len(COLOURS)], "linestyle": DASHES_OF_WAVE.get(wave, "-.")}
        name = f"n = {diameter}" + (f", {wave}" if wave in DASHES_OF_WAVE else "")
        axes.plot(frequencies["speed"][rows], 1e-3 * frequencies["fixed frequency"][rows], linewidth=0.6 if in_contact else 1.5,
                  label=name if order == 1 else None, **style)
        if in_contact and np.any(np.isfinite(frequencies["fixed frequency in contact"][rows])):
            axes.plot(frequencies["speed"][rows], 1e-3 * frequencies["fixed frequency in contact"][rows], linewidth=1.5,
                      gid=f"{name}, order {order}, in contact", **style)


def lies_on_curve(frequencies, lines, row):
    """Whether a line lies on the curve of its wave in contact. A wave that is parted between two vibrations has one curve, and
    orders may meet most of it at the other vibration."""
    if "fixed frequency in contact" not in frequencies:
        return True
    mine = np.isfinite(frequencies["fixed frequency in contact"])
    for column in ("wave", "nodal diameter", "order"):
        mine &= frequencies[column] == lines[column][row]
    if not np.any(mine):
        return False
    along = np.argsort(frequencies["speed"][mine])
    curve = np.interp(lines["speed in contact"][row], frequencies["speed"][mine][along],
                      frequencies["fixed frequency in contact"][mine][along])
    return abs(lines["mesh order"][row] * lines["mesh frequency"][row] / curve - 1) < ON_CURVE


def draw_bubbles(axes, lines, frequencies):
    """Areas in proportion to the amplitudes measured, rings at the crossings of waves that were predicted only."""
    shown = [row for row in list_lines(lines)
             if np.isfinite(lines["amplitude"][row]) or lies_on_curve(frequencies, lines, row)]
    if not shown:
        return
    amplitude = lines["amplitude"][shown]
    measured = np.isfinite(amplitude)
    contact = lines["speed in contact"][shown]
    speed = np.where(measured, lines["peak speed"][shown], contact)
    height = 1e-3 * lines["mesh order"][shown] * lines["mesh frequency"][shown] * speed / contact
    colours = np.array([COLOURS[int(n) % len(COLOURS)] for n in lines["nodal diameter"][shown]])
    if not np.all(measured):
        axes.scatter(speed[~measured], height[~measured], s=30, facecolors="none", edgecolors=colours[~measured])
    if not np.any(measured):
        return
    axes.scatter(speed[measured], height[measured], s=LARGEST_BUBBLE * amplitude[measured] / amplitude[measured].max(),
                 c=colours[measured], alpha=0.45, linewidths=0)
    for row in np.flatnonzero(measured):
        # Beside the disc and the line of the order, which rises through it.
        axes.annotate(f"{amplitude[row]:.2g} um", (speed[row], height[row]), xytext=(14, -4),
                      textcoords="offset points", fontsize=7, ha="left", va="top")


def make_panels(n):
    columns = min(n, PANELS_IN_ROW)
    rows = -(-n // columns)
    plot, panels = plt.subplots(rows, columns, squeeze=False, figsize=(8, 1 + 2.1 * rows))
    for axes in panels.flat[n:]:
        axes.set_visible(False)
    return plot, panels.flat


def finish_panel(axes, lines, row):
    axes.set_title(name_line(lines, row), fontsize=8)
    axes.set_ylim(0, 1.06 * axes.get_ylim()[1])
    axes.set_ylabel("amplitude [um]", fontsize=8)


def draw_driven_waves(run):
    """A panel a line: amplitudes over the speed, measured and by linear theory."""
    lines, waves = Table(run.path / "waves_lines.csv"), Table(run.path / "waves_response.csv")
    shown = list_lines(lines)
    plot, panels = make_panels(len(shown))
    for row, axes in zip(shown, panels):
        for place, solver in enumerate(list_solvers(lines, row)):
            mine = find_line(waves, lines, row, solver)
            if place == 0:
                axes.plot(waves["speed"][mine], waves["linear amplitude"][mine], "x--", color=COLOURS[2], markersize=4,
                          label="linear theory")
            axes.plot(waves["speed"][mine], waves["amplitude"][mine], "o", color=COLOURS_OF_SOLVER[solver],
                      label=NAMES_OF_SOLVER[solver], **MARKS_OF_SOLVER[solver])
            axes.plot(waves["speed"][mine], waves["fitted amplitude"][mine], "+", color=COLOURS[0], markersize=6,
                      label="resonance curve" if place == 0 else None)
        axes.axvline(lines["speed"][row], color=GREY, linewidth=0.7)
        finish_panel(axes, lines, row)
    add_legend(panels[0], fontsize=7)
    plot.supxlabel("pinion speed [rpm]", fontsize=9)
    return plot


def draw_growth(run):
    """A panel a line: means over mesh cycles at the speed of the line."""
    lines, growth = Table(run.path / "waves_lines.csv"), Table(run.path / "waves_build_up.csv")
    shown = list_lines(lines)
    plot, panels = make_panels(len(shown))
    for row, axes in zip(shown, panels):
        for place, solver in enumerate(list_solvers(lines, row)):
            mine = find_line(growth, lines, row, solver)
            axes.plot(1e3 * growth["time"][mine], growth["amplitude"][mine], "o", color=COLOURS_OF_SOLVER[solver],
                      label=NAMES_OF_SOLVER[solver], **MARKS_OF_SOLVER[solver])
            axes.plot(1e3 * growth["time"][mine], growth["fitted amplitude"][mine], color=COLOURS[0], linewidth=0.8,
                      label="fit" if place == 0 else None)
        finish_panel(axes, lines, row)
    add_legend(panels[0], fontsize=7)
    plot.supxlabel("time [ms]", fontsize=9)
    return plot
