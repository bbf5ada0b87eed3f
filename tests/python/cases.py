#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases, results and failures of the package vfife."""
import importlib.util
import json
import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from python_test import PROGRAM, ROOT  # first: makes the package importable

import numpy as np

import vfife
from vfife.program import find_message

BARS = vfife.Case(ROOT / "prm/verification/two_bars.prm").set("Output/report", False)
PAIR = vfife.Case(ROOT / "prm/gear/proposed_17_43.prm").set("Output/report", False)
PLATE = vfife.Case(ROOT / "prm/verification/plate_with_hole.prm").set("Output/report", False)


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class Values(unittest.TestCase):
    def test_numpy(self):
        """Values of numpy are written as those of Python."""
        for value, text in ((np.bool_(False), "no"), (np.array([0., 0., 10.]), "0.0, 0.0, 10.0"), (np.float32(.5), "0.5"),
                            (np.int64(3), "3"), (np.array(2.5), "2.5"), (np.array([True, False]), "yes, no"),
                            ([np.bool_(True), np.float64(.1)], "yes, 0.1"), (np.array(["a", "b"]), "a, b")):
            self.assertEqual(BARS.set("Section/entry", value).settings["Section/entry"], text)


class Runs(Folder):
    def test_run(self):
        """Two bars exchange their velocities: the force is A rho c v/2 = 1005.3 N, the contact 2 L/c = 39.04 us long."""
        result = BARS.run(output=self.folder / "bars")
        self.assertEqual(result.status, "finished")
        self.assertEqual(result.history.units["time"], "s")
        time, force = result.history["time"], result.history["contact force total"]
        self.assertIsInstance(force, np.ndarray)
        middle = (time > 10e-6) & (time < 30e-6)
        self.assertAlmostEqual(force[middle].mean(), 1005.3, delta=10)
        steps = result.json("summary")["run"]["steps"]
        self.assertEqual(len(time), steps + 1)
        self.assertEqual(result.summary["energy/start"].unit, "mJ")
        self.assertAlmostEqual(result.summary["energy/start"].value, 39.25, places=6)
        self.assertEqual(result.parameters["Dynamics/end time"], "80 us")

    def test_loop(self):
        """A larger pressure angle makes the path of contact shorter; the base stays what it was."""
        ratios = []
        for angle in (25, np.float64(17.5)):
            result = PAIR.set("Gear pair/Proposal/pressure angle", angle).run(output=self.folder / f"{angle:g}")
            ratios.append(result.summary["drive side, contact ratio"])
        self.assertEqual(ratios[0].unit, "-")
        self.assertLess(ratios[0].value + 0.05, ratios[1].value)
        self.assertEqual(PAIR.settings, {"Output/report": "no"})
        self.assertIn("path", result.tables)
        self.assertEqual(set(result.table("path")["side"]), {"drive", "coast"})

    def test_ranks_and_fields(self):
        result = PLATE.run(output=self.folder / "plate", ranks=2)
        if importlib.util.find_spec("meshio"):
            fields = result.fields()
            self.assertEqual(fields.points.shape, (480, 8, 3))
            # at the hole 3 to 4 times the nominal stress of 10 MPa
            self.assertTrue(30 < fields["von mises"].max() < 40)

    def test_own_folder(self):
        """Without `output` results go where the file says."""
        result = PAIR.set("Study/output folder", self.folder / "own").run()
        self.assertEqual(result.path, self.folder / "own")

    def test_frame(self):
        result = PAIR.run(output=self.folder / "pair")
        if importlib.util.find_spec("pandas"):
            frame = result.frame("transmission")
            self.assertEqual(frame.attrs["units"]["transmission error"], "arcsec")
        else:
            self.assertRaises(ImportError, result.frame, "transmission")

    def test_restart(self):
        short = BARS.set("Dynamics/maximum number of steps", 100)
        self.assertEqual(short.run(output=self.folder).json("summary")["run"]["steps"], 100)
        longer = BARS.set("Dynamics/maximum number of steps", 150).run(output=self.folder, restart=True)
        self.assertEqual(longer.json("summary")["run"]["steps"], 150)


class FormerNames(Folder):
    """Results of the previous version, whose names of the present version differ."""

    def setUp(self):
        super().setUp()
        (self.folder / "history.csv").write_text("time [s],taken by the driven speed damping [mJ]\n0,0\n1e-5,3\n")
        (self.folder / "wave_response.csv").write_text("direction,speed [rpm],running wave 4 [um]\nup,1000,2\n")
        (self.folder / "differences.csv").write_text(
            "quantity,verdict\nnode A median of a turn,told apart\nswing frequency,not told apart\n")
        frequency = {"value": 1400.0, "unit": "Hz"}
        (self.folder / "summary.json").write_text(json.dumps({
            "status": "finished", "figures": {"swing frequency, estimated": frequency, "torque over effective arm at the start": frequency},
            "energy": {"taken by the driven speed damping from the swing": frequency}, "contradictions": ["a text"],
            "probes": {"arm": {"median of a turn": {"value": 46.0, "unit": "MPa"}}}}))
        self.result = vfife.Result(self.folder)

    def test_tables(self):
        history = self.result.history
        self.assertEqual(list(history.columns), ["time", "removed by the driven speed damping"])
        for name in ("removed by the driven speed damping", "taken by the driven speed damping"):
            self.assertIn(name, history)
            self.assertEqual(list(history[name]), [0, 3])
            self.assertEqual(history.units[name], "mJ")
        self.assertNotIn("taken by", history)
        self.assertEqual(self.result.table("wave_response")["travelling wave 4"][0], 2)
        differences = self.result.table("differences")
        self.assertEqual(list(differences["quantity"]), ["node A median per revolution", "torsional mode frequency"])
        self.assertEqual(list(differences["verdict"]), ["significant", "not significant"])

    def test_places(self):
        summary = self.result.json("summary")
        for name in ("input conflicts", "contradictions"):
            self.assertEqual(summary[name], ["a text"])
            self.assertEqual(summary.get(name), ["a text"])
        self.assertIsNone(summary.get("swing"))
        self.assertRaises(KeyError, summary.__getitem__, "swing")
        # Other files have a lever arm.
        self.assertEqual(summary["probes"]["arm"]["median per revolution"]["value"], 46)

    def test_quantities(self):
        """By both names; listed by the present one."""
        found = self.result.summary
        for name in ("torsional mode frequency, estimated", "swing frequency, estimated", "torque over effective arm at the start",
                     "torque over effective lever arm at the start", "energy/taken by the driven speed damping from the swing",
                     "energy/removed by the driven speed damping from the torsional mode"):
            self.assertEqual(found[name].value, 1400, name)
        self.assertEqual(len(found), 4)
        self.assertNotIn("swing frequency, estimated", list(found))


class Questions(unittest.TestCase):
    def test_parameters(self):
        parameters = PAIR.set("Gear pair/Proposal/module", 4.5).set("Gear pair/Proposal/face width", "0.025 m").parameters()
        self.assertEqual(parameters["Gear pair/Proposal/module"], "4.5 mm")
        self.assertEqual(parameters["Gear pair/Proposal/face width"], "0.025 m")
        self.assertEqual(parameters["Gear pair/Proposal/spiral angle"], "35 deg")

    def test_check(self):
        found = BARS.check()
        self.assertIn("400 elements", found.text)
        self.assertEqual(found.input_conflicts, ())
        self.assertEqual(found.contradictions, ())  # the former name


class Failures(Folder):
    def test_input(self):
        with self.assertRaises(vfife.InputError) as caught:
            PAIR.set("Gear pair/Proposal/modul", 4).run(output=self.folder / "none")
        self.assertRegex(str(caught.exception), '^--set "Gear pair/Proposal/modul=4": .* did you mean "module"[?]$')
        self.assertFalse((self.folder / "none").exists())
        with self.assertRaisesRegex(vfife.InputError, "no_such_file"):
            vfife.Case("no_such_file.prm").check()

    def test_input_on_ranks(self):
        """The message is the program's alone, without what mpirun adds."""
        with self.assertRaises(vfife.InputError) as caught:
            PAIR.set("Gear pair/Proposal/modul", 4).run(output=self.folder / "none", ranks=2)
        self.assertRegex(str(caught.exception), '^--set "Gear pair/Proposal/modul=4": .* did you mean "module"[?]$')

    def test_no_temporary_folder(self):
        """It is the machine and not the input, whoever starts MPI."""
        for ranks in (1, 2):
            with mock.patch.dict(os.environ, TMPDIR="/proc/none"), \
                    self.assertRaisesRegex(vfife.ComputationFailed, 'temporary files "/proc/none"'):
                BARS.run(output=self.folder / "none", ranks=ranks)

    def test_message(self):
        """What mpirun adds, Open MPI 5 always, is no part of it."""
        said = "a word\nvfife: file.prm:3: wrong\n  and more\n"
        for note in ("", 74 * "-" + "\nprterun detected that one or more processes exited with non-zero status\n"):
            self.assertEqual(find_message(said + note), "file.prm:3: wrong\n  and more")

    def test_computation(self):
        with self.assertRaisesRegex(vfife.ComputationFailed, "not reached in 50 relaxation steps") as caught:
            PLATE.set("Dynamics/Relaxation/maximum number of steps", 50).run(output=self.folder / "plate")
        self.assertEqual(caught.exception.result.status, "failed")
        self.assertIn("history", caught.exception.result.tables)
        self.assertNotIsInstance(caught.exception, vfife.Stopped)

    def test_missing_file(self):
        (self.folder / "path.csv").write_text("a [mm]\n1\n", encoding="utf-8")
        result = vfife.Result(self.folder)
        with self.assertRaisesRegex(FileNotFoundError, "has no history.csv; of these files there are: path.csv"):
            _ = result.history
        self.assertRaises(FileNotFoundError, vfife.Result, self.folder / "nowhere")

    def test_damaged(self):
        (self.folder / "summary.json").write_text("{", encoding="utf-8")
        with self.assertRaisesRegex(vfife.DamagedFile, "summary.json:1:2"):
            _ = vfife.Result(self.folder).summary


class Programs(Folder):
    def test_order(self):
        """The argument, the environment, the tree; what is named and is none is said."""
        self.assertEqual(vfife.find_program("/bin/true"), Path("/bin/true"))
        self.assertEqual(vfife.find_program(), Path(PROGRAM))
        self.assertRaisesRegex(vfife.ProgramNotFound, "/nowhere/vfife", vfife.find_program, "/nowhere/vfife")
        with mock.patch.dict(os.environ, VFIFE_PROGRAM="/nowhere/vfife"):
            self.assertRaisesRegex(vfife.ProgramNotFound, "VFIFE_PROGRAM names /nowhere/vfife", vfife.find_program)

    def test_path(self):
        own = self.folder / "vfife"
        own.symlink_to("/bin/true")
        with mock.patch.dict(os.environ, PATH=str(self.folder)), mock.patch("vfife.program.TREE", self.folder / "a"), \
                mock.patch("vfife.program.PREFIX", self.folder / "b"):
            del os.environ["VFIFE_PROGRAM"]
            self.assertEqual(vfife.find_program(), own)
            own.unlink()
            self.assertRaisesRegex(vfife.ProgramNotFound, "built in the tree.*installed with.*PATH", vfife.find_program)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
