#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The cells of examples/proposed_pair.py do what they say; each code cell is run in the order of the file."""
import os
import sys
import tempfile
import unittest

from python_test import ROOT  # first: makes the package importable

NOTEBOOK = ROOT / "examples" / "proposed_pair.py"


class Notebook(unittest.TestCase):
    def test_cells(self):
        text = NOTEBOOK.read_text(encoding="utf-8")
        cells = text.split("\n# %%")[1:]
        code = [cell for cell in cells if not cell.startswith(" [markdown]")]
        self.assertGreater(len(code), 3)
        self.assertLess(len(code), len(cells))
        names = {"__file__": str(NOTEBOOK)}
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for cell in code:
                    exec(compile("#" + cell, str(NOTEBOOK), "exec"), names)  # pylint: disable=exec-used
            finally:
                os.chdir("/")
        # what the text beside the cells says
        ratios = names["ratios"]
        self.assertTrue(all(one > other for one, other in zip(ratios, ratios[1:])), ratios)
        self.assertAlmostEqual(names["force"], names["expected"], delta=0.01 * names["expected"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
