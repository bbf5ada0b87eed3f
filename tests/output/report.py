#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripts of source/report: their geometry and averages against closed forms, and all plots and
pictures of a small made-up run. Ends with 77 (skipped) without numpy or matplotlib."""
import json
import sys
import tempfile
import unittest
from pathlib import Path

REPORT = Path(__file__).resolve().parents[2] / "source" / "report"
sys.path.insert(0, str(REPORT))
sys.dont_write_bytecode = True
try:
    import numpy as np
    import style
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

import plot_run  # noqa: E402
from canvas import Camera, Canvas  # noqa: E402
from fields import Fields  # noqa: E402
from hexahedra import Section, find_axis, find_outer_faces  # noqa: E402
from histories import compute_mesh_average  # noqa: E402
from spectra import compute_spectrum  # noqa: E402

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                    [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)


def make_block(cells):
    """Unit cubes, (cells, 8, 3)."""
    places = np.stack(np.meshgrid(*[np.arange(n) for n in cells], indexing="ij"), axis=-1)
    return places.reshape(-1, 1, 3) + CORNERS


def make_ring(inner, outer, length, teeth):
    """Cells around the z axis, each second one twice as high, as teeth are."""
    angle = 2 * np.pi / teeth
    unit = np.repeat(CORNERS[None], teeth, axis=0)
    turn = (unit[..., 1] + np.arange(teeth)[:, None]) * angle
    height = np.where(np.arange(teeth)[:, None] % 2, 2, 1) * length
    radius = inner + (outer - inner) * unit[..., 0]
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), height * unit[..., 2]], axis=-1)


def make_fields(points, body=0.0):
    return Fields([(points, {"body": np.full(points.shape[:2], body)})], 0.0)


class Geometry(unittest.TestCase):
    def test_outer_faces(self):
        cells, faces = find_outer_faces(make_fields(make_block((3, 2, 4))))
        self.assertEqual(len(faces), 2 * (6 + 8 + 12))
        self.assertEqual(np.count_nonzero((faces == 0)), 6)  # below

    def test_section(self):
        """Area of the regular hexagon in a cube, and a linear field on it."""
        normal = np.ones(3) / np.sqrt(3)
        points = CORNERS[None]
        section = Section(points, np.full(3, 0.5), normal)
        corners = section.corners[0]
        area = 0.5 * np.linalg.norm(np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0))
        self.assertAlmostEqual(area, 0.75 * np.sqrt(3), places=5)  # the plane is moved
        values = points @ np.array([1.0, -2.0, 3.0])
        difference = section.interpolate(values)[0] - corners @ np.array([1.0, -2.0, 3.0])
        self.assertLess(np.abs(difference).max(), 1e-14)  # round-off of numbers near one
        along_faces = Section(make_block((2, 2, 2)), np.ones(3), np.array([0, 0, 1.0]))
        self.assertEqual(len(along_faces.cells), 4)

    def test_axis(self):
        turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
        centre = 50 * turn[:, 2]
        found = find_axis(make_ring(20, 30, 5, 24) @ turn.T + centre)[1]
        self.assertLess(np.linalg.norm(found - turn[:, 2]), 1e-12)

    def test_canvas(self):
        """The nearer of two squares hides the farther; half the picture stays empty."""
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
        for order in (1, -1):
            camera = Camera(np.array([0.5, 0.5, 0]), np.array([0, 0, 1.0]), np.array([0, 1.0, 0]),
                            2.0, (40, 20))
            canvas = Canvas(camera)
            near, far = square + [0, 0, 1], square
            quads, values = np.stack([near, far])[::order], np.array([[3.0] * 4, [1.0] * 4])[::order]
            canvas.draw(quads, values)
            drawn = np.isfinite(canvas.height)
            self.assertAlmostEqual(drawn.mean(), 0.5, delta=0.05)  # a pixel at each edge
            self.assertLess(np.abs(canvas.value[drawn] - 3).max(), 1e-6)  # single precision


class Histories(unittest.TestCase):
    def test_mesh_average(self):
        """Harmonics of the mesh vanish, a line stays, also with 12.5 samples a mesh."""
        at = np.arange(200)
        wave = 7 + 0.1 * at + np.sin(2 * np.pi * at / 10)
        average = compute_mesh_average(wave, 10.0)
        inside = np.isfinite(average)
        self.assertEqual(np.count_nonzero(inside), 190)
        self.assertLess(np.abs(average - 7 - 0.1 * at)[inside].max(), 1e-11)
        line = compute_mesh_average(3.0 * at, 12.5)
        self.assertLess(np.nanmax(np.abs(line - 3 * at)), 1e-10)

    def test_spectrum(self):
        at = np.arange(512)
        orders, amplitudes = compute_spectrum(4 + 2.5 * np.cos(2 * np.pi * at * 3 / 50), 50.0)
        self.assertAlmostEqual(orders[np.argmax(amplitudes)], 3)
        self.assertAlmostEqual(amplitudes.max(), 2.5, places=10)
        self.assertLess(np.sort(amplitudes)[-2], 1e-10)


def write_vtu(path, fields):
    def array(name, values, kind="Float32"):
        components = values.shape[1] if values.ndim > 1 else 1
        text = " ".join(f"{v:g}" for v in values.ravel())
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" '
                f'format="ascii">{text}</DataArray>')

    n = len(fields)
    data = [array(name, values.reshape((8 * n,) + values.shape[2:]))
            for name, values in fields.data.items()]
    path.write_text(
        f'<VTKFile><UnstructuredGrid><Piece NumberOfPoints="{8 * n}" NumberOfCells="{n}"><Points>'
        + array("points", fields.points.reshape(-1, 3)) + "</Points><Cells>"
        + array("connectivity", np.arange(8 * n), "Int32") + array("types", np.full(n, 12), "UInt8")
        + "</Cells><PointData>" + "".join(data) + "</PointData></Piece></UnstructuredGrid></VTKFile>")


def make_pair():
    """Two rings with axes x and z that meet at the origin."""
    gear = make_ring(60, 80, 10, 24) + [0, 0, 40]
    pinion = make_ring(10, 40, 12, 12)[..., [2, 0, 1]] + [60, 0, 0]
    points = np.concatenate([gear, pinion])
    body = np.repeat([1.0, 0.0], [len(gear), len(pinion)])[:, None] * np.ones(8)
    pressure = np.where(np.linalg.norm(points - [70, 0, 40], axis=-1) < 12, 500.0, 0.0)
    data = {"body": body, "contact pressure": pressure, "von mises": 1.0 + points[..., 2] ** 2,
            "displacement": 1e-3 * points}
    return Fields([(points, data)], 1e-3)


def write_run(folder):
    time = np.arange(101) * 1e-3 / 100
    names = ["time [s]", "dte [arcsec]", "rim dte [arcsec]", "contact force total [N]",
             "energy error [-]", "strain energy [mJ]"]
    rows = [[t, -80 + np.sin(5e4 * t), -70, 9000, 1e-3, 1200 + t] for t in time]
    text = "\n".join([",".join(names)] + [",".join(map(repr, row)) for row in rows])
    (folder / "history.csv").write_text(text + "\n0.001,3")  # the last line is cut off
    (folder / "teeth.csv").write_text(
        "time [s],side,pinion tooth [-],gear tooth [-],force [N],largest pressure [MPa],"
        "mean pressure [MPa],hertz pressure [MPa]\n"
        "0,drive,0,0,9000,1000,800,1300\n0.001,drive,26,1,8000,1100,700,1250\n"
        "0.001,coast,1,0,10,20,15,130\n")
    places = [(r, z) for r in range(5) for z in range(4)]
    (folder / "pattern.csv").write_text(
        "body,side,r [mm],z [mm],largest pressure [MPa]\n"
        + "".join(f"{body},{side},{r},{z},{100 * r * z}\n" for body in ("pinion", "gear")
                  for side in ("drive", "coast") for r, z in places))
    (folder / "probes.csv").write_text(
        "time [s],probe,von mises [MPa]\n0,a,1\n0,b,2\n0.001,a,3\n0.001,b,3\n")
    summary = {"figures": {"mesh frequency": {"value": 9000}},
               "mesh": {"bodies": [{"name": "pinion"}, {"name": "gear"}]},
               "steady part": {"start": {"value": 2e-4}, "end": {"value": 1e-3}, "found": True}}
    (folder / "summary.json").write_text(json.dumps(summary))
    (folder / "fields.pvd").write_text('<VTKFile><Collection><DataSet timestep="0.001" '
                                       'file="last.vtu"/></Collection></VTKFile>')
    write_vtu(folder / "last.vtu", make_pair())


class WholeRun(unittest.TestCase):
    def test_all_pictures(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            write_run(folder)
            plot_run.main([name])
            drawn = {path.name for path in (folder / "pictures").iterdir()}
            self.assertEqual(drawn, {
                "dte.svg", "contact_force.svg", "load_sharing.svg", "contact_pattern.svg",
                "energies.svg", "probes.svg", "spectra.svg",
                "bodies.png", "teeth_in_mesh.png", "meridian_section.png", "deformation.png"})

    def test_no_run(self):
        with tempfile.TemporaryDirectory() as name:
            for folder, words in ((name, "neither histories nor fields"), (name + "/a", "no folder")):
                with self.assertRaisesRegex(SystemExit, words):
                    plot_run.main([folder])


if __name__ == "__main__":
    unittest.main()
