# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Geometry of hexahedra: outer faces, plane sections, axes of bodies of revolution."""
import numpy as np

# Faces with outward normals and edges, in VTK's order of vertices.
FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6],
                  [3, 0, 4, 7]])
EDGES = np.array([[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5],
                  [2, 6], [3, 7]])


def find_outer_faces(fields):
    """Cell and face number of each face that belongs to one cell only.

    Cells carry their own points; equal coordinates of a body are one node. Where two ranks differ
    in the last digit an inner face remains, inside the body, where nobody sees it.
    """
    corners = fields.points.astype(np.float32).reshape(-1, 3) + np.float32(0)  # no negative zeros
    body = fields["body"].astype(np.float32).reshape(-1, 1)
    keys = np.ascontiguousarray(np.hstack([corners, body])).view("V16").ravel()
    nodes = np.unique(keys, return_inverse=True)[1].reshape(-1, 8)
    faces = np.sort(nodes[:, FACES].reshape(-1, 4), axis=1)
    _, first, count = np.unique(faces, axis=0, return_index=True, return_counts=True)
    return np.divmod(np.sort(first[count == 1]), 6)


def find_axis(points):
    """Point and unit vector of the axis of a body with cyclic symmetry: of its three principal
    axes the one whose moment is not like the two others; away from the origin, where the axes of a
    gear pair meet (from apex to back)."""
    points = points.reshape(-1, 3)
    centre = points.mean(axis=0)
    moments, axes = np.linalg.eigh(np.cov((points - centre).T))
    single = 0 if moments[1] - moments[0] > moments[2] - moments[1] else 2
    axis = axes[:, single]
    return centre, axis if axis @ centre >= 0 else -axis


class Section:
    """Polygons in which a plane cuts hexahedra, padded to six corners with the last one.

    `corners` (polygons, 6, 3), `weights` of the cell's vertices (polygons, 6, 8), `cells`. Edges of
    polygons lie in the cells' faces, so that they are the mesh's traces.
    """

    def __init__(self, points, origin, normal):
        height = (points - origin) @ normal
        # A plane along faces of cells would cut none of them: it is moved by a millionth.
        height += 1e-6 * np.abs(height).max()
        self.cells = np.flatnonzero((height.min(axis=1) < 0) & (height.max(axis=1) > 0))
        height = height[self.cells]
        a, b = height[:, EDGES[:, 0]], height[:, EDGES[:, 1]]
        crossed = (a < 0) != (b < 0)
        share = np.where(crossed, a / np.where(crossed, a - b, 1), 0)
        weights = np.zeros((len(self.cells), 12, 8))
        edge = np.arange(12)
        weights[:, edge, EDGES[:, 0]] = 1 - share
        weights[:, edge, EDGES[:, 1]] += share
        places = np.einsum("nek,nkc->nec", weights, points[self.cells])
        # Around the centre, edges that are not crossed last.
        centre = (places * crossed[..., None]).sum(axis=1) / crossed.sum(axis=1)[:, None]
        first, second = find_plane_axes(normal)
        offset = places - centre[:, None]
        angle = np.where(crossed, np.arctan2(offset @ second, offset @ first), np.inf)
        order = np.argsort(angle, axis=1)[:, :6]
        last = np.minimum(np.arange(6), crossed.sum(axis=1)[:, None] - 1)
        order = np.take_along_axis(order, last, axis=1)[..., None]
        self.corners = np.take_along_axis(places, order, axis=1)
        self.weights = np.take_along_axis(weights, order, axis=1)

    def interpolate(self, values):
        """Values of the cells' vertices, (all cells, 8) or (all cells, 8, 3), at the corners."""
        return np.einsum("npk,nk...->np...", self.weights, values[self.cells])


def find_plane_axes(normal):
    """Two unit vectors that make a right-handed frame with the normal."""
    first = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    first /= np.linalg.norm(first)
    return first, np.cross(normal, first)
