#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of results that are damaged: one line that names the file and the place, exit code 1, no page."""
import json
import tempfile
import unittest
from pathlib import Path

from made_up_run import make_summary, write_run  # first: ends the test without the libraries

from vfife_report.command import main
from vfife_report.data.shapes import QUANTITY, find_mistake


def spoil(path, old, new):
    content = path.read_bytes()
    assert old in content
    path.write_bytes(content.replace(old, new, 1))


class Damaged(unittest.TestCase):
    def refuse(self, words, file=None, old=b"", new=b"", summary=None):
        """The report of a run of which one file is spoilt."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            write_run(folder, fields=file in ("fields.pvd", "last.vtu"))
            if summary is not None:
                (folder / "summary.json").write_text(summary)
            else:
                spoil(folder / file, old, new)
            with self.assertRaises(SystemExit) as ended:
                main([name])
            message = ended.exception.code
            self.assertEqual(message.count("\n"), 0)
            self.assertIn(words, message)
            self.assertIn(name, message)
            self.assertFalse((folder / "report.html").exists())

    def test_tables(self):
        self.refuse("history.csv:3:10: byte 0xFF is not UTF-8 text", "history.csv", b"e-05,-79.5", b"e-05,-79\xff.5")
        self.refuse('history.csv:2: expected a number in column "dte", got "x"', "history.csv", b"0.0,-80.0,", b"0.0,x,")
        self.refuse("history.csv:2: 5 cells, but the header has 6", "history.csv", b"0.0,-80.0,", b"0.0,")
        self.refuse("history.csv:2: 1e300 in column", "history.csv", b"0.0,-80.0,", b"0.0,1e300,")
        self.refuse("history.csv:3: the time goes back", "history.csv", b"0.0,-80.0,", b"1.0,-80.0,")
        self.refuse('history.csv:1: there is a second column "dte"', "history.csv", b"rim dte", b"dte")
        self.refuse('probes.csv:1: there is no column "von mises"', "probes.csv", b"von mises", b"von misses")

    def test_json(self):
        self.refuse("summary.json:1:12: the file is damaged", summary='{"status": x}')
        self.refuse("summary.json:1:1: the file is damaged", summary="")
        self.refuse("summary.json: it is a list, but should be a group of entries", summary="[]")
        self.refuse("brackets have no end", summary="[" * 100000)
        spoilt = make_summary()
        spoilt["figures"]["mesh frequency"]["value"] = "x"
        self.refuse("""summary.json: "figures", "mesh frequency", "value" is 'x', but should be a number""",
                    summary=json.dumps(spoilt))
        spoilt["figures"]["mesh frequency"]["value"] = 2**31
        self.refuse("its samples do not fit the mesh frequency 2.14748e+09 Hz", summary=json.dumps(spoilt))
        del spoilt["steady part"]["found"]
        spoilt["figures"]["mesh frequency"]["value"] = 9000
        self.refuse('"steady part", "found" is missing', summary=json.dumps(spoilt))
        self.refuse("parameters.json: ", "parameters.json", b'"value"', b'"walue"')

    def test_fields(self):
        self.refuse("last.vtu is damaged", "last.vtu", b"<Points>", b"<Pints>")
        self.refuse("fields.pvd, or the file that it names, is damaged", "fields.pvd", b"last", b"lost")

    def test_shapes(self):
        for value, right in ((1, True), (1.5, True), (None, True), (True, False), ("1", False), (1e200, False),
                             (float("inf"), False), (10**400, False)):
            self.assertEqual(not find_mistake({"value": value, "unit": "N"}, QUANTITY), right, value)


if __name__ == "__main__":
    unittest.main()
