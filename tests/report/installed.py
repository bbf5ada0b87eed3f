#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as it is installed, templates included: installed.py CMAKE BUILD_FOLDER."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from made_up_run import write_run  # first: ends the test without the libraries

CMAKE, BUILD = sys.argv[1:]


class Installed(unittest.TestCase):
    def test_report(self):
        with tempfile.TemporaryDirectory() as name:
            prefix, run = Path(name) / "prefix", Path(name) / "run"
            subprocess.run([CMAKE, "--install", BUILD, "--prefix", prefix, "--component", "report"],
                           check=True, stdout=subprocess.DEVNULL)
            run.mkdir()
            write_run(run, fields=False)
            (script,) = prefix.rglob("make_report.py")
            subprocess.run([sys.executable, "-B", script, run], check=True)
            text = (run / "report.html").read_text(encoding="utf-8")
            for chapter in ("Key figures", "Words"):
                self.assertIn(f">{chapter}</h2>", text)
            self.assertEqual(list(prefix.rglob("__pycache__")), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
