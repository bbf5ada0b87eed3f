# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of the contact of teeth: pattern on the flanks, load sharing, pressures."""
import numpy as np

from ..measures.passages import find_run_engagement, find_working_side
from ..measures.pressures import find_allowed_pressure
from .style import COLOURS, GREY, PRESSURE_MAP, plt


def plot_pattern(axes, run, body):
    """Largest nodal pressure on the working flank of one body over its largest, along and over its
    pitch cone, with the centre where the folder states it; what the shades are of."""
    pattern = run.pattern
    # The working side is the first one of the file.
    rows = (pattern["side"] == pattern["side"][0]) & (pattern["body"] == body)
    r, z, pressure = (pattern[name][rows] for name in ("r", "z", "largest pressure"))
    share = pressure / max(pressure.max(), 1e-6)
    size = run.geometry.get(body, {})
    pitch = size.get("pitch angle", {}).get("value")
    if pitch is None:  # of results without main dimensions
        along, upward, names = z, r, (pattern.label("z"), pattern.label("r"))
    else:
        sine, cosine = np.sin(np.radians(pitch)), np.cos(np.radians(pitch))
        along, upward = z * cosine + r * sine, r * cosine - z * sine
        names = "L [mm] (heel to the right)", "h [mm] (tip up)"
    shades = axes.tricontourf(along, upward, share, levels=np.linspace(0, 1, 21), cmap=PRESSURE_MAP)
    axes.plot(along, upward, ".", markersize=1.5, color=GREY)
    face, profile = (run.stated.get(f"pattern along the {name}, {body}", {}).get("value")
                     for name in ("face", "profile"))
    mean = size.get("mean cone distance", {}).get("value")
    if None not in (face, profile, mean, pitch):
        axes.plot(mean + face, profile, "+", markersize=12, markeredgewidth=2, color=COLOURS[1])
    axes.set_aspect("equal")
    axes.set_xlabel(names[0])
    axes.set_ylabel(names[1])
    return shades


def list_pattern_bodies(run):
    return list(dict.fromkeys(run.pattern["body"]))


def draw_contact_pattern(run):
    """Patterns of both bodies over one mesh cycle; nodes spread the contact over their facets, so that the
    size of a pressure is no stress."""
    bodies = list_pattern_bodies(run)
    plot, all_axes = plt.subplots(1, len(bodies), figsize=(10, 3), squeeze=False)
    for axes, body in zip(all_axes[0], bodies):
        shades = plot_pattern(axes, run, body)
        axes.set_title(body)
    plot.colorbar(shades, ax=list(all_axes[0]), label="nodal pressure over its largest value", ticks=np.linspace(0, 1, 6), shrink=0.7)
    return plot


def draw_contact_patterns(study):
    """Patterns of all variants below each other: how the contact moves over the flanks."""
    variants = study.patterns()
    bodies = list_pattern_bodies(variants[0].run)
    plot, all_axes = plt.subplots(len(variants), len(bodies), figsize=(10, 1 + 1.4 * len(variants)),
                                  squeeze=False, sharex="col", sharey="col")
    for row, variant in zip(all_axes, variants):
        for axes, body in zip(row, bodies):
            shades = plot_pattern(axes, variant.run, body)
            axes.set_title(f"{body}, {variant.name}")
            if variant is not variants[-1]:
                axes.set_xlabel("")
    plot.colorbar(shades, ax=all_axes.ravel().tolist(), label="nodal pressure over its largest value", ticks=np.linspace(0, 1, 6), shrink=0.5)
    return plot


def draw_load_sharing(run):
    """Share of the tooth pair that passes the mean contact during the record, and pressures."""
    teeth, frequency = run.teeth, run.value("mesh frequency")
    works = teeth["side"] == find_working_side(teeth)
    total = {}
    for time, force in zip(teeth["time"][works], teeth["force"][works]):
        total[time] = total.get(time, 0) + force
    plot, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(8, 6.5))
    # Tooth 0 is in mesh at the start and the next one is the last: their number is the largest plus
    # one.
    count = int(teeth["pinion tooth"].max()) + 1
    pairs = zip(teeth["pinion tooth"][works], teeth["gear tooth"][works])
    for number, (tooth, gear_tooth) in enumerate(dict.fromkeys(pairs)):
        rows = works & (teeth["pinion tooth"] == tooth) & (teeth["gear tooth"] == gear_tooth)
        # Teeth follow each other in the - sense of the numbers, one a mesh cycle, and come again.
        at = teeth["time"][rows] * frequency
        turns = np.round((at.mean() + tooth) / count)
        meshes = at - (turns * count - tooth)
        shares = [force / total[time]
                  for time, force in zip(teeth["time"][rows], teeth["force"][rows])]
        colour = COLOURS[number % len(COLOURS)]
        pair = f"teeth {tooth:.0f}/{gear_tooth:.0f}"
        above.plot(meshes, shares, ".", markersize=3, color=colour, label=pair)
        below.plot(meshes, teeth["hertz pressure"][rows], "-", linewidth=0.8, color=colour,
                   label=f"{pair}, Hertzian pressure")
    above.set_ylabel("share of the contact force")
    above.set_ylim(bottom=0)
    above.set_title("Share of each tooth pair, superposed by whole tooth pitches")
    below.set_ylabel("pressure [MPa]")
    below.set_title("Largest Hertzian pressure of each tooth pair")
    below.set_ylim(bottom=0)
    below.set_xlabel("mesh cycles")
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
    whole = "from first to last contact" if one.whole else "part of the engagement"
    above.set_title(f"Teeth {one.pinion_tooth}/{one.gear_tooth}, {whole}")
    below.plot(meshes, teeth["hertz pressure"][rows], color=COLOURS[1], label="Hertzian pressure")
    allowed = find_allowed_pressure(run)
    if allowed:
        below.axhline(allowed, color=GREY, linestyle=":", label="contact stress limit (input)")
        below.annotate("contact stress limit (input)", (0, allowed), xytext=(3, 3), textcoords="offset points", fontsize=8, color=GREY)
    below.set_title("Largest Hertzian pressure under this force, inside the flanks")
    below.set_ylabel("contact pressure [MPa]")
    below.set_xlabel("mesh cycles since the first contact")
    for axes in (above, below):
        axes.set_ylim(bottom=0)
    return plot
