# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the last fields of a run: pair, teeth in mesh, meridian section, deformed web."""
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection, TriMesh
from matplotlib.colors import Normalize
from matplotlib.tri import Triangulation

from canvas import Camera, Canvas
from hexahedra import FACES, Section, find_axis, find_outer_faces
from style import EDGE, GREY, PRESSURE_MAP, SIGNED_MAP, STRESS_MAP, WIDE, plt


class Scene:
    """Fields of a gear pair and where its axes and its contact are, found from the fields."""

    def __init__(self, run, fields):
        if not np.all(np.isfinite(fields.points)):
            raise ValueError("positions of the last fields are no numbers")
        self.run, self.fields = run, fields
        names = {run.body_name(b): b for b in fields.bodies()}
        self.is_pair = {"pinion", "gear"} <= set(names)
        pressure = fields["contact pressure"]
        self.contact = None
        if np.any(pressure > 0):
            self.contact = (fields.points * pressure[..., None]).sum(axis=(0, 1)) / pressure.sum()
        if self.is_pair:
            self.pinion, self.gear = names["pinion"], names["gear"]
            self.pinion_axis = find_axis(fields.body(self.pinion).points)[1]
            self.gear_centre, self.gear_axis = find_axis(fields.body(self.gear).points)

    def largest_pressure(self):
        """Of teeth.csv at the time of the fields [MPa]; None without it."""
        teeth = self.run.teeth
        if teeth is None:
            return None
        now = np.abs(teeth["time"] - self.fields.time) < 1e-6 * max(self.fields.time, 1e-9)
        return teeth["largest pressure"][now].max() if np.any(now) else None

    def when(self):
        return f"time {1e3 * self.fields.time:.3f} ms"


def draw_faces(fields, name, camera, edge_width=0.9):
    cells, faces = find_outer_faces(fields)
    corners = FACES[faces]
    canvas = Canvas(camera, edge_width)
    canvas.draw(fields.points[cells[:, None], corners], fields[name][cells[:, None], corners])
    return canvas


def add_colour_bar(figure, axes, colour_map, lowest, largest, label, text=""):
    mappable = ScalarMappable(Normalize(lowest, largest), colour_map)
    bar = figure.colorbar(mappable, ax=axes, shrink=0.7, aspect=28, pad=0.01)
    bar.set_label(label + text)
    bar.outline.set_visible(False)


def find_scale(values):
    """End of the colour scale, so that few peaks do not take all colours, and a note of the peak."""
    end, peak = np.percentile(values, 99.7), values.max()
    return end, f" (largest {peak:.0f})" if peak > 1.02 * end else ""


def show_image(axes, image):
    axes.imshow(image, interpolation="nearest")
    axes.axis("off")


def fit_camera(points, eye, up, pixels_wide):
    """All points within a small border."""
    camera = Camera(np.zeros(3), eye, up, 1.0)
    across, upward = points @ camera.right, points @ camera.up
    target = 0.5 * ((across.min() + across.max()) * camera.right +
                    (upward.min() + upward.max()) * camera.up)
    width, height = 1.02 * np.ptp(across), 1.02 * np.ptp(upward)
    return Camera(target, eye, up, width, (pixels_wide, int(pixels_wide * height / width)))


@plt.rc_context(WIDE)
def draw_bodies(scene, pixels_wide=1300):
    """All bodies with mesh edges and von Mises stress."""
    fields = scene.fields
    eye, up = np.array([1.0, -1.5, 1.0]), np.array([0.0, 0.0, 1.0])
    if scene.is_pair:
        across = np.cross(scene.gear_axis, scene.pinion_axis)
        eye = 0.25 * scene.pinion_axis - 0.75 * scene.gear_axis + 0.7 * across
        up = -scene.gear_axis
    camera = fit_camera(fields.points.reshape(-1, 3), eye, up, pixels_wide)
    largest, note = find_scale(fields["von mises"])
    image = draw_faces(fields, "von mises", camera).image(STRESS_MAP, 0, largest)
    figure, axes = plt.subplots(figsize=(0.0112 * pixels_wide, 0.01 * camera.pixels[1] + 0.4),
                                layout="compressed")
    show_image(axes, image)
    add_colour_bar(figure, axes, STRESS_MAP, 0, largest, "von Mises stress [MPa]", note)
    axes.set_title(f"{len(fields)} elements, {scene.when()}")
    return figure


def add_section(axes, shown, values, colour_map, lowest, largest):
    """Polygons of a section at the places `shown` (n, 6, 2), shaded, with the mesh's traces."""
    n = len(shown)
    corner = 6 * np.arange(n)[:, None]
    triangles = np.concatenate([corner + [0, k, k + 1] for k in range(1, 5)])
    flat = shown.reshape(-1, 2)
    a, b, c = flat[triangles[:, 0]], flat[triangles[:, 1]], flat[triangles[:, 2]]
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    mesh = TriMesh(Triangulation(flat[:, 0], flat[:, 1], triangles[np.abs(area) > 1e-12]),
                   cmap=colour_map, norm=Normalize(lowest, largest), rasterized=True)
    mesh.set_array(values.ravel())
    axes.add_collection(mesh)
    axes.add_collection(PolyCollection(shown, facecolors="none", edgecolors=EDGE, linewidths=0.25,
                                       alpha=0.7))
    axes.set_aspect("equal")
    axes.autoscale_view()


@plt.rc_context(WIDE)
def draw_teeth_in_mesh(scene):
    """Section across the teeth at the contact with von Mises stress; pressure on the gear's teeth."""
    fields, contact = scene.fields, scene.contact
    figure, (left, right) = plt.subplots(1, 2, figsize=(14, 5.6), layout="compressed")
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
    left.set_title(f"Section normal to the cone distance at the contact, {scene.when()}")
    add_colour_bar(figure, left, STRESS_MAP, 0, largest, "von Mises stress [MPa]", note)
    draw_pressure(scene, figure, right)
    return figure


def draw_pressure(scene, figure, axes):
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
    axes.set_title("Contact pressure on the gear's teeth, pinion taken away")
    peak = scene.largest_pressure()
    note = f"\n(largest at the contact's own points {peak:.0f})" if peak else ""
    add_colour_bar(figure, axes, PRESSURE_MAP, 0, largest, "mean pressure at nodes [MPa]", note)


def find_meridian(scene):
    """Plane through the gear's axis and the contact: origin, normal, axis, radial direction."""
    axis = scene.gear_axis
    radial = scene.contact - scene.gear_centre
    radial -= (radial @ axis) * axis
    radial /= np.linalg.norm(radial)
    return scene.gear_centre, np.cross(axis, radial), axis, radial


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
    figure, axes = plt.subplots(figsize=(8.6, 8), layout="compressed")
    add_section(axes, shown, stress, STRESS_MAP, 0, largest)
    of_gear = shown[half & gear]
    low, high = of_gear.min(axis=(0, 1)) - 12, of_gear.max(axis=(0, 1)) + 12
    axes.set_xlim(low[0] - 5, high[0])
    axes.set_ylim(low[1], high[1])
    axes.grid(False)
    axes.set_xlabel("along the gear's axis, from the apex [mm]")
    axes.set_ylabel("radius from the gear's axis [mm]")
    axes.set_title(f"Meridian section at the contact, {scene.when()}")
    add_colour_bar(figure, axes, STRESS_MAP, 0, largest, "von Mises stress [MPa]", note)
    return figure


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
    figure, panels = plt.subplots(1, 2, sharex=True, sharey=True, figsize=(11, 7),
                                  layout="compressed")
    for panel, side, place in zip(panels, (-1, 1), ("Opposite to the contact", "At the contact")):
        frame = np.stack([axis, side * radial], axis=1)
        half = side * height.min(axis=1) > 0
        start = (section.corners[half] - origin) @ frame + [origin @ axis, 0]
        now = start + 1e-3 * magnification * (displacement[half] @ frame)
        add_section(panel, now, displacement[half] @ axis, SIGNED_MAP, -largest, largest)
        panel.add_collection(LineCollection(find_outline(start), colors=GREY, linewidths=0.9))
        panel.grid(False)
        panel.set_title(place)
        panel.set_xlabel("along the gear's axis, from the apex [mm]")
    panels[0].set_ylabel("radius from the gear's axis [mm]")
    figure.suptitle(f"Displacements magnified {magnification:g} times, grey: undeformed; "
                    f"{scene.when()}")
    add_colour_bar(figure, panels, SIGNED_MAP, -largest, largest,
                   "displacement along the axis, + to the back [um]")
    return figure


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
