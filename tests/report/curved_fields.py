#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""curved_fields.py PROGRAM: field files of quadratic and cubic elements, read by meshio and, where it is there, by VTK:
places and values at all points of curved cells against closed forms, sector modes against those of the whole body."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import made_up_run  # noqa: F401  first: ends the test without the libraries

import meshio
import numpy as np
from vfife_report.data.fields import read_piece
from vfife_report.data.table import Table

try:
    from vtkmodules.vtkCommonCore import reference
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    vtkXMLUnstructuredGridReader = None

PROGRAM = sys.argv.pop(1)
FOLDER = Path(__file__).parent
KINDS = {1: "hexahedron", 2: "hexahedron27", 3: "VTK_LAGRANGE_HEXAHEDRON"}
VTK_TYPES = {1: 12, 2: 29, 3: 72}
ELEMENTS = {1: "incompatible modes", 2: "quadratic", 3: "cubic"}
INNER, OUTER, HEIGHT, PLACE = 20, 40, 5, np.array([3, -2, 7])
E, NU, PRESSURE = 206000, 0.3, 100


def list_places(degree):
    """Places (0 to 1) of a cell's points as VTK's figures show them: corners, edges, faces, inside."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
    inside = np.arange(1, degree) / degree
    edges = [(0, 1), (1, 2), (3, 2), (0, 3), (4, 5), (5, 6), (7, 6), (4, 7), (0, 4), (1, 5), (2, 6), (3, 7)]
    if degree == 3:  # Lagrange cells of files before version 2.2
        edges[10:] = reversed(edges[10:])
    places = list(corners)
    for a, b in edges:
        places += [corners[a] + s * (corners[b] - corners[a]) for s in inside]
    for a, b, c in ((0, 3, 4), (1, 2, 5), (0, 1, 4), (3, 2, 7), (0, 1, 3), (4, 5, 7)):
        places += [corners[a] + s * (corners[b] - corners[a]) + t * (corners[c] - corners[a]) for t in inside for s in inside]
    return np.array(places + [np.array([r, s, t]) for t in inside for s in inside for r in inside])


def along(nodes, x):
    """Lagrange polynomials of evenly spaced nodes and their derivatives at x."""
    basis = [np.poly1d(np.poly(np.delete(nodes, i))) for i in range(len(nodes))]
    basis = [one / one(nodes[i]) for i, one in enumerate(basis)]
    return np.array([one(x) for one in basis]), np.array([one.deriv()(x) for one in basis])


def evaluate(degree, at):
    """Shape functions of a cell's points, as they stand in the file, at a place, and their gradients."""
    nodes = np.arange(degree + 1) / degree
    values, slopes = zip(*(along(nodes, x) for x in at))
    i, j, k = np.rint(list_places(degree) * degree).astype(int).T
    n = values[0][i] * values[1][j] * values[2][k]
    return n, np.stack([slopes[0][i] * values[1][j] * values[2][k], values[0][i] * slopes[1][j] * values[2][k],
                        values[0][i] * values[1][j] * slopes[2][k]])


class CurvedFields(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_case(self, case, name, *settings):
        path = self.folder / name
        more = [word for setting in settings for word in ("--set", setting)]
        ended = subprocess.run([PROGRAM, FOLDER / case, "-o", path, *more], capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stderr + ended.stdout)
        return path

    def run_ring(self, degree, *more):
        path = self.run_case("curved_fields.prm", f"ring_{degree}", f"Fem/element type={ELEMENTS[degree]}", *more)
        return path / "fields" / "ring.vtu"

    def read(self, path, degree):
        grid = meshio.vtu.read(path)
        self.assertEqual(set(grid.cells_dict), {KINDS[degree]})
        return grid, grid.cells_dict[KINDS[degree]]

    def check_patch(self, grid):
        """Linear displacement and uniform stress at each point, in the single precision of the file."""
        x = grid.points - PLACE
        exact = PRESSURE / E * x * [-(1 - NU), -(1 - NU), 2 * NU]
        np.testing.assert_allclose(grid.point_data["displacement [mm]"], exact, rtol=0, atol=2e-8)
        stress = np.zeros((len(x), 6))
        stress[:, :2] = -PRESSURE
        np.testing.assert_allclose(grid.point_data["stress [MPa]"], stress, rtol=0, atol=1e-4)
        for name, value in (("stress r", -PRESSURE), ("stress theta", -PRESSURE), ("stress z", 0), ("von mises", PRESSURE)):
            np.testing.assert_allclose(grid.point_data[name + " [MPa]"], value, rtol=0, atol=1e-4)

    def test_ring(self):
        # Points of a cubic cell are on the curve through its Lobatto points.
        for degree, n_points, off_circle, off_volume in ((2, 5 * 32 * 3, 4e-6, 1e-4), (3, 7 * 48 * 4, 4e-4, 1e-6)):
            grid, cells = self.read(self.run_ring(degree), degree)
            self.assertEqual(grid.points.shape, (n_points, 3))
            self.assertEqual(cells.shape, (32, (degree + 1) ** 3))
            self.assertEqual(set(cells.ravel()), set(range(n_points)))
            self.check_patch(grid)
            # Evenly spaced rings and layers; within a cell each point at its place along the circle.
            x = grid.points - PLACE
            radius = np.hypot(x[:, 0], x[:, 1])
            rings = INNER + (OUTER - INNER) / (2 * degree) * np.arange(2 * degree + 1)
            np.testing.assert_allclose(np.min(np.abs(radius[:, None] - rings), axis=1), 0, atol=off_circle)
            rule, weights = np.polynomial.legendre.leggauss(degree + 2)
            gradients = [evaluate(degree, np.array([a, b, c]) / 2 + 0.5)[1] for a in rule for b in rule for c in rule]
            volumes = [a * b * c / 8 for a in weights for b in weights for c in weights]
            linears = np.array([evaluate(1, place)[0] for place in list_places(degree)])
            volume = 0
            for cell in cells:
                y = x[cell]
                linear = linears @ y[:8]
                self.assertLess(np.max(np.linalg.norm(y - linear, axis=1)), 1)
                np.testing.assert_allclose(y[:, 2], linear[:, 2], atol=1e-5)
                determinants = np.linalg.det(np.array(gradients) @ y)
                self.assertGreater(determinants.min(), 0)
                volume += np.dot(volumes, determinants)
            exact = np.pi * (OUTER ** 2 - INNER ** 2) * HEIGHT
            self.assertLess(abs(volume / exact - 1), off_volume)

    def test_straight(self):
        """Chords instead of arcs; cubic cells have their points at thirds of each edge."""
        for degree in (2, 3):
            grid, cells = self.read(self.run_ring(degree, "Fem/geometry=straight"), degree)
            linear = np.array([evaluate(1, place)[0] for place in list_places(degree)])
            for cell in cells:
                np.testing.assert_allclose(grid.points[cell], linear @ grid.points[cell[:8]], atol=1e-5)

    def test_refined(self):
        """Elements that are divided at the bore: points that hang have the same fields."""
        for degree in (2, 3):
            grid, cells = self.read(self.run_ring(degree, "Fem/local refinement=inner 1"), degree)
            self.assertEqual(len(cells), 16 * 8 + 16)
            self.check_patch(grid)

    def test_linear(self):
        grid, cells = self.read(self.run_ring(1, "Fem/geometry=straight"), 1)
        self.assertEqual((len(grid.points), cells.shape), (3 * 16 * 2, (32, 8)))

    def test_report(self):
        """The report looks at the corners."""
        for degree in (2, 3):
            points, data = read_piece(self.run_ring(degree))
            self.assertEqual(points.shape, (32, 8, 3))
            np.testing.assert_allclose(data["von mises"], PRESSURE, atol=1e-4)

    def run_modes(self, name, degree, *more):
        """Grid, cells and, by nodal diameter, the lowest frequency with its shapes."""
        path = self.run_case("curved_modes.prm", f"{name}_{degree}", f"Fem/element type={ELEMENTS[degree]}", *more)
        modes = Table(path / "modes.csv")
        grid, cells = self.read(path / "modes" / "pinion_0_rpm.vtu", degree)
        shapes = {int(key.split(",")[0].split()[1]): values for key, values in grid.point_data.items()}
        for shape in shapes.values():
            # The largest displacement of the points that cubic elements have is 1.
            self.assertAlmostEqual(np.linalg.norm(shape, axis=1).max(), 1, delta=0.02 if degree == 3 else 1e-6)
        lowest = []
        for diameter in (0, 1):
            rows = np.flatnonzero(modes["nodal diameter"] == diameter)
            rows = rows[np.isclose(modes["frequency"][rows], modes["frequency"][rows[0]], rtol=1e-7)]
            lowest.append((modes["frequency"][rows[0]], np.stack([shapes[int(modes["mode"][row])].ravel() for row in rows])))
        return grid.points, cells, lowest

    def test_modes(self):
        """Shapes of one sector are those of the whole body at all points: alike, or in the plane of a pair."""
        points, cells, whole = self.run_modes("whole", 2, "Fem/modes=4")
        other_points, other_cells, sector = self.run_modes("sector", 2, "Fem/modes=2", "Fem/cyclic symmetry=yes")
        np.testing.assert_array_equal(points, other_points)
        np.testing.assert_array_equal(cells, other_cells)
        self.assertEqual([len(shapes) for _, shapes in whole], [1, 2])
        for (frequency, shapes), (other_frequency, (other, *_)) in zip(whole, sector):
            self.assertAlmostEqual(frequency / other_frequency, 1, delta=1e-7)
            coefficients, *_ = np.linalg.lstsq(shapes.T, other, rcond=None)
            np.testing.assert_allclose(coefficients @ shapes, other, rtol=0, atol=1e-5)
        # The whole body of cubic elements takes too long for a test; its points and cells are those of the sector's file.
        self.run_modes("sector", 3, "Fem/modes=2", "Fem/cyclic symmetry=yes")

    @unittest.skipUnless(vtkXMLUnstructuredGridReader, "VTK is not there")
    def test_vtk(self):
        """VTK evaluates cells as the file means them."""
        for degree in (2, 3):
            path = self.run_ring(degree)
            grid, cells = self.read(path, degree)
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(path))
            reader.Update()
            read = reader.GetOutput()
            self.assertEqual(read.GetNumberOfCells(), len(cells))
            shapes = {at: evaluate(degree, at)[0]
                      for at in ((.5, .5, .5), (.1, .9, .3), (.95, .9, .5), (.05, .95, .4), (.3, 0, 1))}
            for number, nodes in enumerate(cells):
                cell = read.GetCell(number)
                self.assertEqual(cell.GetCellType(), VTK_TYPES[degree])
                for at, functions in shapes.items():
                    place = [0., 0., 0.]
                    cell.EvaluateLocation(reference(0), at, place, [0.] * len(nodes))
                    np.testing.assert_allclose(place, functions @ grid.points[nodes], atol=1e-5)


if __name__ == "__main__":
    unittest.main()
