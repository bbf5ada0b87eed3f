# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of the teeth in mesh: section across them, pressure on the gear's."""
import numpy as np

from ..plots.style import PRESSURE_MAP, STRESS_MAP, WIDE, plt
from .canvas import Camera
from .hexahedra import FACES, Section, find_outer_faces
from .shading import add_colour_bar, add_section, draw_faces, find_scale, show_image


@plt.rc_context(WIDE)
def draw_teeth_in_mesh(scene):
    """Section across the teeth at the contact with von Mises stress; pressure on the gear's teeth."""
    fields, contact = scene.fields, scene.contact
    picture, (left, right) = plt.subplots(1, 2, figsize=(14, 5.6), layout="compressed")
    # Across the teeth: normal to the cone distance, the gear's outside upwards.
    along = contact / np.linalg.norm(contact)
    up = contact - (contact @ scene.gear_axis) * scene.gear_axis
    up = up - (up @ along) * along
    up /= np.linalg.norm(up)
    sideways = np.cross(up, along)
    near = fields.take(np.linalg.norm(fields.points.mean(axis=1) - contact, axis=1) < 40)
    section = Section(near.points, contact, along)
    offset = section.corners - contact
    shown = np.stack([offset @ sideways, offset @ up], axis=-1)
    stress = section.interpolate(near["von mises"])
    window = 13.0
    visible = np.all((shown.min(axis=1) < window) & (shown.max(axis=1) > -window), axis=1)
    largest, note = find_scale(stress[visible])
    add_section(left, shown, stress, STRESS_MAP, 0, largest)
    left.set_xlim(-window, window)
    left.set_ylim(-window, window)
    left.grid(False)
    left.set_xlabel("across the teeth [mm]")
    left.set_title(f"Normal section at the contact, {scene.when()}")
    add_colour_bar(picture, left, STRESS_MAP, 0, largest, "von Mises stress [MPa]", note)
    draw_pressure(scene, picture, right)
    return picture


def draw_pressure(scene, picture, axes):
    gear = scene.fields.body(scene.gear)
    cells, faces = find_outer_faces(gear)
    quads = gear.points[cells[:, None], FACES[faces]]
    pressure = gear["contact pressure"][cells[:, None], FACES[faces]].mean(axis=1)
    normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
    normal = (normals * pressure[:, None]).sum(axis=0)
    normal /= np.linalg.norm(normal)
    outward = scene.contact - scene.gear_centre
    outward -= (outward @ scene.gear_axis) * scene.gear_axis
    outward = outward / np.linalg.norm(outward) - scene.gear_axis
    camera = Camera(scene.contact, normal + 0.75 * outward, outward, 48.0, (1050, 840))
    largest = gear["contact pressure"].max()
    canvas = draw_faces(gear, "contact pressure", camera, edge_width=1.2)
    show_image(axes, canvas.image(PRESSURE_MAP, 0, largest))
    axes.set_title("Contact pressure on the gear teeth (pinion hidden)")
    add_colour_bar(picture, axes, PRESSURE_MAP, 0, 1, "nodal pressure over largest nodal pressure", "")
