#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What vfife.gear computes inside Python is what the program writes into its files."""
import multiprocessing
import os
import sys
import tempfile
import threading
import unittest
import unittest.mock
from pathlib import Path

from python_test import BUILD, ROOT  # first: makes the package importable

import numpy as np

import vfife
from vfife import gear
from vfife.extension import NAME, load_extension

BUILT = Path(BUILD) / "python"
PROPOSED = ROOT / "prm/gear/proposed_17_43.prm"
# Meshes as coarse as they go: both sides of a comparison have the same one.
COARSE = """
subsection Gear pair
  subsection Pinion
    subsection Mesh
      set elements along face width = 2
      set elements across tooth = 2
      set elements along profile = 2
      set elements through rim = 2
    end
  end
  subsection Gear
    subsection Body
      set body type = rim only
    end
    subsection Mesh
      set elements along face width = 2
      set elements across tooth = 2
      set elements along profile = 2
      set elements through rim = 2
    end
  end
end
"""
LOADED = """
include {file}
""" + COARSE + """
subsection Operation
  set speed  = 12000 rpm
  set torque = 350 N m
end
subsection Loaded contact
  set positions = 2
end
"""


def figures_of(summary):
    """All but those of the process that computes: its memory, its ranks, its time."""
    return {name: value for name, value in summary.items() if not name.startswith("run/")}


def compute_in_copy(queue):
    """In a process that is a copy of one that has computed."""
    try:
        gear.Pair(PROPOSED).unloaded()
        queue.put("computed")
    except vfife.VfifeError as error:
        queue.put(str(error))


class Values(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_tables(self, analysis, result, tolerance):
        """All tables that the program writes, with their units and values; all figures."""
        self.assertEqual(analysis.tables, result.tables)
        for name in result.tables:
            found, written = analysis.table(name), result.table(name)
            self.assertEqual(list(found.columns), list(written.columns))
            self.assertEqual(found.units, written.units)
            for column in written.columns:
                with self.subTest(table=name, column=column):
                    if written[column].dtype.kind == "f" and found[column].dtype.kind == "f":
                        scale = np.nanmax(np.abs(written[column]), initial=0)
                        np.testing.assert_allclose(found[column], written[column], rtol=0, atol=tolerance * scale)
                    else:
                        self.assertEqual(list(map(str, found[column])), list(map(str, written[column])))
        figures = result.summary
        self.assertEqual(analysis.summary.keys(), figures.keys())
        for name, figure in figures.items():
            self.assertEqual(analysis.summary[name].unit, figure.unit)

    def test_unloaded(self):
        """Also of a pair with unequal teeth, whose file names another file beside it."""
        for file in (PROPOSED, ROOT / "prm/errors/pitch_error.prm"):
            result = vfife.Case(file).set("Output/report", False).run(output=self.folder / file.stem)
            analysis = gear.Pair(file).unloaded()
            self.assert_tables(analysis, result, 0)
            self.assertEqual(figures_of(analysis.summary), figures_of(result.summary))
            self.assertEqual(analysis.json("tca"), result.json("tca"))
            self.assertEqual(analysis.texts["pair.prm"], (result.path / "pair.prm").read_text(encoding="utf-8"))
            log = (result.path / "run.log").read_text(encoding="utf-8")
            self.assertIn("contact ratio", analysis.log)
            self.assertIn(analysis.log, log)

    def test_loaded(self):
        text = LOADED.format(file=PROPOSED)
        file = self.folder / "loaded.prm"
        file.write_text(text, encoding="utf-8")
        case = vfife.Case(file).set("Study/kind", "loaded tooth contact analysis").set("Output/report", False)
        result = case.run(output=self.folder / "loaded")
        analysis = gear.Pair.from_text(text).loaded()
        # residuals and iterations are round-off's own; so is BLAS, whose threads are Python's here
        for name in ("residual", "iterations"):
            self.assertIn(name, analysis.table("loaded_contact"))
        analysis.table("loaded_contact").columns["residual"] = result.table("loaded_contact")["residual"]
        self.assert_tables(analysis, result, 1e-7)
        torque = analysis.table("loaded_contact")["contact torque on the gear"]
        np.testing.assert_allclose(torque, 350, rtol=1e-6)

    def test_flank_points(self):
        file = self.folder / "mesh.prm"
        file.write_text(f"include {PROPOSED}\n{COARSE}", encoding="utf-8")
        case = vfife.Case(file).set("Study/kind", "mesh").set("Output/report", False)
        case = case.set("Export/flank points lengthwise", 4).set("Export/flank points profile", 3)
        result = case.run(output=self.folder / "mesh")
        for member in ("pinion", "gear"):
            table = result.table(f"flank_points_{member}")
            flanks = gear.Pair(PROPOSED).flank_points(member, lengthwise=4, profile=3)
            for side, flank in flanks.items():
                rows = table["side"] == side
                self.assertEqual(flank.points.shape, (4, 3, 3))
                np.testing.assert_array_equal(flank.L.ravel(), table["L"][rows])
                np.testing.assert_array_equal(flank.h.ravel(), table["h"][rows])
                for axis, name in enumerate("xyz"):
                    np.testing.assert_array_equal(flank.points[..., axis].ravel(), table[name][rows])
                    np.testing.assert_array_equal(flank.normals[..., axis].ravel(), table[f"normal {name}"][rows])

    def test_normals(self):
        """Across both directions of the grid, by differences of finer and finer grids."""
        errors = []
        for n in (9, 17):
            flank = gear.Pair(PROPOSED).flank_points("gear", n, n)["convex"]
            middle = n // 2
            along = flank.points[middle + 1, middle] - flank.points[middle - 1, middle]
            up = flank.points[middle, middle + 1] - flank.points[middle, middle - 1]
            normal = np.cross(along, up)
            normal /= np.linalg.norm(normal)
            errors.append(1 - abs(normal @ flank.normals[middle, middle]))
        self.assertLess(errors[0], 1e-4)
        self.assertLess(errors[1], errors[0] / 8)  # of fourth order: the square of a second-order angle


class Texts(unittest.TestCase):
    def test_folder(self):
        """A text stands for a file: what it includes is beside it."""
        text = "include proposed_17_43.prm\n"
        here = gear.Pair.from_text(text, PROPOSED.with_name("none.prm"))
        self.assertEqual(figures_of(here.unloaded().summary), figures_of(gear.Pair(PROPOSED).unloaded().summary))
        with self.assertRaisesRegex(vfife.InputError, '^text:1: the parameter file "proposed_17_43.prm" cannot be read'):
            gear.Pair.from_text(text).unloaded()

    def test_set(self):
        base = gear.Pair(PROPOSED)
        other = base.set("Gear pair/Proposal/module", 5)
        size = [np.abs(pair.flank_points("gear")["convex"].points).max() for pair in (base, other)]
        self.assertAlmostEqual(size[1] / size[0], 1.25, delta=0.01)
        self.assertEqual(base.settings, {})
        same = gear.Pair(vfife.Case(PROPOSED).set("Gear pair/Proposal/module", 5))
        self.assertEqual(same.settings, other.settings)


class Refusals(unittest.TestCase):
    def test_input(self):
        pair = gear.Pair(PROPOSED)
        for call in (pair.set("Gear pair/Proposal/modul", 4).unloaded, lambda: pair.set("Gear pair/Proposal/modul", 4).flank_points("gear")):
            with self.assertRaises(vfife.InputError) as caught:
                call()
            self.assertRegex(str(caught.exception), '^--set "Gear pair/Proposal/modul=4": .* did you mean "module"[?]$')
        with self.assertRaisesRegex(vfife.InputError, "^text:2: '=' is missing"):
            gear.Pair.from_text("subsection Gear pair\n set module 4\nend").unloaded()
        with self.assertRaisesRegex(vfife.InputError, "at least 2 along the tooth"):
            pair.flank_points("gear", lengthwise=1)
        self.assertRaises(ValueError, pair.flank_points, "wheel")

    def test_copy(self):
        """A copy of a process with MPI must not use it: said, not waited for."""
        gear.Pair(PROPOSED).unloaded()
        context = multiprocessing.get_context("fork")
        queue = context.SimpleQueue()
        process = context.Process(target=compute_in_copy, args=(queue,))
        process.start()
        process.join(60)
        self.assertIn('by the method "spawn"', queue.get())

    def test_missing(self):
        """A folder without the module is named, with what it is built of."""
        module = sys.modules.pop(NAME)
        folders, sys.path[:] = sys.path[:], [path for path in sys.path if path != str(BUILT)]
        try:
            with unittest.mock.patch("vfife.extension.list_folders", lambda: [Path("/nowhere")]):
                with self.assertRaisesRegex(vfife.VfifeError, "/nowhere.*pybind11-dev"):
                    load_extension()
        finally:
            sys.path[:] = folders
            sys.modules[NAME] = module


class Lock(unittest.TestCase):
    def test_threads(self):
        """Others go on while it computes; two threads that compute get what one gets."""
        pair, found = gear.Pair(PROPOSED), []
        expected = figures_of(pair.unloaded().summary)
        threads = [threading.Thread(target=lambda: found.append(figures_of(pair.unloaded().summary))) for _ in range(2)]
        for thread in threads:
            thread.start()
        turns = 0
        while any(thread.is_alive() for thread in threads):
            turns += 1
        for thread in threads:
            thread.join()
        self.assertEqual(found, [expected, expected])
        # with the lock held all the time this thread would have had a turn or two
        self.assertGreater(turns, 1000)


if __name__ == "__main__":
    if not list(BUILT.glob(f"{NAME}.*")):
        print("skipped: the module is not built")
        sys.exit(77)
    sys.path.insert(0, str(BUILT))
    os.environ.pop("PYTHONPATH", None)
    unittest.main(argv=sys.argv[:1])
