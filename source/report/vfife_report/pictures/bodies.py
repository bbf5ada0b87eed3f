# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of all bodies."""
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

from ..data.fields import read_meshes
from ..plots.style import STRESS_MAP, WIDE, plt
from .canvas import Camera
from .scene import Scene
from .shading import add_colour_bar, draw_faces, find_scale, show_image

BODY_COLOURS = ("#e2b04a", "#8fb4d6")  # pinion, gear


def fit_camera(points, eye, up, pixels_wide):
    """All points within a small border."""
    camera = Camera(np.zeros(3), eye, up, 1.0)
    across, upward = points @ camera.right, points @ camera.up
    target = 0.5 * ((across.min() + across.max()) * camera.right +
                    (upward.min() + upward.max()) * camera.up)
    width, height = 1.02 * np.ptp(across), 1.02 * np.ptp(upward)
    return Camera(target, eye, up, width, (pixels_wide, int(pixels_wide * height / width)))


def find_camera(scene, pixels_wide):
    """From where all bodies are seen, of a pair both axes and the mesh."""
    eye, up = np.array([1.0, -1.5, 1.0]), np.array([0.0, 0.0, 1.0])
    if scene.is_pair:
        across = np.cross(scene.gear_axis, scene.pinion_axis)
        eye = 0.25 * scene.pinion_axis - 0.75 * scene.gear_axis + 0.7 * across
        up = -scene.gear_axis
    return fit_camera(scene.fields.points.reshape(-1, 3), eye, up, pixels_wide)


@plt.rc_context(WIDE)
def draw_bodies(scene, pixels_wide=1300):
    """All bodies with mesh edges and von Mises stress."""
    fields = scene.fields
    camera = find_camera(scene, pixels_wide)
    largest, note = find_scale(fields["von mises"])
    image = draw_faces(fields, "von mises", camera).image(STRESS_MAP, 0, largest)
    picture, axes = plt.subplots(figsize=(0.0112 * pixels_wide, 0.01 * camera.pixels[1] + 0.4),
                                layout="compressed")
    show_image(axes, image)
    add_colour_bar(picture, axes, STRESS_MAP, 0, largest, "von Mises stress [MPa]", note)
    axes.set_title(f"{len(fields)} elements, {scene.when()}")
    return picture


@plt.rc_context(WIDE)
def draw_meshes(run, pixels_wide=1300):
    """The meshes of a pair, a colour each."""
    scene = Scene(run, read_meshes(run.path / "pair.vtu"))
    camera = find_camera(scene, pixels_wide)
    bodies = scene.fields.bodies()
    colours = ListedColormap(BODY_COLOURS[:len(bodies)])
    image = draw_faces(scene.fields, "body", camera, edge_width=0.6).image(colours, 0, max(1, len(bodies) - 1))
    picture, axes = plt.subplots(figsize=(0.01 * pixels_wide, 0.01 * camera.pixels[1] + 0.4), layout="compressed")
    show_image(axes, image)
    axes.legend([Patch(color=colour) for colour in BODY_COLOURS], [run.body_name(body) for body in bodies], loc="upper left")
    return picture
