# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws quadrilaterals in space into an image: parallel projection, depth buffer, mesh edges.

In numpy, because VTK of Debian needs an X server to draw at all.
"""
import numpy as np

from ..plots.style import darken_edges

OVERSAMPLING = 2
LARGEST_BATCH = 3_000_000  # pixels of triangles treated at once
INSIDE_SHARE = -1e-9  # of a corner in a point: pixels on an edge are inside


class Camera:
    """Looks from direction `eye` (from the target to the viewer) with `up` upwards; `width` [mm] of
    the picture at the target."""

    def __init__(self, target, eye, up, width, pixels=(1400, 1050)):
        self.target, self.pixels = target, pixels
        self.towards = eye / np.linalg.norm(eye)
        self.right = np.cross(up, self.towards)
        self.right /= np.linalg.norm(self.right)
        self.up = np.cross(self.towards, self.right)
        self.scale = OVERSAMPLING * pixels[0] / width  # pixels a mm

    def project(self, points):
        """Columns, rows and height towards the viewer, in (oversampled) pixels."""
        offset = (points - self.target) * self.scale
        columns = offset @ self.right + 0.5 * OVERSAMPLING * self.pixels[0]
        rows = -(offset @ self.up) + 0.5 * OVERSAMPLING * self.pixels[1]
        return np.stack([columns, rows, offset @ self.towards], axis=-1)


class Canvas:
    """Image under way: height, value, brightness and whether a mesh edge, at each pixel."""

    def __init__(self, camera, edge_width=0.9):
        self.camera, self.edge_width = camera, edge_width * OVERSAMPLING
        self.shape = (OVERSAMPLING * camera.pixels[1], OVERSAMPLING * camera.pixels[0])
        n = self.shape[0] * self.shape[1]
        self.height = np.full(n, -np.inf, dtype=np.float32)
        self.value = np.full(n, np.nan, dtype=np.float32)
        self.brightness = np.ones(n, dtype=np.float32)
        self.edge = np.zeros(n, dtype=bool)

    def draw(self, quads, values):
        """Quadrilaterals (n, 4, 3), corners counter-clockwise from outside, values (n, 4)."""
        normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
        lengths = np.linalg.norm(normals, axis=1)
        normals /= np.where(lengths > 0, lengths, 1)[:, None]
        front = normals @ self.camera.towards > 0
        light = self.camera.towards + 0.5 * self.camera.up - 0.35 * self.camera.right
        light /= np.linalg.norm(light)
        bright = 0.5 + 0.5 * np.clip(normals @ light, 0, 1)

        projected = self.camera.project(quads[front])
        corners = np.concatenate([projected[:, [0, 1, 2]], projected[:, [0, 2, 3]]])
        at = np.concatenate([values[front][:, [0, 1, 2]], values[front][:, [0, 2, 3]]])
        bright = np.tile(bright[front], 2)
        # The edge opposite to this corner is the diagonal, which is not drawn.
        diagonal = np.repeat([1, 2], [len(projected)] * 2)
        low, high = self._boxes(corners)
        size = np.prod(np.maximum(high - low, 0), axis=1)
        batch = np.cumsum(size) // LARGEST_BATCH
        for number in range(int(batch[-1]) + 1 if len(batch) else 0):
            rows = np.flatnonzero((batch == number) & (size > 0))
            self._draw_batch(corners[rows], at[rows], bright[rows], diagonal[rows], low[rows],
                             high[rows])

    def _boxes(self, corners):
        limit = np.array([self.shape[1], self.shape[0]])
        low = np.clip(np.floor(corners[:, :, :2].min(axis=1)), 0, limit).astype(int)
        high = np.clip(np.ceil(corners[:, :, :2].max(axis=1)) + 1, 0, limit).astype(int)
        return low, high

    def _draw_batch(self, corners, at, bright, diagonal, low, high):
        # Barycentric coordinates are linear in column and row; their gradient's inverse length is
        # the distance of a corner from the opposite edge.
        x, y = corners[:, :, 0], corners[:, :, 1]
        area = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
        area = np.where(np.abs(area) > 1e-12, area, np.inf)[:, None]
        following, last = [1, 2, 0], [2, 0, 1]
        start_x, start_y = x[:, following], y[:, following]
        dx, dy = (start_y - y[:, last]) / area, (x[:, last] - start_x) / area
        triangle, row, column = self._list_pixels(low, high, start_x, start_y, dx, dy)

        shares = []
        inside = np.ones(len(triangle), dtype=bool)
        for k in range(3):
            share = ((column - start_x[:, k][triangle]) * dx[:, k][triangle] +
                     (row - start_y[:, k][triangle]) * dy[:, k][triangle])
            inside &= share >= INSIDE_SHARE
            shares.append(share)
        # Only what is seen has a value.
        pixel = row * self.shape[1] + column
        pixel, triangle, shares = pixel[inside], triangle[inside], [share[inside] for share in shares]
        height = np.zeros(len(triangle))
        for k in range(3):
            height += shares[k] * corners[:, k, 2][triangle]
        kept = np.flatnonzero(height > self.height[pixel])
        kept = kept[np.argsort(height[kept])]  # the nearest is written last
        pixel, triangle, height = pixel[kept], triangle[kept], height[kept]
        value = np.zeros(len(triangle))
        edge = np.zeros(len(triangle), dtype=bool)
        for k in range(3):
            share = shares[k][kept]
            value += share * at[:, k][triangle]
            reach = 0.5 * self.edge_width * np.hypot(dx[:, k], dy[:, k])
            edge |= (share < reach[triangle]) & (diagonal[triangle] != k)
        self.height[pixel] = height
        self.value[pixel] = value
        self.brightness[pixel] = bright[triangle]
        self.edge[pixel] = edge

    @staticmethod
    def _list_pixels(low, high, start_x, start_y, dx, dy):
        """Triangle, row and column of all pixels in triangles, of few beside them and of none outside the boxes."""
        extent = high - low
        triangle = np.repeat(np.arange(len(extent)), extent[:, 1])
        first = np.cumsum(extent[:, 1]) - extent[:, 1]
        row = low[triangle, 1] + np.arange(len(triangle)) - first[triangle]
        begin, end = low[triangle, 0], high[triangle, 0]
        # The edges bound the columns of a row, but for edges along it; one pixel is left for round-off.
        for k in range(3):
            slope, rise = dx[:, k][triangle], dy[:, k][triangle]
            bounds = np.abs(slope) > 1e-6 * np.abs(rise)
            at = (start_x[:, k][triangle] +
                  (INSIDE_SHARE - (row - start_y[:, k][triangle]) * rise) / np.where(bounds, slope, 1))
            at = np.clip(at, begin - 2, end + 2)
            begin = np.where(bounds & (slope > 0), np.maximum(begin, np.floor(at).astype(int) - 1), begin)
            end = np.where(bounds & (slope < 0), np.minimum(end, np.ceil(at).astype(int) + 2), end)
        width = np.maximum(end - begin, 0)
        shift = begin - (np.cumsum(width) - width)
        return np.repeat(triangle, width), np.repeat(row, width), np.arange(width.sum()) + np.repeat(shift, width)

    def image(self, colour_map, lowest, largest):
        """Colours (rows, columns, 3), white where nothing is drawn."""
        drawn = np.flatnonzero(np.isfinite(self.height))
        share = np.clip((self.value[drawn] - lowest) / (largest - lowest), 0, 1)
        shaded = colour_map(share)[:, :3] * self.brightness[drawn][:, None]
        colour = np.ones((len(self.height), 3))
        colour[drawn] = darken_edges(shaded, self.edge[drawn])
        rows, columns = self.camera.pixels[1], self.camera.pixels[0]
        return colour.reshape(rows, OVERSAMPLING, columns, OVERSAMPLING, 3).mean(axis=(1, 3))
