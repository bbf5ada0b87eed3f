#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of studies without a motion: natural frequencies, loaded contact, bodies at rest, several analyses, comparisons."""
import json
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

from made_up_run import (  # first: ends the test without the libraries
    make_parameters, make_ring, quantity, read_report, write_parameters, write_run)

import meshio
import numpy as np

from vfife_report.data.fields import Fields
from vfife_report.data.run_folder import RunFolder
from vfife_report.pictures.scene import Scene
from vfife_report.data.study import Study
from vfife_report.plots.campbell import draw_campbell
from vfife_report.plots.curves import draw_curves

CAMPBELL = "body,nodal diameter [-],order [-],direction,speed [rpm],frequency [Hz]\n" + "".join(
    f"gear,2,1,forward,{speed},{1000 + 0.1 * speed}\n" for speed in (0, 3000, 6000, 9000))
RESONANCES = ("body,nodal diameter [-],order [-],wave,mesh order [-],speed [rpm],frequency [Hz]\n"
              "gear,2,1,backward,1,803,1080\ngear,2,1,forward,2,400,1040\n")
MODES = ("body,speed [rpm],mode [-],frequency [Hz],nodal diameter [-],nodal circles [-],direction,fixed frequency [Hz],whirl\n"
         + "".join(f"gear,0,{k},{1000 + k}.5,2,0,standing,nan,\n" for k in range(1, 31)))
COUPLED = ("axes,mode [-],frequency [Hz],share of the static turn [-],energy in the gear [-],nodal diameter of the gear [-],"
           "share of the diameter [-],axial [-],radial [-],tangential [-]\nstanding,1,1571.25,0.62,0.9,0,0.8,0.1,0.1,0.8\n")


class Studies(unittest.TestCase):
    def test_frequencies(self):
        """The lowest modes are a table; the diagram says whose speed it is over, where the pair works, and which line is which."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            write_parameters(folder, {**make_parameters(), "Study/kind": ("modal", "")})
            (folder / "modes.csv").write_text(MODES)
            (folder / "campbell.csv").write_text(CAMPBELL)
            (folder / "resonances.csv").write_text(RESONANCES)
            text = read_report(folder)
            self.assertIn("1001.5", text)
            self.assertIn("1012.5", text)
            self.assertNotIn("1013.5", text)
            self.assertIn("12 each of 30 rows of modes.csv", text)
            axes = draw_campbell(RunFolder(folder), "gear").axes[0]
            self.assertEqual(axes.get_xlabel(), "speed of the gear [rpm]")
            self.assertIn("operation, 6835 rpm", [line.get_label() for line in axes.lines])  # 20000 27/79
            # Lines are those of the orders themselves: 1080 Hz at 803 rpm is met two turns above, 1040 Hz at 400 rpm two below.
            for order, slope in ((1, 60 * 1.080 / 803 - 2 / 1000), (2, 60 * 1.040 / 400 + 2 / 1000)):
                line, = (line for line in axes.lines if line.get_gid() == f"mesh order {order}")
                self.assertAlmostEqual(line.get_ydata()[-1], slope / 60 * 9000 , places=9)
            axes.figure.canvas.draw()
            inside = axes.get_window_extent()
            self.assertEqual([one.get_text() for one in axes.texts], ["mesh order 1", "mesh order 2"])
            for one in axes.texts:
                self.assertFalse(one.get_window_extent().overlaps(inside), one.get_text())
            self.assertNotIn("whirl", text)

    def test_shapes_of_any_body(self):
        """No diameters, and no -1 for them, where a body has none; whirl where there is any."""
        for rows, shown, hidden in (("beam,0,1,412.5,-1,-1,standing,nan,-\n", ("412.5",), ("nodal", "\u22121", "whirl")),
                                    ("rotor,4000,1,52.5,1,0,backward,14.25,forward\n", ("nodal", "14.25", "whirl"), ())):
            with tempfile.TemporaryDirectory() as name:
                (Path(name) / "modes.csv").write_text(MODES.splitlines()[0] + "\n" + rows)
                text = read_report(name)
                for words in shown:
                    self.assertIn(words, text)
                for words in hidden:
                    self.assertNotIn(words, text)

    def test_loaded_contact(self):
        with tempfile.TemporaryDirectory() as name:
            (Path(name) / "coupled_modes.csv").write_text(COUPLED)
            text = read_report(name)
            for words in ("1571.2", "share of the static turn", "0.62"):
                self.assertIn(words, text)

    def test_at_rest(self):
        """Fields of single bodies, which no instant names."""
        with tempfile.TemporaryDirectory() as name:
            (Path(name) / "fields").mkdir()
            points = make_ring(20, 30, 5, 24)
            n = len(points)
            meshio.Mesh(points.reshape(-1, 3), [("hexahedron", np.arange(8 * n).reshape(n, 8))],
                        {"von mises": points[..., 0].ravel() ** 2}).write(Path(name) / "fields" / "ring.vtu")
            text = read_report(name)
            self.assertTrue((Path(name) / "pictures" / "bodies.png").is_file())
            self.assertEqual(text.count("<img "), 1)

    def test_instants(self):
        """Pictures say when they are of; the time of an equilibrium is a part of the load."""
        points = make_ring(20, 30, 5, 24)
        for study, time, said in (("run", 1e-3, "time 1.000 ms"), ("static", 1.0, "in equilibrium"), (None, None, "at rest")):
            run = SimpleNamespace(summary={"study": study} if study else {}, body_name=str)
            fields = Fields(points, {"body": np.zeros(points.shape[:2])}, time)
            self.assertEqual(Scene(run, fields).when(), said)

    def test_analyses(self):
        """Three loaded analyses with other offsets: their figures stand beside each other, and are curves."""
        with tempfile.TemporaryDirectory() as name:
            for number, offset in enumerate((0.0, 0.1, 0.2)):
                folder = Path(name) / f"run_{number + 1:02}"
                folder.mkdir()
                write_parameters(folder, {**make_parameters(), "Gear pair/Mounting/offset": (f"{offset}", "mm")})
                (folder / "figures.json").write_text(json.dumps(
                    {"transmission error mean": quantity(-80.25 - number, "arcsec"),
                     "transmission error peak to peak": quantity(8, "arcsec"),
                     **{f"stress {k}": quantity(100 + k, "MPa") for k in range(9)}}))
                (folder / "edge_contact.json").write_text(json.dumps(
                    {"edges carry": number == 1, "explanation": "edges"}))
            text = read_report(name)
            self.assertIn("Edges of the teeth carry: offset 0.1 mm.", text)
            curves = draw_curves(Study(Path(name)))
            # A mean of hundreds would flatten a peak to peak of eight; nine curves are more than there are colours.
            self.assertEqual([axes.get_title(loc="left") for axes in curves.axes],
                             ["transmission error, mean", "transmission error, ripple, peak to peak", ""])
            looks = [(line.get_color(), line.get_linestyle()) for line in curves.axes[2].lines]
            self.assertEqual(len(set(looks)), 9)
            for words in ("offset 0.1 mm", "transmission error mean", "\u221280.25", "\u221282.25", "finished"):
                self.assertIn(words, text)
            self.assertTrue((Path(name) / "pictures" / "curves.svg").is_file())

    def test_comparison(self):
        """What rows are compared with stands below them, and the run beside the static curve."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "run").mkdir()
            write_run(folder / "run", fields=False)
            (folder / "loaded").mkdir()
            (folder / "loaded" / "loaded_contact.csv").write_text(
                "position [mesh cycles],transmission error [arcsec]\n0,-80\n0.5,-81\n")
            row = {"quantity": "mean dte", "unit": "arcsec", "value": -84.0, "reference": -80.0, "reference kind": "FEM",
                   "difference": -4.0, "tolerance": 1.0, "verdict": "differs", "reason": "coarse mesh"}
            (folder / "comparison.json").write_text(json.dumps({"title": "t", "rows": [row]}))
            text = read_report(folder)
            self.assertIn('<tr class="note"><td colspan="8"><div>FEM: coarse mesh</div></td></tr>', text)
            self.assertNotIn("<th>why</th>", text)
            self.assertTrue((folder / "pictures" / "static_curve.svg").is_file())


if __name__ == "__main__":
    unittest.main()
