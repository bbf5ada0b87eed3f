#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of made-up runs: one page that needs nothing else, with what the folder has."""
import json
import re
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

from made_up_run import write_run  # first: ends the test without numpy

import make_report
from page import Page, format_number

VOID = {"meta", "img", "br", "input"}


class Reader(HTMLParser):
    """Checks that tags are closed in order; collects links and pictures."""

    def __init__(self, text):
        super().__init__()
        self.open, self.addresses, self.words = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag not in VOID:
            self.open.append(tag)
        self.addresses += [value for name, value in attributes if name in ("src", "href")]

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise ValueError(f"</{tag}> closes something else")

    def handle_data(self, data):
        self.words.append(data)


class Pages(unittest.TestCase):
    def read(self, folder):
        text = (Path(folder) / "report.html").read_text(encoding="utf-8")
        reader = Reader(text)
        self.assertEqual(reader.open, [])
        for address in reader.addresses:
            self.assertRegex(address, "^(#|data:image/(png|svg[+]xml);base64,)")
        self.assertNotRegex(text, "(?i)<script|@import|url[(]")
        return text

    def test_run(self):
        with tempfile.TemporaryDirectory() as name:
            write_run(Path(name), fields=False)
            make_report.main([name])
            text = self.read(name)
            for words in ("Spiral bevel gear pair 27/79, web 5 mm", "Transmission error",
                          "Motion of the rim", "Key figures", "dte, mean", "Energy and damping",
                          "&lt;one&gt; &amp; another", "contradictions"):
                self.assertIn(words, text)
            self.assertEqual(text.count("<img "), 11)
            for data in re.findall("Data: <code>(.*?)</code>", text):
                self.assertTrue((Path(name) / data).is_file(), data)

    def test_study(self):
        with tempfile.TemporaryDirectory() as name:
            for thickness in ("5", "3.5"):
                folder = Path(name) / f"web_{thickness}"
                folder.mkdir()
                write_run(folder, thickness, fields=False)
            failed = Path(name) / "failed"
            failed.mkdir()
            (failed / "summary.json").write_text('{"status": "failed", "failure": "it <exploded>"}')
            # The order is the list's, whatever its columns are.
            (Path(name) / "sweep.csv").write_text("a,b\n1,web_5\n2,web_3.5\n3,failed\n")
            make_report.main([name])
            text = self.read(name)
            self.assertIn("3 variants", text)
            self.assertIn("it &lt;exploded&gt;", text)
            self.assertLess(text.index("<td>web_5"), text.index("<td>web_3.5"))
            self.assertEqual(text.count("<img "), 7)
            header = (Path(name) / "key_figures.csv").read_text().splitlines()[0]
            self.assertEqual(header.count(","), 4)

    def test_ledger(self):
        with tempfile.TemporaryDirectory() as name:
            row = {"quantity": "mean dte", "unit": "arcsec", "value": -84.0, "reference": -80.0,
                   "reference kind": "FEM", "difference": -4.0, "tolerance": 1.0,
                   "verdict": "differs", "reason": "coarse"}
            (Path(name) / "comparison.json").write_text(json.dumps({"title": "t", "rows": [row]}))
            make_report.main([name])
            self.assertIn("1 comparisons, 1 differ", self.read(name))

    def test_nothing(self):
        with tempfile.TemporaryDirectory() as name:
            for folder, words in ((name, "neither results"), (name + "/a", "no folder")):
                with self.assertRaisesRegex(SystemExit, words):
                    make_report.main([folder])

    def test_numbers(self):
        for value, text in ((1234567, "1\u202f234\u202f567"), (-83.92, "\u221283.92"), (0.0, "0"),
                            (1234567.8, "1234568"), (1.5e-7, "1.5e-07"), (None, "–"),
                            (float("nan"), "–"), (-1e-6, "\u22121e-06")):
            self.assertEqual(format_number(value), text)

    def test_escape(self):
        page = Page("a < b", "c & d")
        page.section("<x>")
        page.table(["<h>"], [["<cell>"]], "<caption>")
        page.paragraph("<p>")
        Reader(page.text())
        self.assertEqual(page.text().count("&lt;"), 8)


if __name__ == "__main__":
    unittest.main()
