#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds the package together: rows of plots are complete, rooms use only those before them, words and
numbers have one meaning."""
import ast
import collections
import unittest
from pathlib import Path

import made_up_run  # first: ends the test without the libraries

import numpy as np
import vfife_report
from vfife_report import plot_table
from vfife_report.page.folder_chapters import LEDGER, TABLE_CHAPTERS
from vfife_report.page.page import TEMPLATES
from vfife_report.page.result_chapters import RESULTS, STUDY_RESULTS
from vfife_report.page.run_chapters import CASE_CHAPTERS, PICTURE_CHAPTERS
from vfife_report.page.study_chapters import CLOSING_CHAPTERS, STUDY_CHAPTERS
from vfife_report.plots import style

PACKAGE = Path(vfife_report.__file__).parent
# What is listed in a room's place may be used in it, beside what stands before it.
ROOMS = ("data", "measures", "plots", "pictures", "plot_table", "page", "command", "__main__")
# Rows of plots and chapters of the same report.
REPORTS = {"run": (plot_table.RUN_PLOTS + plot_table.FIELD_PICTURES + plot_table.TABLE_PLOTS,
                   (RESULTS,) + PICTURE_CHAPTERS + (LEDGER,) + TABLE_CHAPTERS + CASE_CHAPTERS),
           "study": (plot_table.STUDY_PLOTS + plot_table.TABLE_PLOTS,
                     (STUDY_RESULTS, LEDGER) + STUDY_CHAPTERS + TABLE_CHAPTERS + CLOSING_CHAPTERS)}


def list_sources():
    return [(path.relative_to(PACKAGE), ast.parse(path.read_text(encoding="utf-8")))
            for path in sorted(PACKAGE.rglob("*.py"))]


class Rows(unittest.TestCase):
    def test_complete(self):
        for rows, _ in REPORTS.values():
            for row in rows:
                with self.subTest(row.name):
                    self.assertRegex(row.name, "^[a-z_{}]+[.](svg|png)$")
                    self.assertTrue(callable(row.draw))
                    self.assertIsInstance(row.needs, tuple)
                    self.assertTrue(all(callable(need) for need in row.needs))
                    self.assertTrue(row.needs or row in plot_table.FIELD_PICTURES)
                    self.assertRegex(row.caption, "^[A-Z].*[.]$")
                    self.assertEqual("{}" in row.name, row.each is not None)

    def test_chapters(self):
        """Each row's is known; a chapter of nothing but plots has one."""
        for kind, (rows, chapters) in REPORTS.items():
            names = [chapter.name for chapter in chapters]
            self.assertEqual(len(set(names)), len(names), kind)
            self.assertEqual({row.chapter for row in rows} - set(names), set(), kind)
            plain = {chapter.name for chapter in chapters if chapter.tell.__name__ == "show_plots"}
            self.assertEqual(plain - {row.chapter for row in rows}, set(), kind)

    def test_names(self):
        """No plot is written over another one of the same folder."""
        for rows, _ in REPORTS.values():
            count = collections.Counter(row.name for row in rows)
            self.assertEqual(count.most_common(1)[0][1], 1, count.most_common(1))


class Sources(unittest.TestCase):
    def test_rooms(self):
        """Relative imports lead to the same room or to one before it."""
        for path, tree in list_sources():
            room = path.parts[0] if len(path.parts) > 1 else path.stem
            if room == "__init__":
                continue
            for node in ast.walk(tree):
                if not isinstance(node, ast.ImportFrom) or node.level == 0:
                    continue
                inside = len(path.parts) - node.level > 0
                target = room if inside else (node.module or node.names[0].name).split(".")[0]
                with self.subTest(f"{path}:{node.lineno}"):
                    self.assertLessEqual(ROOMS.index(target), ROOMS.index(room))

    def test_words(self):
        """Nothing is called a figure: plots and pictures are drawn, quantities are numbers."""
        for path, tree in list_sources():
            for node in ast.walk(tree):
                for name in (getattr(node, "id", ""), getattr(node, "arg", "") or "",
                             getattr(node, "name", "") or ""):
                    with self.subTest(f"{path}:{getattr(node, 'lineno', 0)}"):
                        self.assertNotRegex(str(name), "(^|_)figures?(_|$)")

    def test_numbers(self):
        """A number with a name in capitals stands in one module."""
        owners = collections.defaultdict(set)
        for path, tree in list_sources():
            for node in tree.body:
                for target in getattr(node, "targets", []):
                    for name in target.elts if isinstance(target, ast.Tuple) else [target]:
                        if isinstance(name, ast.Name) and name.id.isupper():
                            owners[name.id].add(str(path))
        self.assertIn("LEAST_SHARE", owners)
        self.assertEqual({name: where for name, where in owners.items() if len(where) > 1}, {})

    def test_templates(self):
        """All that templates show is escaped."""
        self.assertTrue(TEMPLATES.autoescape)
        for name in TEMPLATES.list_templates():
            text = (PACKAGE / "page" / "templates" / name).read_text(encoding="utf-8")
            self.assertNotRegex(text, r"[|]\s*safe|autoescape|Markup")


class Ticks(unittest.TestCase):
    def test_steps(self):
        """1, 2 or 5 in every size of plot; matplotlib's own steps of 2.5 are met among these."""
        usual, own = set(), set()
        for high in (3.1, 7.6, 11, 14.9, 21):
            for size in (1.2, 1.8, 2.6, 3.5):
                plot, axes = style.plt.subplots(figsize=(size, size))
                axes.set(xlim=(0, high), ylim=(0, high))
                for steps, axis in ((usual, axes.xaxis), (own, axes.yaxis)):
                    if axis is axes.yaxis:
                        style.round_ticks(axes)
                    step = np.diff(axis.get_major_locator()()).min()
                    steps.add(round(step / 10 ** np.floor(np.log10(step)), 6))
                style.plt.close(plot)
        self.assertIn(2.5, usual)
        self.assertLessEqual(own, {1, 2, 5})


if __name__ == "__main__":
    unittest.main()
