# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Campbell diagrams of a modal study, from campbell.csv and resonances.csv; whirl, from modes.csv."""
import numpy as np

from ..data.naming import GEAR, PINION
from ..data.table import Table, read_table
from .style import COLOURS, GREY, label_orders, plt

DASHES_OF_DIRECTION = {"standing": "-", "forward": "--", "backward": ":"}


def list_bodies(run):
    """Names of the bodies that have a diagram."""
    return sorted(set(Table(run.path / "campbell.csv")["body"]))


def draw_campbell(run, body):
    """One body: frequencies in the turning axes over its speed, a colour a nodal diameter."""
    branches, resonances = Table(run.path / "campbell.csv"), read_table(run.path / "resonances.csv")
    plot, axes = plt.subplots()
    mine = branches["body"] == body
    draw_branches(axes, branches, mine)
    top = 1.05e-3 * branches["frequency"][mine].max()
    if resonances is not None:
        # Bodies without teeth feel a force once a turn: their orders are those of the rotation.
        mark_resonances(axes, resonances, resonances["body"] == body, np.abs(branches["speed"][mine]).max(), top,
                        "mesh order" if body in ("pinion", "gear") else "order")
    operation = find_speed_of_operation(run, body)
    if operation:
        axes.axvline(operation, color=COLOURS[0], linestyle="--", linewidth=0.9, label=f"operating speed, {operation:.0f} rpm")
    axes.margins(x=0)
    axes.set(ylim=(0, top), xlabel=f"speed of the {body} [rpm]{tell_pinion(resonances, body)}", ylabel="frequency [kHz]")
    # Above the names of the orders that leave the axes there, and beside those at the side.
    axes.set_title(f"{body}: natural frequencies in the rotating frame", pad=16)
    axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1.14, 1.), frameon=False)
    return plot


def list_whirling_bodies(run):
    """Names of the bodies whose frequencies for an observer at rest are known at several speeds."""
    modes = Table(run.path / "modes.csv")
    if "fixed frequency" not in modes:
        return []
    known = np.isfinite(modes["fixed frequency"])
    return [body for body in sorted(set(modes["body"]))
            if len(set(modes["speed"][known & (modes["body"] == body)])) > 1]


def draw_whirl(run, body):
    """One body: its lowest frequencies for an observer at rest over its speed, and the frequency of the rotation."""
    modes = Table(run.path / "modes.csv")
    plot, axes = plt.subplots()
    mine = (modes["body"] == body) & np.isfinite(modes["fixed frequency"])
    for whirl, label, marker, colour in (("backward", "backward", "v", 1), ("forward", "forward", "^", 2), ("-", "no whirl", "o", 0)):
        rows = mine & (modes["whirl"] == whirl)
        axes.plot(modes["speed"][rows], modes["fixed frequency"][rows], marker, markersize=5, color=COLOURS[colour], label=label)
    end = np.abs(modes["speed"][mine]).max()
    axes.plot((0, end), (0, end / 60), color=GREY, linewidth=0.9, label="rotation")
    # Twice the rotation frequency, or the four lowest vibrations where they are above it.
    vibrations = np.sort(modes["fixed frequency"][mine & (np.abs(modes["speed"]) == end) & (modes["fixed frequency"] > 1.)])
    top = max([2 * end / 60, *(1.1 * vibrations[:4])])
    axes.set(ylim=(0, top), xlabel=f"speed of the {body} [rpm]", ylabel="frequency in the fixed frame [Hz]")
    axes.set_title(f"{body}: frequencies of whirl in the fixed frame")
    axes.legend(loc="upper left", bbox_to_anchor=(1.02, 1.), frameon=False)
    return plot


def tell_pinion(resonances, body):
    """The pinion speed over that of the gear, in words."""
    if body != "gear" or resonances is None or "pinion speed" not in resonances:
        return ""
    ratio = [pinion / abs(own) for own, pinion in zip(resonances["speed"], resonances["pinion speed"])
             if own and np.isfinite(pinion)]
    return f" (pinion speed: {ratio[0]:.4g} times this speed)" if ratio else ""


def draw_branches(axes, branches, mine):
    keys = sorted({(int(n), d, int(o)) for n, d, o in zip(
        branches["nodal diameter"][mine], branches["direction"][mine], branches["order"][mine])})
    named = set()
    for diameter, direction, order in keys:
        rows = mine & (branches["nodal diameter"] == diameter) & (
            branches["direction"] == direction) & (branches["order"] == order)
        speed, frequency = branches["speed"][rows], branches["frequency"][rows]
        label = None
        if (diameter, direction) not in named:
            named.add((diameter, direction))
            label = f"{diameter} diameter{'s' * (diameter != 1)}" if diameter >= 0 else "modes"
            label += "" if direction == "standing" else ", " + direction
        along = np.argsort(speed)
        axes.plot(speed[along], frequency[along] * 1e-3, DASHES_OF_DIRECTION[direction], marker=".",
                  markersize=3, color=COLOURS[diameter % len(COLOURS)], label=label)


def find_speed_of_operation(run, body):
    """Of a member of a gear pair [rpm], by the pinion's; None where it is not stated."""
    words = run.parameters.get("Operation/speed", "0").split()
    if body not in ("pinion", "gear") or words[1:] not in ([], ["rpm"]) or float(words[0]) == 0:
        return None
    teeth = [run.geometry.get(name, {}).get("number of teeth", {}).get("value")
             or float(run.parameters.get(path, "0").split()[0])
             for name, path in (("pinion", PINION + "Blank/number of teeth"), ("gear", GEAR + "Blank/number of teeth"))]
    if body == "pinion":
        return float(words[0])
    return float(words[0]) * teeth[0] / teeth[1] if all(teeth) else None


def mark_resonances(axes, resonances, mine, end, top, word):
    """Where a force that stands in space meets a branch, and the lines of its orders, named by `word`, up to the speed `end`
    and the frequency `top` [kHz]."""
    axes.plot(resonances["speed"][mine], resonances["frequency"][mine] * 1e-3, "o", markersize=5,
              markerfacecolor="none", color=GREY, label="resonance")
    # Resonances lie beside the line of their order: so many turns of the body as they have diameters.
    orders, wave = resonances["mesh order"][mine], resonances["wave"][mine]
    turns = resonances["nodal diameter"][mine] * ((wave == "backward") * 1. - (wave == "forward"))
    slopes = 1e-3 * (resonances["frequency"][mine] / np.abs(resonances["speed"][mine]) - turns / 60)
    label_orders(axes, [(order, np.median(slopes[orders == order])) for order in sorted(set(orders)) if order > 0], end, top,
                 word)
