# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields as colours: faces seen by a camera, polygons of plane sections, colour scales."""
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection, TriMesh
from matplotlib.colors import Normalize
from matplotlib.tri import Triangulation

from ..plots.style import EDGE
from .canvas import Canvas
from .hexahedra import FACES, find_outer_faces


def draw_faces(fields, name, camera, edge_width=0.9, outer=None):
    """`outer`: cells and faces by find_outer_faces() where they are known, as of the same cells in other shapes."""
    cells, faces = find_outer_faces(fields) if outer is None else outer
    corners = FACES[faces]
    canvas = Canvas(camera, edge_width)
    canvas.draw(fields.points[cells[:, None], corners], fields[name][cells[:, None], corners])
    return canvas


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


def find_scale(values):
    """End of the colour scale, so that few peaks do not take all colours, and a note of the peak."""
    end, peak = np.percentile(values, 99.7), values.max()
    return end, f" (largest {peak:.0f})" if peak > 1.02 * end else ""


def add_colour_bar(picture, axes, colour_map, lowest, largest, label, text=""):
    mappable = ScalarMappable(Normalize(lowest, largest), colour_map)
    bar = picture.colorbar(mappable, ax=axes, shrink=0.7, aspect=28, pad=0.01)
    bar.set_label(label + text)
    bar.outline.set_visible(False)


def show_image(axes, image):
    axes.imshow(image, interpolation="nearest")
    axes.axis("off")
