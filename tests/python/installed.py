#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The package vfife imports from the folder where it is installed, and finds the program installed with it."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from python_test import BUILD, CMAKE  # first: ends the test without numpy

ASK = "import vfife; print(vfife.__file__); print(vfife.find_program())"


class Installed(unittest.TestCase):
    def test_import(self):
        with tempfile.TemporaryDirectory() as name:
            prefix = Path(name).resolve() / "prefix"
            subprocess.run([CMAKE, "--install", BUILD, "--prefix", prefix, "--component", "report"],
                           check=True, stdout=subprocess.DEVNULL)
            program = prefix / "bin" / "vfife"
            program.parent.mkdir()
            program.symlink_to("/bin/true")
            packages = prefix / "lib" / "python3" / "dist-packages"
            environment = {**os.environ, "PYTHONPATH": str(packages), "PYTHONDONTWRITEBYTECODE": "1"}
            del environment["VFIFE_PROGRAM"]
            said = subprocess.run([sys.executable, "-c", ASK], env=environment, check=True, cwd=name,
                                  stdout=subprocess.PIPE, text=True).stdout.splitlines()
            self.assertEqual(said, [str(packages / "vfife" / "__init__.py"), str(program)])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
