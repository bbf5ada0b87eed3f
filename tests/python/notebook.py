#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The cells of the notebooks in examples/ do what they say; each code cell is run in the order of the file."""
import os
import sys
import tempfile
import unittest
from pathlib import Path

from python_test import BUILD, ROOT  # first: makes the package importable

import numpy as np


def run_cells(test, name):
    """The names that the cells leave behind."""
    notebook = ROOT / "examples" / name
    cells = notebook.read_text(encoding="utf-8").split("\n# %%")[1:]
    code = [cell for cell in cells if not cell.startswith(" [markdown]")]
    test.assertGreater(len(code), 3)
    test.assertLess(len(code), len(cells))
    names = {"__file__": str(notebook)}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for cell in code:
                exec(compile("#" + cell, str(notebook), "exec"), names)  # pylint: disable=exec-used
            names["left"] = os.listdir(folder)
        finally:
            os.chdir("/")
    return names


class Notebooks(unittest.TestCase):
    """What the text beside the cells says."""

    def test_proposed_pair(self):
        names = run_cells(self, "proposed_pair.py")
        ratios = names["ratios"]
        self.assertTrue(all(one > other for one, other in zip(ratios, ratios[1:])), ratios)
        self.assertAlmostEqual(names["force"], names["expected"], delta=0.01 * names["expected"])

    def test_quieter_pair(self):
        module = Path(BUILD) / "python"
        if not list(module.glob("_vfife.*")):
            self.skipTest("the module _vfife is not built")
        sys.path.insert(0, str(module))
        names = run_cells(self, "quieter_pair.py")
        self.assertEqual(names["left"], [])
        self.assertTrue(np.all(np.diff(names["course"]) < 0))
        # on the file's own mesh, penalty and positions: three steps are needed, after two the ripple is 0.48 of the first
        self.assertLess(names["course"][-1], 0.4 * names["course"][0])
        ripples, ratios = ([figures["drive side, " + name].value for figures in names["unloaded"]]
                           for name in ("peak to peak", "contact ratio"))
        self.assertAlmostEqual(*ripples, delta=0.2)
        self.assertLess(ratios[0] + 0.1, ratios[1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
