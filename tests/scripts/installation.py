#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""installation.py CMAKE BUILD_FOLDER: what is installed, and a case run from there: it finds its mesh, the program its
second half. What the project says of itself in several files is the same in all."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CMAKE, BUILD = sys.argv[1:]
ROOT = Path(__file__).resolve().parents[2]
INSTALLED = ("bin/vfife", "bin/vfife-study", "lib*/**/libvfife.a", "lib*/**/vfifeConfig.cmake", "include/vfife/base/types.h",
             "include/vfife/revision.h", "include/vfife/plugin/explicit_solid.h", "share/vfife/examples/dealii_plugin/impact.cc", "lib/python3/dist-packages/vfife/__init__.py", "share/vfife/report/make_report.py",
             "share/vfife/prm/spiral_bevel_quick.prm", "share/vfife/prm/errors/pitch_error.csv",
             "share/vfife/meshes/plate_with_hole.msh", "share/vfife/examples/proposed_pair.py",
             "share/vfife/examples/quieter_pair.py", "share/doc/vfife/README.md", "share/doc/vfife/copyright", "share/doc/vfife/doc/getting-started/first-run.md",
             "share/doc/vfife/doc/pictures/pair_stress.png", "share/bash-completion/completions/vfife")
LINK = re.compile(r"\]\(([^)\s:#]+)(?:#[^)]*)?\)")


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


class Installation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = Path(cls.folder.name) / "prefix"
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", cls.prefix], check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_files(self):
        for name in INSTALLED:
            with self.subTest(name):
                self.assertTrue(list(self.prefix.glob(name)))
        self.assertEqual(list(self.prefix.rglob("__pycache__")), [])

    def test_python(self):
        """The module of Python where it is built: beside the package, which finds it."""
        if not list((Path(BUILD) / "python").glob("_vfife.*")):
            self.skipTest("the module _vfife is not built")
        packages = self.prefix / "lib/python3/dist-packages"
        case = self.prefix / "share/vfife/prm/gear/proposed_17_43.prm"
        ask = f"from vfife import gear; print(gear.Pair({str(case)!r}).flank_points('gear')['convex'].points.shape)"
        done = subprocess.run([sys.executable, "-c", ask], env={**os.environ, "PYTHONPATH": str(packages), "PYTHONDONTWRITEBYTECODE": "1"}, check=True,
                              cwd=self.folder.name, stdout=subprocess.PIPE, text=True)
        self.assertEqual(done.stdout, "(15, 9, 3)\n")

    def test_links(self):
        """Pages link to what is installed with them; what stays in the tree is code."""
        pages = self.prefix / "share/doc/vfife"
        for page in sorted(pages.rglob("*.md")):
            for target in LINK.findall(page.read_text(encoding="utf-8")):
                with self.subTest(page=page.name, target=target):
                    self.assertTrue((page.parent / target).exists())

    def test_case(self):
        """A case of the installation names a mesh beside it."""
        case = self.prefix / "share/vfife/prm/verification/plate_with_hole.prm"
        done = subprocess.run([self.prefix / "bin/vfife", case, "--check"], cwd=self.folder.name, check=True,
                              stdout=subprocess.PIPE, text=True)
        self.assertIn("plate: 480 elements", done.stdout)
        self.assertEqual([path.name for path in Path(self.folder.name).iterdir()], ["prefix"])


class Statements(unittest.TestCase):
    def test_version(self):
        version = re.search(r"^project\(vfife VERSION ([\d.]+)", read("CMakeLists.txt"), re.M).group(1)
        said = subprocess.run([f"{BUILD}/vfife", "--version"], check=True, stdout=subprocess.PIPE, text=True).stdout
        self.assertTrue(said.startswith(f"vfife {version} (revision "), said)
        self.assertEqual(re.search(r"^version: (.*)$", read("CITATION.cff"), re.M).group(1), version)
        newest = re.search(r"^## ([\d.]+), (\d{4}-\d\d-\d\d)$", read("CHANGELOG.md"), re.M)
        self.assertEqual(newest.group(1), version)
        self.assertEqual(re.search(r"^date-released: (.*)$", read("CITATION.cff"), re.M).group(1), newest.group(2))

    def test_citation(self):
        """What the format 1.2.0 asks for."""
        try:
            import yaml
        except ImportError:
            self.skipTest("no python3-yaml")
        citation = yaml.safe_load(read("CITATION.cff"))
        self.assertEqual(citation["cff-version"], "1.2.0")
        self.assertEqual(citation["license"], "LGPL-2.1-or-later")
        self.assertTrue(all(isinstance(citation[name], str) for name in ("message", "title", "abstract", "version")))
        self.assertTrue(all(author["name"] for author in citation["authors"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
