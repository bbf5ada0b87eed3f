# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the section through the gear's axis and the contact: stress, deformation."""
import numpy as np
from matplotlib.collections import LineCollection

from ..plots.style import GREY, SIGNED_MAP, STRESS_MAP, plt
from .hexahedra import Section
from .scene import find_meridian
from .shading import add_colour_bar, add_section, find_scale


def draw_meridian_section(scene):
    """Web, rim and hub, and the pinion in mesh, with von Mises stress."""
    origin, normal, axis, radial = find_meridian(scene)
    apex_distance = origin @ axis
    section = Section(scene.fields.points, origin, normal)
    offset = section.corners - origin
    shown = np.stack([offset @ axis + apex_distance, offset @ radial], axis=-1)
    half = shown[..., 1].min(axis=1) > 0
    gear = scene.fields["body"][section.cells, 0] == scene.gear
    stress = section.interpolate(scene.fields["von mises"])
    largest, note = find_scale(stress[half & gear])
    picture, axes = plt.subplots(figsize=(8.6, 8), layout="compressed")
    add_section(axes, shown, stress, STRESS_MAP, 0, largest)
    of_gear = shown[half & gear]
    low, high = of_gear.min(axis=(0, 1)) - 12, of_gear.max(axis=(0, 1)) + 12
    axes.set_xlim(low[0] - 5, high[0])
    axes.set_ylim(low[1], high[1])
    axes.grid(False)
    axes.set_xlabel("along the gear's axis, from the apex [mm]")
    axes.set_ylabel("radius from the gear's axis [mm]")
    axes.set_title(f"Meridian section at the contact, {scene.when()}")
    add_colour_bar(picture, axes, STRESS_MAP, 0, largest, "von Mises stress [MPa]", note)
    return picture


def draw_deformation(scene):
    """The gear's meridian section opposite to the contact and at it, displacements magnified."""
    origin, normal, axis, radial = find_meridian(scene)
    gear = scene.fields.body(scene.gear)
    section = Section(gear.points - gear["displacement"], origin, normal)
    displacement = 1e3 * section.interpolate(gear["displacement"])  # um
    largest = np.abs(displacement @ axis).max()
    height = (section.corners - origin) @ radial
    size = np.abs(height).max()
    magnification = float(f"{60 * size / np.abs(displacement).max():.1g}")
    picture, panels = plt.subplots(1, 2, sharex=True, sharey=True, figsize=(11, 7),
                                  layout="compressed")
    for panel, side, place in zip(panels, (-1, 1), ("Opposite to the contact", "At the contact")):
        frame = np.stack([axis, side * radial], axis=1)
        half = side * height.min(axis=1) > 0
        start = (section.corners[half] - origin) @ frame + [origin @ axis, 0]
        now = start + 1e-3 * magnification * (displacement[half] @ frame)
        add_section(panel, now, displacement[half] @ axis, SIGNED_MAP, -largest, largest)
        panel.add_collection(LineCollection(find_outline(start), colors=GREY, linewidths=0.9))
        panel.margins(0.05)
        panel.autoscale_view()
        panel.grid(False)
        panel.set_title(place)
        panel.set_xlabel("along the gear's axis, from the apex [mm]")
    panels[0].set_ylabel("radius from the gear's axis [mm]")
    picture.suptitle(f"Displacements magnified {magnification:g} times (grey: undeformed), {scene.when()}")
    add_colour_bar(picture, panels, SIGNED_MAP, -largest, largest,
                   "axial displacement, positive to the back [um]")
    return picture


def find_outline(polygons):
    """Edges that belong to one polygon only, (n, 2, 2)."""
    edges = np.stack([polygons, np.roll(polygons, -1, axis=1)], axis=2).reshape(-1, 2, 2)
    edges = edges[np.abs(edges[:, 0] - edges[:, 1]).max(axis=1) > 1e-6]
    rounded = np.round(edges, 4)
    swapped = (rounded[:, 0, 0] > rounded[:, 1, 0]) | (
        (rounded[:, 0, 0] == rounded[:, 1, 0]) & (rounded[:, 0, 1] > rounded[:, 1, 1]))
    rounded[swapped] = rounded[swapped][:, ::-1]
    _, first, count = np.unique(rounded.reshape(-1, 4), axis=0, return_index=True,
                                return_counts=True)
    return edges[first[count == 1]]
