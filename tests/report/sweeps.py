#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps over one number, and sidebands, of made-up histories with known lines."""
import csv
import json
import tempfile
import unittest
from pathlib import Path

from made_up_run import (  # first: ends the test without the libraries
    FolderTest, make_parameters, make_summary, quantity, write_parameters, write_run)

import numpy as np

from vfife_report.command import main
from vfife_report.data.beside import read_beside
from vfife_report.data.run_folder import RunFolder
from vfife_report.data.study import Study
from vfife_report.data.swept import find_axis, find_speeds
from vfife_report.data.variants import find_variants
from vfife_report.measures.critical_speeds import choose_modes, list_critical_speeds
from vfife_report.measures.run_lines import describe_resolution, list_other_lines
from vfife_report.measures.sidebands import list_sidebands
from vfife_report.measures.study_results import list_ranges
from vfife_report.page.study_chapters import tell_responses
from vfife_report.page.sweep_chapter import list_sentences
from vfife_report.plots.curves import draw_curves
from vfife_report.page.error_chapter import tell_error_bars
from vfife_report.plots.error_bars import draw_error_bars
from vfife_report.plots.resonance import draw_resonance
from vfife_report.plots.speed_curves import draw_speed_curves, draw_stress_response
from vfife_report.plots.spectra import draw_sidebands
from vfife_report.plots.waterfalls import draw_waterfall

SAMPLES = 50
FREE_LINE = 1100.0  # Hz


def write_pair(folder, speed, meshes, make_dte):
    """A run whose transmission error is make_dte(mesh cycles, mesh frequency)."""
    folder.mkdir(parents=True, exist_ok=True)
    frequency = speed * 27 / 60
    at = np.arange(meshes * SAMPLES + 1) / SAMPLES
    time, dte = at / frequency, make_dte(at, frequency)
    (folder / "history.csv").write_text("time [s],dte [arcsec],contact force total [N]\n" + "".join(
        f"{t!r},{x!r},{9000 + 10 * x!r}\n" for t, x in zip(time.tolist(), dte.tolist())))
    summary = make_summary()
    summary["figures"]["mesh frequency"] = quantity(frequency, "Hz")
    for body, turn in zip(summary["mesh"]["bodies"], (speed, -speed * 27 / 79)):
        body["speed at the start"] = quantity(turn, "rpm")
    statistics = {"mean": dte.mean(), "peak to peak": np.ptp(dte), "standard deviation": dte.std(),
                  "unit": "arcsec"}
    summary["steady part"].update(
        {"start": quantity(0, "s"), "end": quantity(time[-1], "s"), "mesh cycles": meshes,
         "columns": {"dte": statistics, "contact force total": dict(statistics, unit="N")}})
    (folder / "summary.json").write_text(json.dumps(summary))
    write_parameters(folder, {**make_parameters(), "Operation/speed": (f"{speed} rpm", "rpm"),
                              "Operation/mesh cycles": (str(meshes), "-")})


def write_sweep(folder, speeds):
    for k, speed in enumerate(speeds):
        write_pair(folder / f"run_{k:02d}", speed, 20,
                   lambda at, f: 2 * np.cos(2 * np.pi * at) + np.cos(2 * np.pi * FREE_LINE * at / f))
    (folder / "beside" / "1").mkdir(parents=True)
    (folder / "beside" / "1" / "coupled_modes.csv").write_text(
        "axes,frequency [Hz],share of the static rotation [-]\nturning,1000,0.5\n"
        "standing,900,0.1\nstanding,1800,0.3\nstanding,1500,0.001\n")
    write_parameters(folder / "beside" / "1", {"Operation/speed": ("20000 rpm", "rpm")})
    for name, kind in (("2", "lumped"), ("3", "reduced")):
        (folder / "beside" / name).mkdir()
        (folder / "beside" / name / "resonance.csv").write_text(
            "direction,speed [rpm],mesh frequency [Hz],peak to peak dte [arcsec],rms dte [arcsec],"
            "peak to peak force [N],rms force [N]\n"
            "up,2000,900,1,0.5,10,5\nup,5000,2250,4,2,40,20\ndown,5000,2250,3,1,30,10\n")
        write_parameters(folder / "beside" / name, {"Study/kind": (kind, "")})


def write_response(folder, web, forces):
    """A sweep over speed with forces at 1000, 2000, 3000 rpm, and stresses a hundredth of them at two places."""
    folder.mkdir(parents=True)
    summary = make_summary()
    del summary["steady part"]  # of one speed
    (folder / "summary.json").write_text(json.dumps(summary))
    write_parameters(folder, {**make_parameters(), "Gear pair/Gear/Body/body type": (web, "")})
    rows = list(zip((1000, 2000, 3000), forces))
    (folder / "resonance.csv").write_text(
        "direction,speed [rpm],peak to peak dte [arcsec],largest force [N]\n" + "".join(
            f"up,{speed},{force / 1000},{force}\n" for speed, force in rows))
    (folder / "wave_response.csv").write_text("direction,speed [rpm],travelling wave 1 [um]\n" + "".join(
        f"up,{speed},1\n" for speed, _ in rows))
    (folder / "stress_response.csv").write_text(
        "direction,speed [rpm],place,stress without vibration [MPa],largest stress [MPa],amplification [-]\n" + "".join(
            f"up,{speed},{place},80,{part * force},{part * force / 80}\n" for speed, force in rows
            for place, part in (("web", 0.01), ("fillet", 0.005))))
    (folder / "exceedances.csv").write_text(
        "direction,quantity,from [rpm],to [rpm],largest amplification [-],at [rpm]\n"
        "up,web,1500,2500,1.3,2000\ndown,web,1400,2400,1.3,2000\n")


class Responses(FolderTest):
    """Variants that are sweeps over speed."""

    def setUp(self):
        super().setUp()
        write_response(self.path / "run_01", "none", (9000, 12000, 10000))
        write_response(self.path / "run_02", "conical", (9000, 10000, 11000))

    def test_curves(self):
        """A curve a variant in each panel, and its largest value marked."""
        study = Study(self.path)
        plot = draw_speed_curves(study)
        self.assertEqual(len(plot.axes), 4)
        force, web = plot.axes[1], plot.axes[2]
        self.assertEqual([line.get_gid() for line in force.get_lines() if len(line.get_xdata()) > 1],
                         [variant.name for variant in study.variants])
        marks = [(line.get_xdata()[0], line.get_ydata()[0]) for line in force.get_lines() if len(line.get_xdata()) == 1]
        self.assertEqual(marks, [(2000, 12000), (3000, 11000)])
        self.assertEqual(list(web.get_lines()[0].get_ydata()), [90, 120, 100])
        self.assertIn("web", web.get_ylabel())

    def test_chapter(self):
        """Largest values with their speeds and places, and rising speeds with too much."""
        study = Study(self.path)
        _, peaks, exceedances = list(tell_responses(study, ["a plot"]))
        name = study.variants[0].name
        self.assertIn([name, "largest force", "", 12000.0, "N", 2000.0], peaks.rows)
        self.assertIn([name, "amplification", "web", 1.5, "-", 2000.0], peaks.rows)
        self.assertEqual(exceedances.rows[0], [name, "web", 1500.0, 2500.0, 1.3, 2000.0])
        self.assertEqual(len(exceedances.rows), 2)
        # Their speeds differ: 2000 and 3000 rpm.
        self.assertIn(["largest contact force", 11000.0, study.variants[1].name, 12000.0, name, "N"],
                      [row[:6] for row in list_ranges(study)])

    def test_stresses(self):
        """Of one folder: with and without vibration."""
        plot = draw_stress_response(RunFolder(self.path / "run_01"))
        without, largest = plot.axes[1].get_lines()
        self.assertEqual(list(without.get_ydata()), [80, 80, 80])
        self.assertEqual(list(largest.get_ydata()), [45, 60, 50])


class Speeds(FolderTest):
    def setUp(self):
        super().setUp()
        write_sweep(self.path, (3000, 2000, 6000, 4000))

    def test_axis(self):
        """By rising speed, whatever the order of the runs; the modes that stand in space and take part
        in the turn; order n meets f at 60 f/(27 n) rpm."""
        axis = find_axis(find_variants(self.path))
        self.assertEqual(axis.label, "speed [rpm]")
        self.assertEqual(list(axis.values), [2000, 3000, 4000, 6000])
        speeds, beside = find_speeds(axis), read_beside(self.path)
        self.assertAlmostEqual(speeds.frequency_of_one, 27 / 60)
        self.assertEqual([list(m.frequencies) for m in choose_modes(beside, speeds)], 4 * [[900, 1800]])
        found = list_critical_speeds(beside, speeds)
        self.assertEqual([(f, n) for f, n, _ in found], [(900, 1), (1800, 2), (1800, 1)])
        self.assertAlmostEqual(found[2][2], 4000)

    def test_responses(self):
        """Those of other models by their names, upwards and downwards, and where they are largest."""
        study = Study(self.path)
        plot = draw_resonance(study)
        names = {line.get_gid() for line in plot.axes[0].get_lines()}
        for model in ("lumped model", "reduced pair"):
            for direction in ("up", "down"):
                self.assertIn(f"{model}, peak to peak, speed {direction}", names)
        sentences = " ".join(list_sentences(study.speeds, study.beside))
        self.assertIn("In the reduced pair the peak to peak dte is largest at 5000 rpm", sentences)

    def test_waterfall(self):
        """Mesh and free line with their amplitudes; between two bins of four a line loses 1 % at most (Hann)."""
        axis = find_axis(find_variants(self.path))
        header, rows = draw_waterfall(Study(self.path), "dte").vfife_numbers
        self.assertEqual(header[0], "speed [rpm]")
        rows = np.array(rows, dtype=float)
        for speed in axis.values:
            of_speed = rows[rows[:, 0] == speed]
            at_mesh = np.argmin(abs(of_speed[:, 2] - 1))
            spacing = speed * 27 / 60 / 20
            free = of_speed[abs(of_speed[:, 1] - FREE_LINE) < spacing]
            self.assertTrue(0.98 < free[:, 3].max() < 1.02)
            self.assertAlmostEqual(of_speed[at_mesh, 3], 2, delta=0.02)

    def test_report(self):
        main([str(self.path)])
        text = (self.path / "report.html").read_text()
        for words in ("Results over speed", "Spectra of the transmission error at each",
                      "computed at 20000 rpm", "Speeds at which mesh orders 1 to 3"):
            self.assertIn(words, text)
        with open(self.path / "pictures" / "resonance.csv", encoding="utf-8", newline="") as file:
            curve = [row for row in csv.DictReader(file) if row["curve"] == "runs, peak to peak"]
        self.assertEqual([float(row["x"]) for row in curve[:4]], [2000, 3000, 4000, 6000])
        # Sums of both lines: between the larger one's and both together.
        for row in curve[:4]:
            self.assertTrue(4 < float(row["y"]) <= 6)


class Axes(FolderTest):
    def test_any_number(self):
        """Three thicknesses make curves, two do not, and neither do words."""
        for count, thickness in enumerate(("5 mm", "3.5 mm", "6.5 mm"), 1):
            folder = self.path / f"run_{count}"
            folder.mkdir()
            write_run(folder, thickness, fields=False)
            axis = find_axis(find_variants(self.path))
            self.assertEqual(axis is None, count < 3)
        self.assertEqual(axis.label, "web thickness [mm]")
        self.assertEqual(list(axis.values), [3.5, 5, 6.5])
        self.assertIsNone(find_speeds(axis))
        labels = [axes.get_xlabel() for axes in draw_curves(Study(self.path)).axes]
        self.assertEqual(set(labels), {"web thickness [mm]"})
        write_parameters(self.path / "run_3", make_parameters("thick"))
        self.assertIsNone(find_axis(find_variants(self.path)))


    def test_general_model(self):
        """Without a gear pair: what probes and contact reach."""
        for count in (1, 2, 3):
            folder = self.path / f"run_{count}"
            folder.mkdir()
            (folder / "history.csv").write_text(
                "time [s],contact force total [N],tip displacement x [mm],tip displacement y [mm]\n"
                f"0,0,0,0\n1,0,{-count},0\n2,0,{0.5 * count},0\n")
            write_parameters(folder, {"Dynamics/mass proportional damping": (f"{count} 1/s", "1/s")})
        axis = find_axis(find_variants(self.path))
        self.assertEqual(axis.label, "mass proportional damping [1/s]")
        (panel,) = draw_curves(Study(self.path)).axes
        self.assertEqual(panel.get_title(loc="left"), "tip displacement, largest x")
        self.assertEqual(list(panel.lines[0].get_ydata()), [1, 2, 3])


class OtherFolders(FolderTest):
    """What lies beside the cases of a study, in its folder, is none of them."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name)
        for name in ("one", "two", "previous", "run_03"):
            (self.path / name).mkdir()
            (self.path / name / "figures.json").write_text("{}")

    def names(self):
        return [variant.run.path.name for variant in find_variants(self.path)]

    def test_folder_of_runs(self):
        self.assertEqual(self.names(), ["one", "run_03", "two"])

    def test_comparison(self):
        cases = [{"name": name, "kind": "run", "folder": name} for name in ("two", "one")]
        (self.path / "comparison.json").write_text(json.dumps({"cases": cases, "rows": []}))
        self.assertEqual(self.names(), ["two", "one"])

    def test_sweep(self):
        (self.path / "sweep.csv").write_text("run,status\nrun_03,finished\n")
        self.assertEqual(self.names(), ["run_03"])

    def test_another_kind(self):
        """Modes have neither histories nor figures: folders below are still no variants of them."""
        write_parameters(self.path, {"Study/kind": ("modal", "")})
        self.assertEqual(self.names(), [])


class Errors(FolderTest):
    def setUp(self):
        """Two webs, each on two meshes; the second one's coarse mesh has failed."""
        super().setUp()
        for count, thickness in enumerate(("5 mm", "5 mm", "3.5 mm", "3.5 mm"), 1):
            (self.path / f"run_0{count}").mkdir()
            write_run(self.path / f"run_0{count}", thickness, fields=False)
        (self.path / "sweep.csv").write_text(
            "run,thickness,cells,status\nrun_01,5 mm,4,finished\nrun_02,5 mm,8,finished\n"
            "run_03,3.5 mm,4,failed\nrun_04,3.5 mm,8,finished\n")
        (self.path / "error_bars.csv").write_text(
            "quantity,variant,run,unit,value [unit],error [unit],error by cells [unit],method\n"
            "dte mean,thickness = 5 mm,run_02,arcsec,-80.25,2.14,2.14,cells: spread of 2 values\n"
            'dte mean,thickness = 3.5 mm,run_04,arcsec,-79.125,nan,nan,"cells: not known, 1 of 2 values, without run_03"\n'
            "ripple,thickness = 5 mm,run_02,-,3,0.012,0.012,cells: spread of 2 values\n"
            "ripple,thickness = 3.5 mm,run_04,-,3.5,0.6,0.6,cells: spread of 2 values\n"
            "lost,thickness = 5 mm,run_02,-,0,0,0,cells: spread of 2 values\n"
            "lost,thickness = 3.5 mm,run_04,-,0,0,0,cells: spread of 2 values\n")
        (self.path / "differences.csv").write_text(
            "quantity,variant,other variant,unit,difference [unit],error of the difference [unit],"
            "sum of both errors [unit],verdict\n"
            "dte mean,thickness = 5 mm,thickness = 3.5 mm,arcsec,-1.125,nan,nan,not known\n"
            "ripple,thickness = 5 mm,thickness = 3.5 mm,-,-0.5,0.588,0.612,not significant\n"
            "lost,thickness = 5 mm,thickness = 3.5 mm,-,0,0,0,not significant\n")

    def test_variants(self):
        """Runs that differ by the mesh alone are no variants."""
        study = Study(self.path)
        self.assertEqual([v.run.path.name for v in study.variants], ["run_02", "run_04"])
        self.assertEqual(study.error_bars.unfinished, [("run_03", "failed")])

    def test_plot(self):
        """A panel for what differs, an error bar for each known error, a cross for the others."""
        panels = draw_error_bars(Study(self.path)).axes
        self.assertEqual([axes.get_title(loc="left") for axes in panels], ["dte mean [arcsec]", "ripple"])
        (bars,) = panels[0].containers
        (segment,) = bars[2][0].get_segments()
        for value, known in zip(segment[:, 0], (-82.39, -78.11)):
            self.assertAlmostEqual(value, known)
        self.assertEqual([list(line.get_xdata()) for line in panels[0].lines if line.get_marker() == "x"], [[-79.125]])

    def test_report(self):
        main([str(self.path)])
        text = (self.path / "report.html").read_text()
        for words in ("Error bars", "run_03 (failed)", "\u221280.2 ± 2.1", "\u221279.125 ± ?", "3.000 ± 0.012", "3.50 ± 0.60",
                      "without run_03"):
            self.assertIn(words, text)
        self.assertNotIn("Lost of all variants", text)

    def test_single_case(self):
        """A case on several meshes, without variants: a row per quantity."""
        (self.path / "error_bars.csv").write_text(
            "quantity,variant,run,unit,value [unit],error [unit],error by cells [unit],method\n"
            "dte mean,the case,run_02,arcsec,-80.25,2.14,2.14,cells: spread of 2 values\n"
            "ripple,the case,run_02,-,3,0.012,0.012,cells: spread of 2 values\n")
        (self.path / "differences.csv").unlink()
        *_, table = tell_error_bars(Study(self.path), [])
        self.assertEqual(table.header, ["quantity", "value", "unit", "error by cells", "method"])
        self.assertEqual([row[:4] for row in table.rows],
                         [["dte mean", "\u221280.2 ± 2.1", "arcsec", 2.14], ["ripple", "3.000 ± 0.012", "-", 0.012]])

    def test_verdicts(self):
        ripple = Study(self.path).error_bars.quantities[1]
        self.assertEqual(ripple.list_others("thickness = 5 mm", "not significant"), ["thickness = 3.5 mm"])
        self.assertEqual(ripple.list_others("thickness = 5 mm", "sign significant"), [])


class Sidebands(FolderTest):
    def run_of(self, name, meshes):
        write_pair(Path(name), 20000, meshes, lambda at, f: np.cos(2 * np.pi * at) * (
            1 + 0.2 * np.cos(2 * np.pi * at / 27)))
        return RunFolder(name)

    def test_two_revolutions(self):
        """An amplitude that varies by 20 % once a turn of the pinion is two sidebands of 10 %."""
        run = self.run_of(self.path, 54)
        rows = [row for row in list_sidebands(run) if row[0] == "dte"]
        self.assertEqual([row[1:3] for row in rows], [[n, "pinion"] for n in (1, 2, 3)])
        for row, sizes in zip(rows, ((0.1, 1, 0.1), (0, 0, 0), (0, 0, 0))):
            for value, known in zip(row[4:7], sizes):
                self.assertAlmostEqual(value, known, places=9)
        self.assertIsNotNone(draw_sidebands(run))
        lines = {row[1] for row in list_other_lines(run) if row[0] == "dte"}
        sidebands = {f"mesh order 1, {sign}1 rotation of the pinion" for sign in "+-"}
        self.assertEqual(lines & sidebands, sidebands)
        text = describe_resolution(run)
        self.assertIn("gear (114 Hz) are not resolved; they need 158", text)
        self.assertNotIn("pinion", text)

    def test_too_short(self):
        run = self.run_of(self.path, 53)
        self.assertEqual(list(list_sidebands(run)), [])
        self.assertIsNone(draw_sidebands(run))
        self.assertIn("pinion (333 Hz) are not resolved", describe_resolution(run))


if __name__ == "__main__":
    unittest.main()
