# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Responses over speed of all variants on shared axes, and stresses over speed of one folder."""
import numpy as np

from ..measures.speed_peaks import find_response, list_places
from .comparisons import look
from .speed_response import DIRECTIONS, RESPONSES
from .style import GREY, add_legend, plt


def select(table, column, direction, place=None):
    """Speeds and values of one direction, of one place where the table has places."""
    rows = table["direction"] == direction
    if place is not None:
        rows &= table["place"] == place
    return table["speed"][rows], table[column][rows]


def draw_speed_curves(study):
    """A panel each for transmission error, force and the largest stress at each place; a curve a variant, rising speed,
    with a mark where it is largest."""
    variants = study.responses
    places = list_places(variants)
    plot, panels = plt.subplots(len(RESPONSES) + len(places), 1, sharex=True, squeeze=False,
                                figsize=(8, 1 + 2.2 * (len(RESPONSES) + len(places))))
    panels = panels[:, 0]
    for axes, (column, label) in zip(panels, RESPONSES):
        for variant in variants:
            draw_curve(axes, variant, *select(find_response(variant.run), column, "up"))
        axes.set(ylabel=label)
    panels[0].set_ylim(bottom=0)
    for axes, place in zip(panels[len(RESPONSES):], places):
        for variant in variants:
            stress = find_response(variant.run, "stress_response.csv")
            if stress is not None and place in stress["place"]:
                draw_curve(axes, variant, *select(stress, "largest stress", "up", place))
        axes.set(ylabel=f"{place} [MPa]")
        axes.set_ylim(bottom=0)
    for axes in panels:
        axes.margins(x=0.01)
    add_legend(panels[0], fontsize=8)
    panels[0].set_title("Values over the recorded mesh cycles at each speed")
    panels[-1].set_xlabel("pinion speed [rpm]")
    return plot


def draw_curve(axes, variant, speeds, values):
    axes.plot(speeds, values, label=variant.name, gid=variant.name, **look(variant))
    top = int(np.nanargmax(values))
    axes.plot(speeds[top], values[top], "o", color=look(variant)["color"], markersize=5, clip_on=False)


def draw_stress_response(run):
    """Largest stress at each place, and what it would be without vibration."""
    stress = find_response(run, "stress_response.csv")
    places = list(dict.fromkeys(stress["place"]))
    plot, panels = plt.subplots(len(places), 1, sharex=True, squeeze=False, figsize=(8, 1 + 2.2 * len(places)))
    for axes, place in zip(panels[:, 0], places):
        speeds, values = select(stress, "stress without vibration", "up", place)
        axes.plot(speeds, values, color=GREY, label="without vibration")
        for direction, marker, colour in DIRECTIONS:
            speeds, values = select(stress, "largest stress", direction, place)
            if len(speeds):
                axes.plot(speeds, values, marker=marker, markersize=3, color=colour, label=f"speed {direction}")
        axes.set(ylabel=f"{place} [MPa]")
        axes.set_ylim(bottom=0)
        axes.margins(x=0.01)
    add_legend(panels[0, 0], fontsize=8)
    panels[0, 0].set_title("Largest stress of all sectors at each speed")
    panels[-1, 0].set_xlabel("pinion speed [rpm]")
    return plot
