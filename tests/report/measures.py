#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers of reports against closed forms: periodicity, lines, passages, waves, ledger, words."""
import json
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

from made_up_run import (  # first: ends the test without the libraries
    FolderTest, make_parameters, make_summary, quantity, write_parameters, write_run)

import numpy as np

from vfife_report.data.naming import name_variants
from vfife_report.data.parameters import read_parameters
from vfife_report.data.run_folder import RunFolder
from vfife_report.data.table import Table
from vfife_report.measures.checks import list_checks
from vfife_report.measures.ledger import list_ledger_rows, read_ledger
from vfife_report.measures.lines import find_harmonics, find_lines
from vfife_report.measures.passages import find_engagement, find_passage
from vfife_report.measures.periodicity import fold_meshes, measure_periodicity
from vfife_report.measures.quantities import remark
from vfife_report.measures.spectrum import compute_directed_spectrum, compute_spectrum
from vfife_report.measures.waves import (
    list_wave_lines, list_wave_spectra, measure_waves, read_wave, split_wave)
from vfife_report.page.words import list_case_rows, list_sentences, make_title

# As the program wrote it before there was a parameters.json.
EARLIER_PARAMETERS = """# Listing of Parameters
subsection Gear pair
  subsection Pinion
    subsection Blank
      # Number of teeth [-]
      set number of teeth = 27 # default: 0
    end
  end
  subsection Gear
    subsection Body
      # Thickness of the web, normal
      # to it (not negative) [mm]
      set web thickness   = 5.0
      set web inclination = 70 deg
    end
  end
end
subsection Operation
  set speed  = 20000 rpm # default: 0
end
"""
SAMPLES = 50.0
MESHES = np.arange(26 * 50 + 1) / SAMPLES


class Periodicity(unittest.TestCase):
    def test_fold(self):
        folded = fold_meshes(3.0 * np.arange(200), 12.5)
        self.assertEqual(folded.shape, (15, 12))
        # Between samples a line is met exactly.
        self.assertLess(np.abs(np.diff(folded, axis=0) - 37.5).max(), 1e-10)
        # Whole meshes up to the last value: 15 of them before 199.
        self.assertAlmostEqual(folded[0, 0], 3 * (199 - 15 * 12.5))

    def test_periodic(self):
        found = measure_periodicity(4 + 2 * np.cos(2 * np.pi * MESHES), SAMPLES)
        self.assertEqual(found.meshes, 26)
        self.assertAlmostEqual(found.ripple, 4)
        for number in (found.change, found.largest_change, found.trend, found.remainder):
            self.assertLess(abs(number), 1e-12)
        self.assertAlmostEqual(found.periodic_share, 1)

    def test_slow_line(self):
        """Four periods of 6.5 meshes: the mean mesh knows nothing of them, consecutive meshes differ
        by 2 A sin(pi/6.5) at most."""
        values = 2 * np.cos(2 * np.pi * MESHES) + 0.5 * np.cos(2 * np.pi * MESHES / 6.5)
        found = measure_periodicity(values, SAMPLES)
        self.assertAlmostEqual(found.ripple, 4)
        self.assertAlmostEqual(found.remainder, 0.5 / np.sqrt(2))
        # 25 differences are not whole periods: an allowance of one in 25.
        change = 2 * 0.5 * np.sin(np.pi / 6.5)
        self.assertAlmostEqual(found.change / (change / np.sqrt(2)), 1, delta=0.02)
        self.assertAlmostEqual(found.largest_change / change, 1, delta=0.01)
        self.assertAlmostEqual(found.periodic_share, 2 / (2 + 0.125))

    def test_trend(self):
        found = measure_periodicity(0.3 * MESHES + np.sin(2 * np.pi * MESHES), SAMPLES)
        self.assertAlmostEqual(found.trend, 0.3)
        self.assertIsNone(measure_periodicity(np.zeros(60), SAMPLES))

    def test_harmonics(self):
        values = (0.3 * np.sin(2 * np.pi * MESHES / 6.5) + 2.5 * np.cos(2 * np.pi * 3 * MESHES)
                  + 0.2 * np.sin(2 * np.pi * MESHES))
        for amplitude, known in zip(find_harmonics(values, SAMPLES, 4), (0.2, 0, 2.5, 0)):
            self.assertAlmostEqual(amplitude, known)

    def test_lines(self):
        """Two lines between the harmonics at any place between the bins (346 Hz apart), beside a
        harmonic a hundred times as large."""
        for shift in np.linspace(0, 1, 7):
            low, side = 1385 + 346 * shift, 20400 + 346 * shift
            time = MESHES / 9000
            values = (100 * np.cos(2 * np.pi * MESHES) + np.cos(2 * np.pi * low * time)
                      + 0.5 * np.sin(2 * np.pi * side * time))
            lines = find_lines(values, SAMPLES, 9000, 0, 6000, 3)
            self.assertEqual(len(lines), 1)
            self.assertAlmostEqual(lines[0].frequency, low, delta=0.02 * 346)
            # The mean mesh takes what lies at multiples of 9 kHz, little of the line.
            self.assertAlmostEqual(lines[0].amplitude, 1, delta=0.01)
            above = find_lines(values, SAMPLES, 9000, 9000, 31500, 3)
            self.assertAlmostEqual(above[0].frequency, side, delta=0.02 * 346)
            self.assertAlmostEqual(above[0].amplitude, 0.5, delta=0.005)
        self.assertEqual(find_lines(np.cos(2 * np.pi * MESHES) * 0, SAMPLES, 9000, 0, 9000, 3), [])


    def test_half_the_sampling_rate(self):
        """Ten samples a mesh: the fifth order is once in the transform, the others twice; near it no line is made up."""
        place = np.arange(80)
        values = 3 * np.cos(2 * np.pi * place / 10) + 0.7 * (-1.0) ** place
        order, amplitude = compute_spectrum(values, 10)
        np.testing.assert_allclose(amplitude[[8, 40]], [3, 0.7], rtol=1e-12)
        self.assertEqual(order[40], 5)
        self.assertLess(np.delete(amplitude, [8, 40]).max(), 1e-12)
        np.testing.assert_allclose(find_harmonics(values, 10, 5), [3, 0, 0, 0, 0.7], atol=1e-12)
        self.assertAlmostEqual(compute_spectrum(values, 10, points_per_line=4)[1][-1], 0.7)
        # Of nine samples a mesh it is no harmonic, and nothing is told of a line that meets its image.
        self.assertEqual(find_lines((-1.0) ** np.arange(90), 9, 1.0, 0, 5, 3), [])

    def test_points_between_lines(self):
        """Four points a line: the third order stays where it is, with its amplitude."""
        order, amplitude = compute_spectrum(2 * np.cos(2 * np.pi * 3 * MESHES)[:-1], SAMPLES, windowed=True,
                                            points_per_line=4)
        top = np.argmax(amplitude)
        self.assertAlmostEqual(order[top], 3)
        self.assertAlmostEqual(amplitude[top], 2)
        self.assertAlmostEqual(order[top + 4], 3 + 1 / 26)
        self.assertAlmostEqual(amplitude[top + 4], 1)  # half of it a line beside it


class Checks(unittest.TestCase):
    def check(self, errors, mean, losses, swing=0.3):
        """Verdict and value of each check of a run with energy errors before and in its steady part, a mean
        contact torque [N m] under a load of 800 N m, and losses of contact."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            write_run(folder, fields=False)
            (folder / "history.csv").write_text("time [s],energy error [-]\n" + "".join(
                f"{t:g},{error}\n" for t, error in zip((0, 1e-4, 2e-4, 6e-4, 1e-3), errors)))
            summary = make_summary()
            summary["steady part"]["columns"]["contact torque on the gear"] = {
                "mean": mean, "peak to peak": 1, "standard deviation": 1, "unit": "N m"}
            summary["contact losses"]["count"] = losses
            summary["energy"]["removed by the driven speed damping from the torsional mode"] = {"value": swing, "unit": "mJ"}
            (folder / "summary.json").write_text(json.dumps(summary))
            return {name: (verdict, value) for name, value, _, verdict in list_checks(RunFolder(name))}

    def test_met(self):
        """Half a per cent of energy and torque: of the steady part alone, whatever their sign."""
        found = self.check((0, -0.02, 0.001, -0.0049, 0.002), 796.8, 0)
        self.assertEqual(found["largest energy error of the steady part"], ("met", "0.49 %"))
        self.assertEqual(found["largest energy error of the whole run"], ("no criterion", "2 %"))
        self.assertEqual(found["mean contact torque against the load"], ("met", "-0.400 %"))
        self.assertEqual(found["tooth separations"], ("met", "0"))
        self.assertEqual(found["input conflicts"], ("not met", "1"))

    def test_not_met(self):
        found = self.check((0, 0, 0, -0.0051, 0), 804.4, 2)
        self.assertEqual(found["largest energy error of the steady part"], ("not met", "0.51 %"))
        self.assertEqual(found["mean contact torque against the load"], ("not met", "+0.550 %"))
        self.assertEqual(found["tooth separations"], ("not met", "2"))

    def test_mesh_damping(self):
        """It removes energy from the torsional mode; otherwise it excites it."""
        name = "energy removed by the speed controller from the torsional mode"
        self.assertEqual(self.check((0,) * 5, 800, 0)[name], ("met", "0.3 mJ"))
        self.assertEqual(self.check((0,) * 5, 800, 0, -0.3)[name], ("not met", "-0.3 mJ"))


class SpeedSweep(FolderTest):
    """A reduced pair at many speeds has no speed of its own."""

    def setUp(self):
        super().setUp()
        write_parameters(self.path, {**make_parameters(), "Study/kind": ("reduced", ""), "Operation/mesh cycles": ("40", "-"),
                                     "Operation/torque": ("0", "N m"), "Operation/pinion torque": ("265 N m", "N m"),
                                     "Reduced/sweep": ("up", ""), "Reduced/lowest speed": ("8000 rpm", "rpm"),
                                     "Reduced/highest speed": ("9000 rpm", "rpm"), "Reduced/speeds": ("3", "-"),
                                     "Reduced/settling mesh cycles": ("2", "-"), "Reduced/recorded mesh cycles": ("4", "-")})
        (self.path / "resonance.csv").write_text("direction,speed [rpm],energy error [-]\nup,8000,0.001\nup,8500,-0.02\nup,9000,0.0049\n")
        summary = {"status": "finished", "input conflicts": [], "warnings": [], "run": {"time": quantity(2e-3, "s"), "steps": 900, "run time": quantity(1, "s"), "ranks": 1}, "figures": {
            "speeds": quantity(3), "lowest speed": quantity(8000, "rpm"), "highest speed": quantity(9000, "rpm"),
            "transmission error near the cut-off": quantity(8.18, "arcsec"), "mesh order near the cut-off": quantity(8)}}
        (self.path / "summary.json").write_text(json.dumps(summary))
        self.run_folder = RunFolder(self.path)

    def test_words(self):
        self.assertEqual(make_title(self.run_folder), "Spiral bevel gear pair 27/79, web 5 mm at 70 deg, pinion from 8000 rpm to "
                         "9000 rpm, 265 N m on the pinion: reduced")
        rows = dict(list_case_rows(self.run_folder))
        self.assertEqual(rows["speeds of the pinion"], "3 from 8000 rpm to 9000 rpm, up")
        self.assertEqual(rows["mesh cycles per speed"], "2 to settle, 4 recorded")
        self.assertNotIn("mesh cycles", rows)
        self.assertNotIn("operating speed of the pinion", rows)
        self.assertEqual(next(list_sentences(self.run_folder)).split(".")[0], "The pinion of the spiral bevel gear pair 27/79 rotates at "
                         "3 speeds from 8000 to 9000 rpm")

    def test_energy_of_single_speeds(self):
        found = {name: (value, verdict) for name, value, _, verdict in list_checks(self.run_folder)}
        self.assertEqual(found["largest energy error of a speed"], ("2 % at 8500 rpm, 1 of 3 speeds above the limit", "not met"))

    def test_remark(self):
        self.assertEqual(remark(self.run_folder, "dte, peak to peak of the record"), "includes 8.18 arcsec of mesh order 8, above half the cut-off")
        self.assertEqual(remark(self.run_folder, "dte, mean"), "")


class Passages(FolderTest):
    def test_bump(self):
        """A Gaussian over 20 MPa reaches a tenth at 2.146 standard deviations on either side."""
        time = np.linspace(0, 4, 2001)
        found = find_passage(time, 20 + 80 * np.exp(-0.5 * ((time - 3) / 0.1) ** 2), 20)
        self.assertFalse(found.is_dip)
        self.assertAlmostEqual(found.duration, 0.2 * np.sqrt(2 * np.log(10)), delta=0.004)
        self.assertTrue(found.whole)

    def test_dip(self):
        """The stress falls from 59 to 38 MPa while the probe passes: its peak is not what it falls to."""
        time = np.linspace(0, 4, 2001)
        ripple = 0.9 * np.sin(2 * np.pi * 3 * time)
        self.assertTrue(find_passage(time, 58 + ripple - 19 * np.exp(-0.5 * ((time - 2.25) / 0.1) ** 2), 58).is_dip)

    def test_part_of_turn(self):
        """A record that has little besides the passage: by its own median the stress dips, by that of the turn it rises."""
        time = np.linspace(0, 4, 2001)
        stress = 22 + 36 * np.sin(np.pi * time / 8) ** 0.5
        self.assertTrue(find_passage(time, stress, np.median(stress)).is_dip)
        found = find_passage(time, stress, 26)
        self.assertFalse(found.is_dip)
        self.assertFalse(found.whole)

    def test_cut(self):
        time = np.linspace(0, 3.05, 1000)
        self.assertFalse(find_passage(time, 20 + 80 * np.exp(-0.5 * ((time - 3) / 0.1) ** 2), 20).whole)
        self.assertIsNone(find_passage(time, np.ones(1000), 1))

    def test_engagement(self):
        path = self.path / "teeth.csv"
        rows = [(t, side, tooth) for tooth, side, first, last in (
            (0, "drive", 0, 5), (26, "drive", 2, 6), (25, "drive", 4, 8), (24, "drive", 7, 9),
            (1, "coast", 3, 4)) for t in range(first, last + 1)]
        path.write_text("time [s],side,pinion tooth [-],gear tooth [-],force [N]\n" + "".join(
            f"{t},{side},{tooth},{27 - tooth},1\n" for t, side, tooth in sorted(rows)))
        teeth = Table(path)
        found = find_engagement(teeth, 0, 9)
        self.assertEqual((found.pinion_tooth, found.whole), (25, True))
        self.assertEqual(list(teeth["time"][found.rows]), [4, 5, 6, 7, 8])
        self.assertFalse(find_engagement(teeth, 2, 6).whole)


class Waves(FolderTest):
    def test_pattern_and_wave(self):
        write_run(self.path, fields=False)
        run = RunFolder(self.path)
        rim, rate = run.rim, run.gear_rate()
        self.assertAlmostEqual(rate, -200 * np.pi)
        pattern, rest = split_wave(read_wave(rim, "z", 1), 1, run.gear_turn(rim["time"]))
        self.assertAlmostEqual(abs(pattern), 20, places=6)  # digits of the file
        self.assertLess(np.abs(rest).max(), 1e-6)
        rows = rim["time"] < 0.9999e-3  # nine periods of 9 kHz
        wave = read_wave(rim, "z", 3)[rows]
        frequency, amplitude = compute_directed_spectrum(wave, 1e-5)
        top = np.argmax(amplitude)
        self.assertAlmostEqual(frequency[top], 9000, places=3)
        self.assertAlmostEqual(amplitude[top], 0.1, places=6)
        self.assertLess(amplitude[frequency < 0].max(), 1e-6)  # travels in the + sense only
        # The gear turns in the - sense; the steady part is 7.2 periods.
        lines = [line for line in list_wave_lines(run) if line[0] == "3"]
        self.assertEqual(lines[0][1], "backward")
        self.assertAlmostEqual(lines[0][2], 9000, delta=100)
        self.assertAlmostEqual(lines[0][3], 0.1, delta=0.002)


class MadeUpRim(dict):
    """rim.csv of waves that are written down: those of z are asked for."""

    RATE = -2 * np.pi * 114  # 6835 rpm, against its axis
    TIME = np.arange(1000) / 1000 * 10 / 114  # ten revolutions

    def __init__(self):
        super().__init__(time=self.TIME)
        turn = self.RATE * self.TIME
        # u(alpha) = Re(C exp(-i n alpha)) in the turning gear. What stands in space, cos n (alpha + turn) and so on, has
        # C = exp(-i n turn); a wave with the axis has positive frequencies.
        waves = {0: 7 + 0.4 * np.cos(40 * turn),
                 1: 20 * np.exp(-1j * (turn + 0.3)) + 0.6 * np.exp(25j * turn),
                 2: 5 * np.exp(-2j * turn) + 0.8 * np.cos(30 * turn)}
        for component, factor in (("r", 2), ("theta", 0), ("z", 1)):
            for n, wave in waves.items():
                self[f"{component} cos {n}"] = factor * wave.real
                if n:
                    self[f"{component} sin {n}"] = factor * wave.imag

    @property
    def columns(self):
        return list(self)


class MadeUpRimRun:
    rim = MadeUpRim()

    def steady_rows(self, table):
        return slice(None)

    def gear_rate(self):
        return MadeUpRim.RATE

    def gear_turn(self, time):
        return MadeUpRim.RATE * time


class WaveShares(unittest.TestCase):
    def test_shares(self):
        """What stands in space is the amplitude of one wave, the rest its root mean square: a travelling wave's amplitude, a
        vibration's over the root of two."""
        standing, moving = measure_waves(MadeUpRimRun.rim, slice(None), MadeUpRim.RATE * MadeUpRim.TIME)
        self.assertEqual(standing.shape, (3, 3))
        known = np.array([7, 20, 5])
        rest = np.array([0.4 / np.sqrt(2), 0.6, 0.8 / np.sqrt(2)])
        for k, factor in enumerate((2, 0, 1)):  # radial, tangential, axial
            self.assertLess(np.abs(standing[k] - factor * known).max(), 1e-9)
            self.assertLess(np.abs(moving[k] - factor * rest).max(), 1e-9)

    def test_spectra(self):
        """Lines in their direction: 0.6 at 25 turns a second of a gear that turns against its axis, with which the
        wave runs; 0.8 in the gear are 0.4 in either direction; without diameters there is one direction with all of it."""
        def top(n):
            return {name: (frequency[np.argmax(amplitude)], amplitude.max())
                    for name, frequency, amplitude in list_wave_spectra(MadeUpRimRun(), n)}

        self.assertEqual(list(top(0)), ["backward"])
        frequency, amplitude = top(0)["backward"]
        self.assertAlmostEqual(frequency, 40 * 114, delta=12)
        self.assertAlmostEqual(amplitude, 0.4, delta=0.01)
        frequency, amplitude = top(1)["forward"]
        self.assertAlmostEqual(frequency, 25 * 114, delta=12)
        self.assertAlmostEqual(amplitude, 0.6, delta=0.02)
        self.assertLess(top(1)["backward"][1], 0.05)
        for name in ("forward", "backward"):
            frequency, amplitude = top(2)[name]
            self.assertAlmostEqual(frequency, 30 * 114, delta=12)
            self.assertAlmostEqual(amplitude, 0.4, delta=0.02)


class Texts(FolderTest):
    def check_parameters(self, folder):
        found = read_parameters(folder)
        self.assertEqual(found["Gear pair/Gear/Body/web thickness"], "5.0 mm")
        self.assertEqual(found["Gear pair/Gear/Body/web inclination"], "70 deg")
        self.assertEqual(found["Gear pair/Pinion/Blank/number of teeth"], "27")
        self.assertEqual(found["Operation/speed"], "20000 rpm")

    def test_parameters(self):
        self.assertEqual(read_parameters(self.path), {})
        (self.path / "parameters.prm").write_text(EARLIER_PARAMETERS)
        self.check_parameters(self.path)
        (self.path / "parameters.prm").write_text("not looked at")
        write_parameters(self.path, make_parameters("5.0"))
        self.check_parameters(self.path)

    def test_names(self):
        runs = []
        for thickness in ("5", "3.5 mm"):
            folder = self.path / thickness
            folder.mkdir()
            write_run(folder, thickness, fields=False)
            runs.append(RunFolder(folder))
        self.assertEqual(make_title(runs[0]),
                         "Spiral bevel gear pair 27/79, web 5 mm at 70 deg, pinion at 20000 rpm, 800 N m on the gear")
        waves = {**runs[0].parameters, "Study/kind": "waves", "Waves/lowest speed": "8000 rpm", "Waves/highest speed": "9000 rpm"}
        self.assertEqual(make_title(SimpleNamespace(parameters=waves)), "Spiral bevel gear pair 27/79, web 5 mm at 70 deg, "
                         "pinion from 8000 rpm to 9000 rpm, 800 N m on the gear: waves")
        self.assertEqual(name_variants(runs), ["web 5 mm at 70 deg", "web 3.5 mm at 70 deg"])
        self.assertEqual(name_variants(runs[:1]), ["5"])

    def test_ledger(self):
        row = {"quantity": "mean dte", "unit": "arcsec", "value": -84.0, "reference": -80.0,
               "reference kind": "FEM", "difference": -4.0, "tolerance": 5.0, "verdict": "agrees",
               "reason": "finer mesh"}
        path = self.path / "comparison.json"

        def read(**changes):
            path.write_text(json.dumps({"title": "t", "rows": [{**row, **changes}]}))
            return read_ledger(path)["rows"]

        self.assertEqual(list(list_ledger_rows(read()))[0][4:6], [-4.0, -5.0])
        read(verdict="not judged", tolerance=None)
        read(verdict="not judged", value=None, difference=None)
        for wrong in ({"verdict": "fine"}, {"verdict": "differs"}, {"difference": 4.0},
                      {"tolerance": None}, {"value": None}, {"tolerance": 3.0}):
            with self.assertRaisesRegex(ValueError, "mean dte"):
                read(**wrong)
        path.write_text(json.dumps({"rows": [{"quantity": "mean dte"}]}))
        with self.assertRaisesRegex(ValueError, '"unit" is missing'):
            read_ledger(path)


if __name__ == "__main__":
    unittest.main()
