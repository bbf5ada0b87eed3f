#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of studies without a motion: natural frequencies, loaded contact, bodies at rest, several analyses, comparisons."""
import json
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

from made_up_run import (  # first: ends the test without the libraries
    FolderTest, make_parameters, make_ring, quantity, read_report, write_parameters, write_run)

import meshio
import numpy as np

from vfife_report.data.fields import Fields
from vfife_report.data.run_folder import RunFolder
from vfife_report.pictures.scene import Scene
from vfife_report.data.study import Study
from vfife_report.measures.accuracy import AT_CORNERS, FREQUENCY_ERROR, LINEAR_ERRORS, NO_ESTIMATE, VARIANTS_PAGE
from vfife_report.measures.main_results import list_main_results
from vfife_report.measures.study_results import list_farthest, list_ranges
from vfife_report.measures.trust import list_study_trust, list_trust
from vfife_report.plots.campbell import draw_campbell
from vfife_report.plots.curves import draw_curves

CAMPBELL = "body,nodal diameter [-],order [-],direction,speed [rpm],frequency [Hz]\n" + "".join(
    f"gear,2,1,forward,{speed},{1000 + 0.1 * speed}\n" for speed in (0, 3000, 6000, 9000))
RESONANCES = ("body,nodal diameter [-],order [-],wave,mesh order [-],speed [rpm],frequency [Hz]\n"
              "gear,2,1,backward,1,803,1080\ngear,2,1,forward,2,400,1040\n")
MODES = ("body,speed [rpm],mode [-],frequency [Hz],nodal diameter [-],nodal circles [-],direction,fixed frequency [Hz],whirl\n"
         + "".join(f"gear,0,{k},{1000 + k}.5,2,0,standing,nan,\n" for k in range(1, 31)))
COUPLED = ("axes,mode [-],frequency [Hz],share of the static rotation [-],energy in the gear [-],nodal diameter of the gear [-],"
           "share of the diameter [-],axial [-],radial [-],tangential [-]\nstanding,1,1571.25,0.62,0.9,0,0.8,0.1,0.1,0.8\n")


class Studies(FolderTest):
    def test_frequencies(self):
        """The lowest modes are a table; the diagram says whose speed it is over, where the pair works, and which line is which."""
        write_parameters(self.path, {**make_parameters(), "Study/kind": ("modal", "")})
        (self.path / "modes.csv").write_text(MODES)
        (self.path / "campbell.csv").write_text(CAMPBELL)
        (self.path / "resonances.csv").write_text(RESONANCES)
        text = read_report(self.path)
        self.assertIn("1001.5", text)
        self.assertIn("1012.5", text)
        self.assertNotIn("1013.5", text)
        self.assertIn("12 of 30 rows of modes.csv", text)
        axes = draw_campbell(RunFolder(self.path), "gear").axes[0]
        self.assertEqual(axes.get_xlabel(), "speed of the gear [rpm]")
        self.assertIn("operating speed, 6835 rpm", [line.get_label() for line in axes.lines])  # 20000 27/79
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
        (self.path / "coupled_modes.csv").write_text(COUPLED)
        text = read_report(self.path)
        for words in ("1571.2", "share of the static rotation", "0.62"):
            self.assertIn(words, text)

    def test_at_rest(self):
        """Fields of single bodies, which no instant names."""
        (self.path / "fields").mkdir()
        points = make_ring(20, 30, 5, 24)
        n = len(points)
        meshio.Mesh(points.reshape(-1, 3), [("hexahedron", np.arange(8 * n).reshape(n, 8))],
                    {"von mises": points[..., 0].ravel() ** 2}).write(self.path / "fields" / "ring.vtu")
        text = read_report(self.path)
        self.assertTrue((self.path / "pictures" / "bodies.png").is_file())
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
        for number, offset in enumerate((0.0, 0.1, 0.2)):
            folder = self.path / f"run_{number + 1:02}"
            folder.mkdir()
            write_parameters(folder, {**make_parameters(), "Gear pair/Mounting/offset": (f"{offset}", "mm")})
            (folder / "figures.json").write_text(json.dumps(
                {"transmission error mean": quantity(-80.25 - number, "arcsec"),
                 "transmission error peak to peak": quantity(8, "arcsec"),
                 **{f"stress {k}": quantity(100 + k, "MPa") for k in range(9)}}))
            (folder / "edge_contact.json").write_text(json.dumps(
                {"edge contact": number == 1, "explanation": "edges"}))
        text = read_report(self.path)
        self.assertIn("These variants have edge contact: offset 0.1 mm.", text)
        curves = draw_curves(Study(self.path))
        # A mean of hundreds would flatten a peak to peak of eight; nine curves are more than there are colours.
        self.assertEqual([axes.get_title(loc="left") for axes in curves.axes],
                         ["transmission error, mean", "transmission error, oscillation, peak to peak", ""])
        looks = [(line.get_color(), line.get_linestyle()) for line in curves.axes[2].lines]
        self.assertEqual(len(set(looks)), 9)
        for words in ("offset 0.1 mm", "transmission error mean", "\u221280.25", "\u221282.25", "finished"):
            self.assertIn(words, text)
        self.assertTrue((self.path / "pictures" / "curves.svg").is_file())

    def test_comparison(self):
        """What rows are compared with stands below them, and the run beside the static curve."""
        (self.path / "run").mkdir()
        write_run(self.path / "run", fields=False)
        (self.path / "loaded").mkdir()
        (self.path / "loaded" / "loaded_contact.csv").write_text(
            "position [mesh cycles],transmission error [arcsec]\n0,-80\n0.5,-81\n")
        row = {"quantity": "mean dte", "unit": "arcsec", "value": -84.0, "reference": -80.0, "reference kind": "FEM",
               "difference": -4.0, "tolerance": 1.0, "verdict": "differs", "reason": "coarse mesh"}
        (self.path / "comparison.json").write_text(json.dumps({"title": "t", "rows": [row]}))
        text = read_report(self.path)
        self.assertIn('<tr class="note"><td colspan="8"><div>FEM: coarse mesh</div></td></tr>', text)
        self.assertNotIn("<th>why</th>", text)
        self.assertTrue((self.path / "pictures" / "static_curve.svg").is_file())


class Results(FolderTest):
    """The first chapter of each kind has at most five results, each with its accuracy or the reason why none is known; the chapter
    about trust has a row for the kind."""

    def read(self, files, parameters=None):
        """Rows of the first table, rows of the chapter about trust, and the page."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            if parameters:
                write_parameters(folder, parameters)
            for file, content in files.items():
                (folder / file).write_text(content if isinstance(content, str) else json.dumps(content))
            run = RunFolder(folder)
            text = read_report(folder)
            self.assertIn(">Results</h2>", text)
            self.assertIn(">Accuracy and validity</h2>", text)
            rows = list_main_results(run)
            self.assertLessEqual(len(rows), 5)
            self.assertTrue(rows and all(accuracy for *_, accuracy in rows))
            first = text[text.index(">Results</h2>"):].partition("</table>")[0]
            for result, *_ in rows:
                self.assertIn(f"<td>{result}</td>", first.replace(' class="long"', ""))
            return rows, list_trust(run), text

    def test_modal(self):
        """Rigid motions are no results; an error is stated for gears only."""
        rows, trust, text = self.read({"modes.csv": MODES + "gear,0,31,0.001,-1,-1,standing,nan,-\n"})
        self.assertEqual(rows[0], ["frequency 1 of gear, 2 nodal diameters", 1001.5, "Hz", NO_ESTIMATE])
        self.assertNotIn(0.001, [row[1] for row in rows])
        self.assertIn(VARIANTS_PAGE, text)
        rows, _, _ = self.read({"modes.csv": MODES}, make_parameters())
        self.assertEqual(rows[0][-1], FREQUENCY_ERROR[1])
        self.assertEqual(trust[0][0], "natural frequencies")

    def test_model(self):
        """A refinement states its last change; other results have no error estimate."""
        rows, trust, text = self.read({
            "summary.json": {"study": "linear static", "figures": {"largest von mises": quantity(36.5, "MPa")}},
            "adaptive_refinement.csv": "step [-],elements [-],unknowns [-],error indicator [mm^1.5],result,value [as named],change [%]\n"
                                       "0,480,1,1e-6,beside von mises [MPa],35.93,nan\n1,634,2,1e-6,beside von mises [MPa],35.92,-0.0251\n"})
        self.assertEqual(rows, [["beside von mises", 35.92, "MPa", "changes by 0.025 % in the last refinement"],
                                ["largest von Mises stress", 36.5, "MPa", f"{AT_CORNERS}; {NO_ESTIMATE}"]])
        self.assertEqual(len(trust), 3)
        self.assertIn("explains how to compare two meshes.", text)

    def test_speeds(self):
        """A lumped model states its given stiffness, a reduced pair the distance of its speeds."""
        response = ("direction,speed [rpm],peak to peak dte [arcsec],largest force [N]\n"
                    + "".join(f"up,{speed},{size},{1000 * size}\n" for speed, size in ((1000, 2), (1500, 5), (2000, 3))))
        model = {"model": {"gear inertia": quantity(1, "kg mm^2")}, "modes": [], "response": {
            "speed": quantity(900, "rpm"), "peak to peak dte": quantity(0.5, "arcsec")},
            "sweep": {"largest peak to peak dte": quantity(5, "arcsec"), "at the speed": quantity(1500, "rpm")}}
        lumped = "time [s],position [mesh cycles],dte [arcsec],mesh force [N],contact torque on the gear [N m]\n0,0,1,1,1\n1,1,1,1,1\n"
        for mode in ([], [{"frequency [Hz]": 1411.3, "damping ratio [-]": 0.03,
                           "critical pinion speeds of mesh orders 1, 2, 3 [rpm]": [3136, 1568, 1045]}]):
            rows, _, _ = self.read({"lumped.json": {**model, "modes": mode}, "lumped.csv": lumped, "resonance.csv": response})
            self.assertEqual(rows[0][:3], ["largest transmission error, peak to peak, at 1500 rpm", 5, "arcsec"])
            self.assertIn("speeds are 500 rpm apart", rows[0][3])
            self.assertEqual(len(rows), 2 + len(mode))
        rows, _, _ = self.read({"resonance.csv": response, "wave_response.csv": "direction,speed [rpm],travelling wave 1 [um]\nup,1000,1\n"})
        self.assertEqual(rows[1], ["largest contact force, at 1500 rpm", 5000, "N", f"speeds are 500 rpm apart; {NO_ESTIMATE}"])

    def test_waves(self):
        """The largest wave first; a computed peak beside linear theory."""
        header = ("wave,nodal diameter [-],order [-],mesh order [-],solver,speed [rpm],frequency [Hz],damping ratio [-],"
                  "speed in contact [rpm],mesh frequency [Hz],predicted width [-],predicted amplitude [um],peak speed [rpm],amplitude [um],"
                  "width [-],damping ratio of the width [-],damping ratio of the build-up [-],stress amplification [-]\n")
        small, large = "backward,4,1,1,none,7750,3660,0.01,7800,3510,0.02,4.8,", "forward,4,1,1,none,8569,3660,0.01,8627,3882,0.02,9.5,"
        frequencies = ("wave,nodal diameter [-],order [-],speed [rpm],fixed frequency [Hz]\n" + "".join(
            f"forward,4,1,{speed},3600\n" for speed in (0, 12000)))
        rows, trust, _ = self.read({"waves_lines.csv": header + f"{small}{','.join(['nan'] * 6)}\n{large}{','.join(['nan'] * 6)}\n",
                                    "waves_frequencies.csv": frequencies})
        self.assertEqual(rows[0], ["resonance speed, wave of 4 diameters, forward, mesh order 1", 8627, "rpm", LINEAR_ERRORS[3]])
        self.assertEqual([row[0].partition(",")[0] for row in rows[2:]], ["half-power width", "amplitude of the rim"])
        self.assertEqual(trust[0][1], "")
        rows, trust, _ = self.read({"waves_lines.csv": header + large + "8640,9.6,0.021,0.01,0.01,1.2\n", "waves_frequencies.csv": frequencies})
        self.assertEqual(rows[0][1:], [8640, "rpm", f"fitted peak; 8627 rpm by linear theory; {NO_ESTIMATE}"])
        self.assertEqual([row[1] for row in rows[1:]], [2.1, 9.6, 1.2])
        self.assertEqual(trust[0][1], "given decay times to settle")

    def test_variants(self):
        """Ranges over the variants; without error bars the page says how to get them."""
        for thickness in ("5", "3.5"):
            (self.path / thickness).mkdir()
            write_run(self.path / thickness, thickness, fields=False)
        text = read_report(self.path)
        study = Study(self.path)
        (mean, *_) = list_ranges(study)
        self.assertEqual(mean[0], "transmission error, mean")
        self.assertEqual(mean[1:4:2], [-80, -80])
        self.assertEqual([row[0] for row in list_study_trust(study)],
                         ["means of the variants", "peak to peak of the variants", "differences between variants"])
        first = text[text.index(">Results</h2>"):]
        self.assertLess(first.index("transmission error, mean"), first.index(">The variants</h2>"))
        self.assertIn("Differences between variants have no error estimate.", first)
        self.assertIn(">Accuracy and validity</h2>", text)

    def test_farthest(self):
        """The row with the largest difference over its tolerance is the first."""
        row = {"unit": "N", "reference kind": "FEM", "reason": "", "reference": 100.0}
        rows = [{**row, "quantity": name, "value": 100.0 + difference, "difference": difference, "tolerance": 1.0, "verdict": verdict}
                for name, difference, verdict in (("near", 0.1, "agrees"), ("far", -2.0, "differs"), ("open", 9.0, "not judged"))]
        self.assertEqual([one[0] for one in list_farthest(rows)], ["far", "near", "open"])


if __name__ == "__main__":
    unittest.main()
