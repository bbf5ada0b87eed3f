#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of bodies by themselves: their meshes, and the shapes of their vibrations."""
import unittest
from pathlib import Path

from made_up_run import (  # first: ends the test without the libraries
    FolderTest, make_pair, make_parameters, make_ring, read_report, write_parameters, write_vtu)

import meshio
import numpy as np

from vfife_report.data.fields import Fields, read_meshes
from vfife_report.data.run_folder import RunFolder
from vfife_report.data.table import Table
from vfife_report.pictures.mode_shapes import describe_vibration, draw_mode_shapes, list_vibrations

MESH = ("body,elements [-],nodes [-],least scaled jacobian [-],mass [kg]\n"
        "pinion,12,96,0.61234567,0.5\ngear,24,192,0.7,1.75\n")
MERIDIAN = "body,part,r [mm],z [mm]\n" + "".join(
    f"{body},{part},{r},{z}\n" for body, parts in (("pinion", ("teeth", "rim")), ("gear", ("teeth", "web")))
    for part in parts for r, z in ((10, 0), (20, 0), (20, 5)))
# Rigid, a wave twice, a mode without diameters, the wave again at another frequency.
FREQUENCIES = ((1, 1e-3, 0, 0), (2, 1000.0, 2, 0), (3, 1000.0, 2, 0), (4, 1500.0, 0, 0), (5, 2000.0, 2, 1), (6, 2000.0, 2, 1))
MODES = "body,speed [rpm],mode [-],frequency [Hz],nodal diameter [-],nodal circles [-],direction,fixed frequency [Hz],whirl\n" + "".join(
    f"gear,{speed},{mode},{frequency + speed},{diameter},{circles},standing,nan,-\n"
    for speed in (0, 3000) for mode, frequency, diameter, circles in FREQUENCIES)


def write_shapes(folder):
    """Six shapes of a ring, one amplitude a file."""
    points = make_ring(20, 30, 5, 24)
    turn = np.arctan2(points[..., 1], points[..., 0])
    n = len(points)
    shapes = {f"mode {mode}, {frequency:.1f} Hz [mm]": np.stack([0 * turn, 0 * turn, np.cos(diameter * turn)], axis=-1).reshape(-1, 3)
              for mode, frequency, diameter, _ in FREQUENCIES}
    (folder / "modes").mkdir()
    meshio.Mesh(points.reshape(-1, 3), [("hexahedron", np.arange(8 * n).reshape(n, 8))], shapes).write(folder / "modes" / "gear_0_rpm.vtu")
    (folder / "modes.csv").write_text(MODES)


class Bodies(FolderTest):
    def test_meshes(self):
        """A picture of both, sections, a row a figure; nothing of speed and torque, which meshes do not have."""
        write_parameters(self.path, {**make_parameters(), "Study/kind": ("mesh", "")})
        (self.path / "mesh.csv").write_text(MESH)
        (self.path / "meridian.csv").write_text(MERIDIAN)
        pair = make_pair()
        write_vtu(self.path / "pair.vtu", Fields(pair.points, {"body": pair["body"]}, None))
        text = read_report(self.path)
        for picture in ("meshes.png", "meridian.svg"):
            self.assertTrue((self.path / "pictures" / picture).is_file(), picture)
        for words in ("27/79", ": mesh</h1>", "least scaled jacobian", "0.61235", "24 elements, 192 nodes, 1.75 kg"):
            self.assertIn(words, text)
        for words in ("20000 rpm", "800 N m"):
            self.assertNotIn(words, text)

    def test_faces(self):
        """Surfaces that the file has beside the cells are passed over."""
        points = make_ring(20, 30, 5, 12)
        n = len(points)
        cells = np.arange(8 * n).reshape(n, 8)
        meshio.Mesh(points.reshape(-1, 3), [("hexahedron", cells), ("quad", cells[:, :4])], {},
                    {"body": [np.zeros(n), np.zeros(n)]}).write(self.path / "pair.vtu")
        self.assertEqual(len(read_meshes(self.path / "pair.vtu")), n)

    def test_shapes(self):
        """Of each vibration one, at the lowest speed, without rigid motions."""
        write_parameters(self.path, {**make_parameters(), "Study/kind": ("modal", ""), "Fem/coriolis": ("no", "")})
        write_shapes(self.path)
        table = Table(self.path / "modes.csv")
        chosen = list_vibrations(table, np.arange(len(FREQUENCIES)))
        self.assertEqual([table["mode"][row] for row in chosen], [2, 4, 5])
        self.assertEqual([describe_vibration(table, row) for row in chosen],
                         ["2: 1000 Hz, 2 diameters", "4: 1500 Hz, 0 diameters", "5: 2000 Hz, 2 diameters, 1 circle"])
        picture = draw_mode_shapes(RunFolder(self.path), "gear")
        self.assertEqual([axes.get_title(loc="left") for axes in picture.axes if axes.images],
                         [describe_vibration(table, row) for row in chosen])
        # Two diameters: a quarter of the ring's way between crest and node.
        shown = picture.axes[0].images[0].get_array()
        self.assertGreater(np.ptp(shown[..., 0]), 0.5)
        text = read_report(self.path)
        self.assertTrue((self.path / "pictures" / "mode_shapes_gear.png").is_file())
        self.assertIn("omits Coriolis forces", text)
        self.assertNotIn("at 20000 rpm", text)


if __name__ == "__main__":
    unittest.main()
