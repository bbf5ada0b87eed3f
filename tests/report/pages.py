#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of made-up runs: one page that needs nothing else, with what the folder has."""
import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace

from made_up_run import (  # first: ends the test without the libraries
    FolderTest, make_page, make_parameters, make_summary, quantity, write_parameters, write_run)

import vfife_report
from vfife_report.command import main
from vfife_report.data.run_folder import RunFolder
from vfife_report.measures.checks import read_early_end
from vfife_report.page.glossary import read_glossary
from vfife_report.page.page import Page
from vfife_report.page.parts import Cells, Paragraph, format_number
from vfife_report.page.words import list_case_rows

VOID = {"meta", "img", "br", "input"}


class Reader(HTMLParser):
    """Checks that tags are closed in order; collects links and pictures."""

    def __init__(self, text):
        super().__init__()
        self.open, self.addresses, self.words, self.names = [], [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag not in VOID:
            self.open.append(tag)
        self.names |= {tag} | {f"{tag} {name}" for name, _ in attributes}
        self.addresses += [value for name, value in attributes if name in ("src", "href")]

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise ValueError(f"</{tag}> closes something else")

    def handle_data(self, data):
        self.words.append(data)


class Pages(FolderTest):
    def read(self, folder):
        text = (Path(folder) / "report.html").read_text(encoding="utf-8")
        reader = Reader(text)
        self.assertEqual(reader.open, [])
        for address in reader.addresses:
            self.assertRegex(address, "^(#|data:image/(png|svg[+]xml);base64,)")
        self.assertNotRegex(text, "(?i)<script|@import|url[(]")
        return text

    def test_geometry(self):
        """Of a proposed pair what was proposed is shown, not the entries that were left alone."""
        proposed = {**make_parameters(), "Gear pair/Proposal/pinion teeth": ("17", "-"),
                    "Gear pair/Proposal/gear teeth": ("43", "-"), "Gear pair/Pinion/Blank/number of teeth": ("0", "-"),
                    "Gear pair/Pinion/Blank/hand of spiral": ("right", ""), "Gear pair/Gear/Blank/hand of spiral": ("right", ""),
                    "Gear pair/Gear/Blank/mean cone distance": ("0", "mm"), "Gear pair/Gear/Blank/face width": ("0", "mm")}
        geometry = {"pair": {"outer transverse module": quantity(4, "mm")},
                    "pinion": {"hand of spiral": "left", "face width": quantity(27.7, "mm")},
                    "gear": {"hand of spiral": "right", "face width": quantity(27.7, "mm")}}
        for known in (True, False):
            with tempfile.TemporaryDirectory() as name:
                write_run(Path(name), fields=False)
                write_parameters(Path(name), proposed)
                if known:
                    (Path(name) / "geometry.json").write_text(json.dumps(geometry))
                make_page(name)
                text = self.read(name)
                self.assertIn("Spiral bevel gear pair 17/43", text)
                for wrong in ("right, right", "<td>0 mm</td>", "hand of pinion and gear"):
                    self.assertNotIn(wrong, text)
                self.assertEqual("<td>left</td><td>right</td>" in text, known)
                self.assertEqual(text.count("27.7"), 2 * known)

    def list_case(self, **changed):
        """Rows of the case's table, of a run with other parameters."""
        with tempfile.TemporaryDirectory() as name:
            write_run(Path(name), fields=False)
            parameters = {**make_parameters(), "Operation/mesh cycles": ("14", ""), "Dynamics/mass proportional damping": ("1000", "1/s"),
                          "Dynamics/driven speed damping": ("2000", "1/s"), "Dynamics/corotational frame": ("polar", "")}
            write_parameters(Path(name), {**parameters, **changed})
            return dict(list_case_rows(RunFolder(name)))

    def test_case(self):
        """What is in force: no entry that the kind of study does not use, and no default that another entry replaces."""
        self.assertEqual(self.list_case()["mass proportional damping"], "1000 1/s")
        ratio = {"Dynamics/damping ratio": ("1 %", ""), "Dynamics/damping frequency": ("3.7 kHz", "Hz")}
        self.assertEqual(self.list_case(**ratio)["mass proportional damping"], "1 % at 3.7 kHz")
        self.assertNotIn("damping", self.list_case(**{"Dynamics/mass proportional damping": ("0", "1/s")}))
        for kind, unused in (("waves", {"mesh cycles", "start", "element frame, stiffness"}),
                             ("static", {"start", "damping", "driven speed damping"}), ("reduced", {"element frame, stiffness"}),
                             ("run", set())):
            rows = self.list_case(**{"Study/kind": (kind, "")})
            self.assertEqual(unused & set(rows), set(), kind)
        self.assertIn("mesh cycles", rows)
        model = {name: ("0", "-") for name in make_parameters() if name.endswith("number of teeth")}
        self.assertNotIn("driven speed damping", self.list_case(**model))
        # Errors that are given, and who drives.
        rows = self.list_case(**{"Gear pair/Mounting/offset": ("0.1", "mm", "0"), "Gear pair/Mounting/backlash": ("0.1", "mm", "0.12"),
                                 "Gear pair/Errors/Gear/radial runout amplitude": ("0", "um", "0"), "Operation/driving member": ("gear", "")})
        self.assertEqual(rows["Mounting, offset"], "0.1 mm")
        self.assertEqual(rows["torque on the pinion"], "800 N m")
        self.assertFalse({"Mounting, backlash", "Errors, Gear, eccentricity", "torque on the gear"} & set(rows))

    def test_early_end(self):
        """A run that was told to end after some steps has not come to its end."""
        for steps, said in (("0", "finished"), ("50", "ended after 50 steps")):
            run = SimpleNamespace(summary={"status": "finished", "run": {"steps": 50}}, parameters={
                "Dynamics/maximum number of steps": steps})
            self.assertEqual(read_early_end(run), 50 * (steps == "50"), said)

    def write_model(self, folder, study):
        """Histories of a model with a probe, a clamp and no contact, whose motion along y is a rounding error."""
        names = ["time [s]", "contact force total [N]", "energy error [-]", "strain energy [mJ]"]
        names += [f"tip displacement {axis} [mm]" for axis in "xyz"] + ["tip von mises [MPa]"]
        names += [f"clamp reaction force {axis} [N]" for axis in "xyz"] + [f"clamp reaction moment {axis} [N mm]" for axis in "xyz"]
        row = [0, 0, 12, 1e-3, 1e-15, 0.0123456, 5, 8e-11, -7e-10, -3, 1e-9, 300, 2e-9]
        (folder / "history.csv").write_text("\n".join(
            [",".join(names)] + [",".join(map(str, [time, *row])) for time in ((0, 1e-3, 2e-3) if study == "run" else (1,))]) + "\n")
        (folder / "summary.json").write_text(json.dumps({
            "status": "finished", "study": study, "version": "0", "revision": "made up",
            "run": {"time": quantity(0., "s"), "step": quantity(0., "s"), "steps": 0, "run time": quantity(0.5, "s"), "ranks": 1,
                    "element-steps per second": quantity(0., "1/s")},
            "energy": {"strain": quantity(12., "mJ"), "residual": quantity(12., "mJ"), "contact loss": quantity(0., "mJ")}}))

    def test_equilibrium(self):
        """It has reactions, and neither a ledger of energies nor steps nor figures of a steady part."""
        for study in ("static", "linear static"):
            with tempfile.TemporaryDirectory() as name:
                self.write_model(Path(name), study)
                main([name])
                text = self.read(name)
                self.assertRegex(text, "<td>clamp</td>" + "".join(
                    f'<td class="number">{value}</td>' for value in ("0", "0", "\u22123", "0", "300", "0")))
                self.assertIn("tip displacement, largest z", text)
                for wrong in ("residual", "energy error", "steady part", "largest y", "element-steps", "unknown instructions",
                              "<td>step</td>", "contact force"):
                    self.assertNotIn(wrong, text)

    def test_model(self):
        """Its probes have curves; nothing is said of a contact that it has not."""
        self.write_model(self.path, "run")
        main([str(self.path)])
        chapters = re.findall("<h2.*?>(.*?)</h2>", self.read(self.path))
        self.assertIn("Motion of the probes", chapters)
        self.assertNotIn("Contact", chapters)
        curves = {row["curve"]: float(row["y"])
                  for row in csv.DictReader((self.path / "pictures" / "model_probes.csv").read_text().splitlines())}
        self.assertEqual(curves, {"x": 1e-3, "y": 1e-15, "z": 0.0123456, "tip": 5})

    def test_parts_of_a_model(self):
        """Bodies, constraints and loads with what is given of them, which no default tells."""
        self.write_model(self.path, "static")
        write_parameters(self.path, {
            "Study/kind": ("static", ""), "Model/bodies": ("beam", "", "beam"),
            "Model/Body beam/mesh": ("beam", "", "block"), "Model/Body beam/length": ("100 mm", "mm", "10"),
            "Model/Body beam/width": ("10", "mm", "10"), "Model/Constraint clamp/kind": ("fixed", "", "fixed"),
            "Model/Constraint clamp/nodes": ("x-", "", ""), "Model/Load end/kind": ("moment", "", "force"),
            "Model/Load end/moment": ("0, -3, 0", "N mm", "0, 0, 0"), "Model/Load end/nodes": ("x+", "", ""),
            "Model/Contact pads/Friction/coefficient": ("0.3", "-", "0"), "Model/Contact pads/kind": ("wall", "", "bodies")})
        main([str(self.path)])
        rows = re.findall("<tr>(.*?)</tr>", self.read(self.path), re.S)
        cells = [re.findall("<td[^>]*>(.*?)</td>", row, re.S) for row in rows]
        for row in (["body", "beam", "beam", "length 100 mm"], ["constraint", "clamp", "fixed", "nodes x-"],
                    ["load", "end", "moment", "moment 0, -3, 0 N mm; nodes x+"], ["contact", "pads", "wall", "Friction/coefficient 0.3"]):
            self.assertIn(row, cells)

    def test_unsteady_ripple(self):
        """Values of a ripple that is not steady are marked, means are not."""
        for steady in (True, False):
            with tempfile.TemporaryDirectory() as name:
                write_run(Path(name), fields=False)
                summary = make_summary()
                summary["steady part"]["ripple"] = {"judged": True, "steady": steady}
                (Path(name) / "summary.json").write_text(json.dumps(summary))
                make_page(name)
                text = self.read(name)
                # Three figures of the ripple in each column: none of the means.
                marks = re.findall("<td>([^<]*)</td><td[^>]*>[^<]*</td><td>[^<]*</td><td>ripple still transient</td>", text)
                self.assertEqual(marks, [] if steady else [
                    f"{column}, {what}" for column in ("dte", "rim dte") for what in ("peak to peak of the record", "standard deviation")])
                self.assertEqual("The ripple is still transient" in text, not steady)
                self.assertIn("✓ met" if steady else "✗ not met",
                              text[text.index("<td>ripple, first half against second half"):].split("</tr>")[0])

    def test_part(self):
        """The times that means cover: no steady part where none was found."""
        for found in (True, False):
            with tempfile.TemporaryDirectory() as name:
                write_run(Path(name), fields=False)
                summary = make_summary()
                summary["steady part"]["found"] = found
                (Path(name) / "summary.json").write_text(json.dumps(summary))
                make_page(name)
                text = self.read(name)
                self.assertEqual("Means and peak to peak values cover the steady part." in text, found)
                self.assertEqual("cover the last third, because no steady part was found." in text, not found)

    def test_run(self):
        write_run(self.path, fields=False)
        main([str(self.path)])
        text = self.read(self.path)
        for words in ("Spiral bevel gear pair 27/79, web 5 mm", "Transmission error",
                      "Motion of the rim", "Key figures", "dte, mean", "Energy and damping",
                      "&lt;one&gt; &amp; another", "input conflicts"):
            self.assertIn(words, text)
        self.assertEqual(text.count("<img "), 11)
        for data in re.findall("Data: <code>(.*?)</code>", text):
            self.assertTrue((self.path / data).is_file(), data)

    def test_results(self):
        """The first chapter has the main results, each with its accuracy, and checks that are not met."""
        for steady in (True, False):
            with tempfile.TemporaryDirectory() as name:
                write_run(Path(name), fields=False)
                summary = make_summary()
                summary["steady part"].update(found=True, ripple={"judged": True, "steady": steady})
                summary["steady part"]["columns"]["contact force total"] = {"mean": 8900.0, "peak to peak": 500.0,
                                                                            "standard deviation": 100.0, "unit": "N"}
                (Path(name) / "summary.json").write_text(json.dumps(summary))
                make_page(name)
                text = self.read(name)
                first = text[text.index(">Results</h2>"):text.index(">Transmission error</h2>")]
                for words in ("transmission error, mean", "transmission error, peak to peak of the record",
                              "sum of the contact forces, peak to peak of the record",
                              "contact pressure (Hertz), largest"):
                    self.assertIn(f">{words}</td>", first)
                self.assertLessEqual(first.count("<tr>"), 6)
                self.assertEqual("<td>do not quote: still transient; the mean mesh cycle has" in first.replace('<td class="long">', "<td>"), not steady)
                self.assertEqual("ripple, first half against second half" in first[first.index("These checks are not met"):], not steady)
                trust = text[text.index(">Accuracy and validity</h2>"):]
                row = trust[trust.index("peak to peak of transmission error and forces"):].split("</tr>")[0]
                self.assertIn(f"<td>{'yes' if steady else 'no'}</td>", row)

    def test_killed(self):
        """A run without summary: histories over time, nothing over mesh cycles."""
        write_run(self.path, fields=False)
        (self.path / "summary.json").unlink()
        main([str(self.path)])
        chapters = re.findall("<h2.*?>(.*?)</h2>", self.read(self.path))
        self.assertEqual(chapters, ["Results", "Transmission error", "Contact", "Stress at the probes", "Motion of the rim",
                                    "Key figures", "The case", "Energy and damping", "Checks", "Words"])

    def test_missing_library(self):
        """One line, and the exit code that asks for another Python."""
        script = Path(vfife_report.__file__).parents[1] / "make_report.py"
        for library in ("numpy", "matplotlib", "jinja2", "meshio"):
            with tempfile.TemporaryDirectory() as name:
                (Path(name) / f"{library}.py").write_text(f"raise ImportError('no {library}')\n")
                ended = subprocess.run([sys.executable, "-B", script, name], capture_output=True, text=True,
                                       check=False, env={**os.environ, "PYTHONPATH": name})
                self.assertEqual((ended.returncode, ended.stdout, ended.stderr), (77, f"no {library}\n", ""))

    def test_study(self):
        for thickness in ("5", "3.5"):
            folder = self.path / f"web_{thickness}"
            folder.mkdir()
            write_run(folder, thickness, fields=False)
        failed = self.path / "failed"
        failed.mkdir()
        (failed / "summary.json").write_text('{"status": "failed", "failure": "it <exploded>"}')
        # The order is the list's, whatever its columns are.
        (self.path / "sweep.csv").write_text("a,b\n1,web_5\n2,web_3.5\n3,failed\n")
        main([str(self.path)])
        text = self.read(self.path)
        self.assertIn("3 variants", text)
        self.assertIn("it &lt;exploded&gt;", text)
        self.assertLess(text.index("<td>web_5"), text.index("<td>web_3.5"))
        self.assertEqual(text.count("<img "), 8)
        header = (self.path / "key_figures.csv").read_text().splitlines()[0]
        self.assertEqual(header.count(","), 4)

    def test_study_without_steady_part(self):
        """Variants whose figures are not of a steady part are named, and geometry is told where it is not the same."""
        for web, found, steady in (("5", True, True), ("3.5", False, False)):
            folder = self.path / f"web_{web}"
            folder.mkdir()
            write_run(folder, web, fields=False)
            summary = make_summary()
            summary["steady part"].update(found=found, ripple={"judged": True, "steady": steady})
            (folder / "summary.json").write_text(json.dumps(summary))
            member = {"hand of spiral": "left", "face width": quantity(27.7, "mm"), "web thickness": quantity(float(web), "mm")}
            (folder / "geometry.json").write_text(json.dumps({"pair": {}, "pinion": member, "gear": member}))
        make_page(self.path)
        text = self.read(self.path)
        alike, different = text.index("geometry of all variants"), text.index("Geometry that differs between variants")
        self.assertIn("27.7", text[alike:])
        for rows, there in ((text[alike:different], False), (text[different:text.index("Means and peak to peak", different)], True)):
            self.assertEqual("<td>web thickness</td>" in rows, there)
        self.assertRegex(text, r"<td>web thickness</td>\s*<td>web 3.5 mm at 70 deg</td>")
        self.assertEqual(text.count("These variants have no steady part: web 3.5 mm at 70 deg. Their values"), 2)
        self.assertEqual(text.count("The ripple of these variants is still transient: web 3.5 mm at 70 deg."), 2)
        self.assertIn("<td>last third</td>", text)

    def test_unused_entries(self):
        """Variants of several kinds of studies: entries that one of them does not use are left empty, and a column without
        a difference is none."""
        for kind, damping, meshes in (("linear static", "1000", "14"), ("run", "0", "14"), ("waves", "5", "20")):
            folder = self.path / kind
            folder.mkdir()
            write_run(folder, fields=False)
            write_parameters(folder, {**make_parameters(), "Study/kind": (kind, ""), "Dynamics/mass proportional damping": (damping, "1/s"),
                                      "Operation/mesh cycles": (meshes, "")})
            (folder / "report.html").write_text("made by the run")
        make_page(self.path)
        text = self.read(self.path)
        self.assertIn("<th>mass proportional damping</th>", text)
        self.assertNotIn("1000 1/s", text)
        self.assertNotIn("<th>mesh cycles</th>", text)
        self.assertIn("report.html in its folder", text)

    def test_ledger(self):
        row = {"quantity": "mean dte", "unit": "arcsec", "value": -84.0, "reference": -79.98766,
               "reference kind": "FEM", "difference": -4.01234, "tolerance": 1.0,
               "verdict": "differs", "reason": "coarse"}
        open_one = {**row, "verdict": "not judged", "tolerance": None}
        (self.path / "comparison.json").write_text(json.dumps(
            {"title": "t", "cases": [{"name": "first", "kind": "run", "folder": "results/a"}],
             "remarks": ["nothing of second is compared"], "rows": [row, open_one, open_one]}))
        main([str(self.path)])
        text = self.read(self.path)
        for words in ("The comparison has 3 rows: 0 within the tolerance, 1 beyond it, 2 not judged.", "<td>results/a</td>",
                      "Nothing of second is compared."):
            self.assertIn(words, text)
        # Numbers to be compared have five digits, what they differ by has three.
        self.assertIn("\u221279.988</td>", text)
        self.assertIn("\u22124.01</td>", text)
        self.assertNotIn("\u22124.0123", text)

    def test_tooth_contact(self):
        """Both sides of an unloaded analysis beside each other, words as words, and what is left of the teeth."""
        side = {"mean contact on the generated pinion flank": {"L": quantity(78.6, "mm"), "normal x": quantity(-0.488, "-")},
                "mean contact on the generated gear flank": {"L": quantity(78.7, "mm")},
                "ellipse at the mean contact": {"semi-axis a": quantity(4.855, "mm")},
                "path": {"contact ratio": quantity(1.69, "-"), "ended by": ["gear tip", "pinion tip"]},
                "beyond the start": {"lag": quantity(16.3, "arcsec"), "border": "gear tip", "is edge": True},
                "beyond the end": {"border": "pinion tip"}, "lag over pitches": {}, "has a transfer point": True, "transfer point inside the flanks": True,
                "transfer point": {"peak to peak": quantity(3.98, "arcsec")}}
        drive = {**side, "transfer point inside the flanks": False}
        coast = {**side, "has a transfer point": False, "path": {"contact ratio": quantity(0.9, "-")}}
        del coast["transfer point"]
        sections = {place: {"tip land": quantity(land, "mm")} for place, land in (("toe", 1.5), ("middle", 1.6), ("heel", 1.7))}
        analysis = {"working": {"driving member": "pinion", "direction of rotation": "forward", "side": "drive"},
                    "drive": drive, "coast": coast, "unequal teeth": {"peak to peak": quantity(98.205, "arcsec")},
                    "teeth": {"pinion": sections, "gear": sections}}
        (self.path / "tca.json").write_text(json.dumps(analysis))
        main([str(self.path)])
        text = re.sub(r"\s+", " ", self.read(self.path))
        for words in ("On the drive side the path of contact ends before", "98.2",
                      "The pinion drives forward, so the drive side is in contact.", "On the coast side contact is interrupted before",
                      "before the path: border", "<td>gear tip</td>"):
            self.assertIn(words, text)
        coast["path"]["contact ratio"]["value"] = 2.26
        (self.path / "tca.json").write_text(json.dumps(analysis))
        main([str(self.path)])
        self.assertIn("On the coast side the flanks have no transfer point.", re.sub(r"\s+", " ", self.read(self.path)))
        for row in (("path of contact: contact ratio", "-", "1.69", "0.9"), ("transfer point: peak to peak", "arcsec", "3.98", "–"),
                    ("tip land", "mm", *["1.5", "1.6", "1.7"] * 2)):
            cells = [re.escape(cell) for cell in row]
            self.assertRegex(text, r"</td>\s*<td[^>]*>".join(cells))
        self.assertNotIn("normal x", text)
        # Mounting errors may leave nothing on the side that does not work.
        del analysis["coast"]
        (self.path / "tca.json").write_text(json.dumps({**analysis, "marking compound thickness": quantity(6.35, "um")}))
        main([str(self.path)])
        text = re.sub(r"\s+", " ", self.read(self.path))
        for words in ("On the coast side the flanks have no contact inside their borders", "marking compound of 6.35 um"):
            self.assertIn(words, text)

    def test_nothing(self):
        for folder, words in ((str(self.path), "neither results"), (str(self.path / "a"), "no folder")):
            with self.assertRaisesRegex(SystemExit, words):
                main([folder])

    def test_numbers(self):
        for value, text in ((1234567, "1\u202f234\u202f567"), (-80, "\u221280"), (-83.92, "\u221283.92"), (0.0, "0"),
                            (1234567.8, "1234568"), (1.5e-7, "1.5e-07"), (None, "–"),
                            (float("nan"), "–"), (-1e-6, "\u22121e-06")):
            self.assertEqual(format_number(value), text)

    def test_rows_made_on_the_way(self):
        """A table is looked at more than once: for what its columns are, then for what is in them."""
        cells = Cells(["body", "value"], (["pinion", 1.0] for _ in range(2)))
        self.assertEqual(cells.columns(), [("body", False), ("value", True)])
        self.assertEqual(cells.rows, [["pinion", 1.0]] * 2)

    def test_digits(self):
        """Figures have three significant digits, tables to be compared or taken over five."""
        row = [["dte", -78.4104, "arcsec"], ["force", 8909.31, "N"], ["energy", 0.0123456, "J"]]
        few, all_of_them = Cells(["", "value", "unit"], row), Cells(["", "value", "unit"], row, digits=5)
        self.assertEqual([few.show(value)[1] for _, value, _ in row], ["\u221278.4", "8909", "0.0123"])
        self.assertEqual([all_of_them.show(value)[1] for _, value, _ in row], ["\u221278.41", "8909.3", "0.012346"])

    def test_words(self):
        """What the report says in words of its own it explains, and nothing else."""
        self.assertTrue(all(names and "](" not in text for names, text in read_glossary()))
        write_run(self.path, fields=False)
        make_page(self.path)
        words = self.read(self.path).partition(">Words</h2>")[2]
        for word in ("ripple", "rim dte", "energy error"):
            self.assertIn(f">{word}</td>", words)
        for word in ("undercut indicator", "share of the static rotation", "]("):
            self.assertNotIn(word, words)

    def test_escape(self):
        page = Page("a < b", "c & d")
        page.section("<x>", [Cells(["<h>"], [["<cell>"]], "<caption>"), Paragraph("<p>")])
        Reader(page.text())
        self.assertEqual(page.text().count("&lt;"), 8)

    # What would open a tag, close an attribute or begin an entity.
    MARKUP = 'a"\'><x y="1">&lt;'
    KNOWN = {"html", "html lang", "head", "meta", "meta charset", "meta name", "meta content", "title",
             "style", "body", "main", "h1", "h2", "h2 id", "p", "p class", "nav", "a", "a href", "div",
             "div class", "table", "table class", "thead", "tbody", "tr", "tr class", "th", "th class", "td", "td class",
             "td colspan", "figure",
             "label", "input", "input type", "input aria-label", "img", "img alt", "img src",
             "figcaption", "code"}

    def spoil(self, value):
        """The same with markup in all its texts, and in one more entry of what lists quantities."""
        if isinstance(value, dict):
            spoilt = {key: self.spoil(one) for key, one in value.items()}
            listed = [one for one in value.values() if isinstance(one, dict) and "unit" in one]
            return {**spoilt, self.MARKUP: self.spoil(listed[0])} if listed else spoilt
        if isinstance(value, list):
            return [self.spoil(one) for one in value]
        return value + self.MARKUP if isinstance(value, str) else value

    def write_spoilt_run(self, folder, thickness):
        folder.mkdir(parents=True, exist_ok=True)
        write_run(folder, fields=False)
        columns = make_summary()["steady part"]["columns"]
        summary = self.spoil({**make_summary(), "failure": "failed", "warnings": ["warning"],
                              "damping audit": [{"body": "gear", "net torque": quantity(1),
                                                 "power": quantity(1), "drift of rotation speed": quantity(1)}],
                              "transmission error": {"rim": quantity(1, "arcsec")}})
        summary["steady part"]["columns"] = {
            name: {**one, "unit": self.MARKUP} for name, one in columns.items()}
        (folder / "summary.json").write_text(json.dumps(summary))
        parameters = {name: (value + self.MARKUP, unit)
                      for name, (value, unit) in make_parameters(thickness).items()}
        parameters["Gear pair/Gear/Body/body type"] = ("conical web", "")
        for what in ("Young's modulus", "Poisson's ratio", "density"):
            parameters[f"Material {self.MARKUP}/{what}"] = (self.MARKUP, "")
        write_parameters(folder, parameters)
        with open(folder / "probes.csv", "w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([["time [s]", "probe", "von mises [MPa]"]] + [
                [1e-5 * k, self.MARKUP, 10 * (k == 5)] for k in range(20)])

    def check_escaped(self, folder):
        row = {name: self.MARKUP for name in ("quantity", "unit", "reference kind", "reason")}
        (folder / "comparison.json").write_text(json.dumps({"title": self.MARKUP, "rows": [
            {**row, "value": 1, "reference": None, "difference": None, "tolerance": None,
             "verdict": "not judged"}]}))
        main([str(folder)])
        reader = Reader(self.read(folder))
        self.assertEqual(reader.names - self.KNOWN, set())
        shown = sum(text.count(self.MARKUP) for text in reader.words)
        return shown, "".join(reader.words)

    def test_texts_of_files(self):
        """Whatever the files and the folder are called and say is text, not markup."""
        study = self.path / self.MARKUP
        for thickness in ("5", "3.5"):
            self.write_spoilt_run(study / f"{thickness} {self.MARKUP}", thickness)
        shown, words = self.check_escaped(study / f"5 {self.MARKUP}")
        self.assertGreater(shown, 60)
        for before in ("failed", "warning", "pinion", "Steady from 0.2 ms", "made up", "mJ"):
            self.assertIn(before + self.MARKUP, words)
        shown, words = self.check_escaped(study)
        self.assertGreater(shown, 40)
        self.assertIn(f"5 {self.MARKUP}", words)


if __name__ == "__main__":
    unittest.main()
