# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of the contact of teeth: pattern on the flanks, load sharing, pressures."""
import numpy as np

from ..measures.passages import LEAST_FORCE_IN_WORDS, find_run_engagement, is_loaded
from .style import COLOURS, GREY, PRESSURE_MAP, add_legend, plt


def draw_contact_pattern(run):
    """Largest nodal pressure on the flanks of the drive side in the last tooth mesh, in the axial
    section of each body."""
    pattern = run.pattern
    bodies = list(dict.fromkeys(pattern["body"]))
    plot, all_axes = plt.subplots(1, len(bodies), figsize=(10, 4.5), squeeze=False)
    drive = pattern["side"] == "drive"
    top = max(pattern["largest pressure"][drive].max(), 1)
    for axes, body in zip(all_axes[0], bodies):
        rows = drive & (pattern["body"] == body)
        r, z, pressure = (pattern[name][rows] for name in ("r", "z", "largest pressure"))
        shades = axes.tricontourf(z, r, pressure, levels=np.linspace(0, top, 25), cmap=PRESSURE_MAP)
        axes.plot(z, r, ".", markersize=1.5, color=GREY)
        axes.set_aspect("equal")
        axes.set_title(f"{body}: largest {pressure.max():.0f} MPa")
        axes.set_xlabel(pattern.label("z"))
        axes.set_ylabel(pattern.label("r"))
    plot.colorbar(shades, ax=list(all_axes[0]), label="largest nodal pressure [MPa]")
    return plot


def draw_load_sharing(run):
    """Share of the tooth pair that passes the mean contact during the record, and pressures."""
    teeth, frequency = run.teeth, run.value("mesh frequency")
    drive = teeth["side"] == "drive"
    total = {}
    for time, force in zip(teeth["time"][drive], teeth["force"][drive]):
        total[time] = total.get(time, 0) + force
    plot, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(8, 6.5))
    # Tooth 0 is in mesh at the start and the next one is the last: their number is the largest plus
    # one.
    count = int(teeth["pinion tooth"].max()) + 1
    pairs = zip(teeth["pinion tooth"][drive], teeth["gear tooth"][drive])
    for number, (tooth, gear_tooth) in enumerate(dict.fromkeys(pairs)):
        rows = drive & (teeth["pinion tooth"] == tooth) & (teeth["gear tooth"] == gear_tooth)
        # Teeth follow each other in the - sense of the numbers, one a tooth mesh, and come again.
        at = teeth["time"][rows] * frequency
        turns = np.round((at.mean() + tooth) / count)
        meshes = at - (turns * count - tooth)
        shares = [force / total[time]
                  for time, force in zip(teeth["time"][rows], teeth["force"][rows])]
        colour = COLOURS[number % len(COLOURS)]
        pair = f"teeth {tooth:.0f}/{gear_tooth:.0f}"
        above.plot(meshes, shares, ".", markersize=3, color=colour, label=pair)
        below.plot(meshes, teeth["mean pressure"][rows], ".", markersize=3, color=colour,
                   label=f"{pair}, mean pressure")
        if "hertz pressure" in teeth:
            below.plot(meshes, teeth["hertz pressure"][rows], "-", linewidth=0.8, color=colour,
                       label=f"{pair}, hertz pressure")
    above.set_ylabel("share of the contact force")
    above.set_ylim(bottom=0)
    above.set_title("Share of each tooth pair, all moved to the position of the first")
    below.set_ylabel("pressure [MPa]")
    below.set_title("Mean pressure, force over area (dots); largest of Hertz's ellipse (lines)")
    below.set_xlabel("tooth meshes")
    limit_to_most(below)
    return plot


def draw_tooth_engagement(run):
    """Force and pressures of one tooth pair from its first to its last touch."""
    one = find_run_engagement(run)
    if one is None:
        return None
    teeth, rows = run.teeth, one.rows
    meshes = (teeth["time"][rows] - teeth["time"][rows[0]]) * run.value("mesh frequency")
    plot, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(8, 6))
    above.plot(meshes, teeth["force"][rows], color=COLOURS[0], label="force")
    above.set_ylabel(teeth.label("force"))
    whole = "first to last touch" if one.whole else "only in part within the record"
    above.set_title(f"Teeth {one.pinion_tooth}/{one.gear_tooth}, {whole}")
    shown = (("hertz pressure", "largest of Hertz's ellipse under this force", "-"),
             ("mean pressure", "mean, force over area", "--"),
             ("largest pressure", "largest of a contact point", ":"))
    for number, (name, text, dashes) in enumerate(shown):
        if name in teeth:
            values = np.where(is_loaded(teeth, rows), teeth[name][rows], np.nan)
            below.plot(meshes, values, dashes, color=COLOURS[1 + number], label=text)
    below.set_title(f"Contact stress, under {LEAST_FORCE_IN_WORDS} of the largest force and more")
    below.set_ylabel("contact stress [MPa]")
    below.set_xlabel("tooth meshes since the first touch")
    add_legend(below, fontsize=9)
    for axes in (above, below):
        axes.set_ylim(bottom=0)
    return plot


def limit_to_most(axes):
    """Single points that barely touch must not set the scale."""
    values = np.concatenate([line.get_ydata() for line in axes.get_lines()])
    axes.set_ylim(0, 1.2 * np.percentile(values, 98))
