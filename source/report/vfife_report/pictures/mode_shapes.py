# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the lowest vibrations of a body, from modes.csv and modes/BODY_SPEED_rpm.vtu."""
import numpy as np

from ..data.fields import Fields, read_piece
from ..data.table import Table
from ..measures.kind_results import list_vibrations
from ..plots.style import STRESS_MAP, WIDE, plt
from .bodies import fit_camera
from .hexahedra import find_axis, find_outer_faces
from .shading import add_colour_bar, draw_faces, show_image

SHAPES = 6
COLUMNS = 3
PIXELS = 520  # width of a shape
SHOWN_AMPLITUDE = 0.06  # of the largest displacement, over the body's largest extent


def find_shapes(run, table, body):
    """Rows of modes.csv of the body at its lowest speed, and the file of their shapes."""
    mine = table["body"] == body
    lowest = table["speed"][mine][np.argmin(np.abs(table["speed"][mine]))]
    return np.flatnonzero(mine & (table["speed"] == lowest)), run.path / "modes" / f"{body}_{round(lowest)}_rpm.vtu"


def list_shaped_bodies(run):
    table = Table(run.path / "modes.csv")
    return [body for body in dict.fromkeys(table["body"]) if find_shapes(run, table, body)[1].is_file()]


def describe_vibration(table, row):
    diameter, circles = table["nodal diameter"][row], table["nodal circles"][row]
    text = f"{table['mode'][row]:.0f}: {table['frequency'][row]:.0f} Hz"
    if diameter >= 0:
        text += f", {diameter:.0f} diameter{'s' * (diameter != 1)}"
    return text + (f", {circles:.0f} circle{'s' * (circles != 1)}" if circles > 0 else "")


@plt.rc_context(WIDE)
def draw_mode_shapes(run, body):
    """The lowest vibrations at the lowest speed, deformed, with the magnitude of the displacement over its largest."""
    table = Table(run.path / "modes.csv")
    rows, path = find_shapes(run, table, body)
    chosen = list_vibrations(table, rows)[:SHAPES]
    if not chosen:
        return None
    points, data = read_piece(path)
    names = {int(name.split(",")[0].split()[1]): name for name in data if name.startswith("mode ")}
    outer = find_outer_faces(Fields(points, {"body": np.zeros(points.shape[:2])}, None))
    extent = np.ptp(points.reshape(-1, 3), axis=0).max()
    shapes = []
    for row in chosen:
        shape = data[names[int(table["mode"][row])]]
        size = np.linalg.norm(shape, axis=-1)
        shapes.append(Fields(points + SHOWN_AMPLITUDE * extent / size.max() * shape, {"size": size / size.max()}, None))
    eye, up = np.array([1.0, -1.5, 1.0]), np.array([0.0, 0.0, 1.0])
    if np.any(table["nodal diameter"][rows] >= 0):
        axis = find_axis(points)[1]
        up = np.cross(axis, np.roll(axis, 1))
        eye = 0.8 * axis - 0.6 * up / np.linalg.norm(up)
    camera = fit_camera(np.concatenate([one.points.reshape(-1, 3) for one in shapes]), eye, up, PIXELS)
    lines = -(-len(shapes) // COLUMNS)
    columns = min(COLUMNS, len(shapes))
    picture, panels = plt.subplots(lines, columns, squeeze=False, layout="compressed",
                                   figsize=(0.01 * PIXELS * columns + 1, (0.01 * camera.pixels[1] + 0.4) * lines))
    for axes in panels.flat:
        axes.axis("off")
    for axes, one, row in zip(panels.flat, shapes, chosen):
        show_image(axes, draw_faces(one, "size", camera, 0.5, outer).image(STRESS_MAP, 0, 1))
        axes.set_title(describe_vibration(table, row))
    add_colour_bar(picture, panels, STRESS_MAP, 0, 1, "displacement over largest displacement")
    return picture
