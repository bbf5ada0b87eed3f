#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Geometry and averages of the plots against closed forms, and all plots and pictures of a small made-up
run. Ends with 77 (skipped) without numpy or matplotlib."""
import html
import json
import tempfile
import unittest
from pathlib import Path

from made_up_run import (  # first: ends the test without the libraries
    FolderTest, CORNERS, make_pair, make_ring, write_run, write_vtu)

import numpy as np

from vfife_report.command import main
from vfife_report.data.fields import Fields, read_last_fields
from vfife_report.data.run_folder import RunFolder
from vfife_report.data.table import Table
from vfife_report.measures.periodicity import compute_mesh_average
from vfife_report.measures.spectrum import compute_spectrum
from vfife_report.pictures.canvas import Camera, Canvas
from vfife_report.pictures.hexahedra import Section, find_axis, find_outer_faces
from vfife_report.plots.bearings import draw_bearing_curves, draw_bearings, draw_misalignment
from vfife_report.plots.campbell import draw_whirl
from vfife_report.plots.driven_waves import draw_driven_waves, draw_growth, draw_waves_met
from vfife_report.plots.histories import draw_contact_force, draw_energies, draw_transmission_error
from vfife_report.plots.meridian import draw_meridians, read_parts
from vfife_report.plots.plot_data import list_curves
from vfife_report.plots.root_stress import draw_sections
from vfife_report.plots.run_up import compute_window_spectra, draw_orders
from vfife_report.plots.style import add_legend, plt, save


def make_block(cells):
    """Unit cubes, (cells, 8, 3)."""
    places = np.stack(np.meshgrid(*[np.arange(n) for n in cells], indexing="ij"), axis=-1)
    return places.reshape(-1, 1, 3) + CORNERS


def make_fields(points, body=0.0):
    return Fields(points, {"body": np.full(points.shape[:2], body)}, 0.0)


class Geometry(unittest.TestCase):
    def test_outer_faces(self):
        cells, faces = find_outer_faces(make_fields(make_block((3, 2, 4))))
        self.assertEqual(len(faces), 2 * (6 + 8 + 12))
        self.assertEqual(np.count_nonzero((faces == 0)), 6)  # below

    def test_section(self):
        """Area of the regular hexagon in a cube, and a linear field on it."""
        normal = np.ones(3) / np.sqrt(3)
        points = CORNERS[None]
        section = Section(points, np.full(3, 0.5), normal)
        corners = section.corners[0]
        area = 0.5 * np.linalg.norm(np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0))
        self.assertAlmostEqual(area, 0.75 * np.sqrt(3), places=5)  # the plane is moved
        values = points @ np.array([1.0, -2.0, 3.0])
        difference = section.interpolate(values)[0] - corners @ np.array([1.0, -2.0, 3.0])
        self.assertLess(np.abs(difference).max(), 1e-14)  # round-off of numbers near one
        along_faces = Section(make_block((2, 2, 2)), np.ones(3), np.array([0, 0, 1.0]))
        self.assertEqual(len(along_faces.cells), 4)

    def test_axis(self):
        turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
        centre = 50 * turn[:, 2]
        found = find_axis(make_ring(20, 30, 5, 24) @ turn.T + centre)[1]
        self.assertLess(np.linalg.norm(found - turn[:, 2]), 1e-12)

    def test_canvas(self):
        """The nearer of two squares hides the farther; half the picture stays empty."""
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
        for order in (1, -1):
            camera = Camera(np.array([0.5, 0.5, 0]), np.array([0, 0, 1.0]), np.array([0, 1.0, 0]),
                            2.0, (40, 20))
            canvas = Canvas(camera)
            near, far = square + [0, 0, 1], square
            quads, values = np.stack([near, far])[::order], np.array([[3.0] * 4, [1.0] * 4])[::order]
            canvas.draw(quads, values)
            drawn = np.isfinite(canvas.height)
            self.assertAlmostEqual(drawn.mean(), 0.5, delta=0.05)  # a pixel at each edge
            self.assertLess(np.abs(canvas.value[drawn] - 3).max(), 1e-6)  # single precision


class PiecesOfRanks(FolderTest):
    EMPTY = ('<VTKFile><UnstructuredGrid><Piece NumberOfPoints="0" NumberOfCells="0"/>'
             '</UnstructuredGrid></VTKFile>')

    def test_pieces(self):
        """Two ranks with halves of the cells, one without any."""
        folder, fields = self.path, make_pair()
        half = len(fields) // 2
        write_vtu(folder / "0.vtu", fields.take(slice(half)))
        write_vtu(folder / "1.vtu", fields.take(slice(half, None)))
        (folder / "2.vtu").write_text(self.EMPTY)
        (folder / "all.pvtu").write_text("<VTKFile><PUnstructuredGrid>" + "".join(
            f'<Piece Source="{k}.vtu"/>' for k in range(3)) + "</PUnstructuredGrid></VTKFile>")
        instants = "".join(f'<DataSet timestep="{time}" file="{file}"/>' for time, file in (
            ("0.001", "all.pvtu"), ("0.0005", "nothing.vtu")))
        pvd = folder / "fields.pvd"
        pvd.write_text(f"<VTKFile><Collection>{instants}</Collection></VTKFile>")
        read = read_last_fields(pvd)
        self.assertEqual(read.time, 1e-3)
        self.assertTrue(np.array_equal(read.points, fields.points))
        for key, values in fields.data.items():
            self.assertTrue(np.array_equal(read[key], values), key)
        (folder / "1.vtu").write_text((folder / "1.vtu").read_text()[:500])
        with self.assertRaisesRegex(ValueError, "damaged"):
            read_last_fields(pvd)
        pvd.write_text("<VTKFile><Collection/></VTKFile>")
        self.assertIsNone(read_last_fields(pvd))


class Histories(unittest.TestCase):
    def test_mesh_average(self):
        """Harmonics of the mesh vanish, a line stays, also with 12.5 samples a mesh."""
        at = np.arange(200)
        wave = 7 + 0.1 * at + np.sin(2 * np.pi * at / 10)
        average = compute_mesh_average(wave, 10.0)
        inside = np.isfinite(average)
        self.assertEqual(np.count_nonzero(inside), 190)
        self.assertLess(np.abs(average - 7 - 0.1 * at)[inside].max(), 1e-11)
        line = compute_mesh_average(3.0 * at, 12.5)
        self.assertLess(np.nanmax(np.abs(line - 3 * at)), 1e-10)

    def test_spectrum(self):
        at = np.arange(512)
        orders, amplitudes = compute_spectrum(4 + 2.5 * np.cos(2 * np.pi * at * 3 / 50), 50.0)
        self.assertAlmostEqual(orders[np.argmax(amplitudes)], 3)
        self.assertAlmostEqual(amplitudes.max(), 2.5, places=10)
        self.assertLess(np.sort(amplitudes)[-2], 1e-10)


class Meridians(FolderTest):
    def test_sections_of_a_shaft(self):
        """All of one kind: one colour, one row of the legend."""
        parts = ("rim", "shaft 1", "shaft 2")
        rows = [f"pinion,{part},{r},{z}" for part in parts for r, z in ((1, 0), (1, 2), (0, 2), (0, 0))]
        (self.path / "meridian.csv").write_text("\n".join(["body,part,r [mm],z [mm]", *rows, ""]))
        read = read_parts(self.path, "pinion")
        self.assertEqual(tuple(read), parts)
        axes, = draw_meridians([("pinion", read)]).axes
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["rim", "shaft"])
        colours = [patch.get_facecolor() for patch in axes.patches]
        self.assertEqual(colours[1], colours[2])
        self.assertNotEqual(colours[0], colours[1])


class RootSections(FolderTest):
    def test_steps(self):
        """A step as long as its section; tension of one member's fillets, then of the other's."""
        lines = ["body,fillet,face from [mm],face to [mm],tension [MPa],compression [MPa]"]
        for body, fillet, size in (("pinion", "concave", 200), ("pinion", "convex", 50), ("gear", "convex", 100)):
            lines += [f"{body},{fillet},0,10,{size},{-2 * size}", f"{body},{fillet},10,30,{size + 1},{-2 * size - 1}"]
        (self.path / "root_sections.csv").write_text("\n".join([*lines, ""]))
        pinion, gear = draw_sections(RunFolder(self.path)).axes
        steps = pinion.patches[0].get_data()
        self.assertEqual(list(steps.values), [200, 201])
        self.assertEqual(list(steps.edges), [0, 10, 30])
        self.assertEqual([list(p.get_data().values) for p in gear.patches], [[100, 101], [-200, -201]])
        self.assertEqual([p.get_label() for p in pinion.patches][2:], ["convex fillet, tension", "convex fillet, compression"])
        main([str(self.path)])
        self.assertIn("root_sections", (self.path / "report.html").read_text())


class Bearings(unittest.TestCase):
    def write(self, folder, first, rows):
        """Two bearings at each of the places of @p first, and a misalignment."""
        columns = ["force x [N]", "force y [N]", "force z [N]", "displacement x [um]", "radial force [N]",
                   "radial displacement [um]"]
        lines = [",".join([first, "bearing", *columns])]
        for k in range(rows):
            for name, force in (("pinion front", 900), ("gear inner", 400)):
                lines.append(f"{k},{name},{force},0,{-force / 2},1,{force},{force / 100}")
        (folder / "bearings.csv").write_text("\n".join([*lines, ""]))
        (folder / "misalignment.csv").write_text("\n".join(
            [f"{first},offset [um],pinion axial shift [um],gear axial shift [um],shaft angle error [arcmin]",
             *(f"{k},{100 + k},10,-70,2" for k in range(rows)), ""]))
        (folder / "bearing_curves.csv").write_text("\n".join(
            ["bearing,direction,displacement [um],force [N],stiffness [N/um]",
             *(f"pinion front,{d},{x},{100 * x},100" for d in ("radial", "axial") for x in (-2, 0, 2)), ""]))

    def test_of_run_and_analysis(self):
        for first, factor, label in (("time [s]", 1e3, "time [ms]"),
                                     ("position [mesh cycles]", 1, "position [mesh cycles]")):
            with tempfile.TemporaryDirectory() as name:
                self.write(Path(name), first, 4)
                run = RunFolder(name)
                forces, axial, ways = draw_bearings(run).axes
                self.assertEqual([line.get_label() for line in forces.lines], ["pinion front", "gear inner"])
                self.assertTrue(np.all(forces.lines[0].get_ydata() == 900))
                self.assertTrue(np.all(axial.lines[1].get_ydata() == -200))
                self.assertTrue(np.all(ways.lines[0].get_ydata() == 9))
                self.assertTrue(np.all(ways.lines[0].get_xdata() == factor * np.arange(4)))
                self.assertEqual(ways.get_xlabel(), label)
                shifts, angle = draw_misalignment(run).axes
                self.assertEqual(list(shifts.lines[0].get_ydata()), [100, 101, 102, 103])
                self.assertEqual(list(angle.lines[0].get_ydata()), [2] * 4)
                curves = draw_bearing_curves(run)
                radial, _ = curves.axes
                self.assertEqual(list(radial.lines[0].get_ydata()), [-0.2, 0, 0.2])
                curves.canvas.draw()
                # Another panel stands beside it: its legend is above its title.
                self.assertGreater(radial.get_legend().get_window_extent().y0, radial._left_title.get_window_extent().y1)
                main([name])
                page = (Path(name) / "report.html").read_text()
                for word in ("pinion front", "bearing_curves", "misalignment"):
                    self.assertIn(word, page)


class Whirl(unittest.TestCase):
    def test_axis_ends_above_the_lowest_vibrations(self):
        """Whirls far above the rotation frequency of 100 Hz are inside the axes; those near it leave its double."""
        for lowest, top in ((1500., 1.1 * 1530.), (120., 200.)):
            rows = "".join(f"gear,{speed},{mode},{lowest},1,0,backward,{lowest + 10 * mode * (speed > 0)},{whirl}\n"
                           for speed in (0, 6000) for mode, whirl in ((1, "backward"), (3, "forward")))
            with tempfile.TemporaryDirectory() as name:
                (Path(name) / "modes.csv").write_text(
                    "body,speed [rpm],mode [-],frequency [Hz],nodal diameter [-],nodal circles [-],direction,"
                    "fixed frequency [Hz],whirl\n" + rows)
                plot = draw_whirl(RunFolder(Path(name)), "gear")
                self.assertAlmostEqual(plot.axes[0].get_ylim()[1], top)
                plt.close(plot)


class DrivenWaves(unittest.TestCase):
    NAMES = "wave,nodal diameter [-],order [-],mesh order [-],solver"

    def write(self, folder, solvers):
        def table(name, columns, *rows):
            rows = [f"backward,4,1,1,{solver},{row}" for solver in solvers or ["none"] for row in rows]
            (folder / name).write_text("\n".join([f"{self.NAMES},{columns}", *rows, ""]))
        frequencies = [f"{wave},4,1,{speed},{3600 + sign * speed / 100}" for wave, sign in
                       (("forward", 1), ("backward", -1)) for speed in (0, 12000)]
        (folder / "waves_frequencies.csv").write_text("\n".join(
            ["wave,nodal diameter [-],order [-],speed [rpm],fixed frequency [Hz]", *frequencies, ""]))
        measured = "7810,5,0.02,0.01,0.011,1.2" if solvers else ",".join(["nan"] * 6)
        table("waves_lines.csv",
              "speed [rpm],speed in contact [rpm],mesh frequency [Hz],frequency [Hz],damping ratio [-],predicted width [-],"
              "predicted amplitude [um],peak speed [rpm],amplitude [um],width [-],damping ratio of the width [-],"
              "damping ratio of the build-up [-],stress amplification [-]",
              f"7750,7800,3510,3660,0.01,0.02,4.8,{measured}")
        if not solvers:
            return
        table("waves_response.csv", "speed [rpm],amplitude [um],linear amplitude [um],fitted amplitude [um]",
              *(f"{7800 + x},{5 - abs(x) / 50},{4.8 - abs(x) / 50},{5 - abs(x) / 50}" for x in (-50, 0, 50)))
        table("waves_build_up.csv", "time [s],amplitude [um],fitted amplitude [um]",
              *(f"{k * 1e-3},{5 - 5 / (k + 1)},{5 - 5 / (k + 1)}" for k in range(4)))
        (folder / "speeds_to_avoid.csv").write_text(
            "from [rpm],to [rpm],stress amplification [-],waves\n7600,8000,1.2,wave of 4 diameters\n")

    def test_predicted_and_driven(self):
        for driven in ((), ("reduced",), ("run", "reduced")):
            with tempfile.TemporaryDirectory() as name:
                self.write(Path(name), driven)
                run = RunFolder(name)
                axes, = draw_waves_met(run).axes
                rays = [line for line in axes.lines if line.get_ydata()[0] == 0]
                self.assertEqual(len(rays), 1)
                # A mesh order of 27 teeth: 5.4 kHz at 12,000 rpm; the disc lies on it.
                self.assertAlmostEqual(rays[0].get_ydata()[-1], 5.4, places=12)
                axes.figure.canvas.draw()
                order, = (one for one in axes.texts if one.get_text() == "mesh order 1")
                self.assertFalse(order.get_window_extent().overlaps(axes.get_window_extent()))
                speed, height = axes.collections[0].get_offsets()[0]
                self.assertEqual(speed, 7810 if driven else 7800)
                self.assertAlmostEqual(height, speed * 27 / 60e3, places=12)
                if driven:
                    panel, = draw_driven_waves(run).axes
                    self.assertEqual(list(panel.lines[1].get_ydata()), [4, 5, 4])
                    labels = [line.get_label() for line in panel.lines]
                    for solver, label in (("reduced", "reduced pair"), ("run", "run")):
                        self.assertEqual(labels.count(label), driven.count(solver))
                    growth, = draw_growth(run).axes
                    self.assertEqual(len(growth.lines), 2 * len(driven))
                    self.assertEqual(list(growth.lines[0].get_xdata()), [0, 1, 2, 3])
                main([name])
                page = (Path(name) / "report.html").read_text()
                self.assertIn("Travelling waves", page)
                self.assertEqual("Pinion speeds to avoid" in page, bool(driven))
                # Widths and damping ratios are shares: of what, stands above them.
                self.assertIn("width [% of the speed]", page)
                if driven:
                    self.assertIn("".join(f'<td class="number">{share}</td>' for share in (2, 2, 1, 1, 1.1)), page)


class RunUp(FolderTest):
    """A pair that runs up from 1000 to 3000 rpm in 0.2 s, its mesh frequency from 500 to 1500 Hz: order 1 of 4
    arcsec, order 2 of 1 arcsec."""

    def write(self, folder):
        write_run(folder, fields=False)
        time = np.linspace(0, 0.2, 8001)
        factor = 1 + 10 * time
        meshes = 500 * (time + 5 * time**2)
        rows = np.array([time, 1000 * factor, 500 * factor,
                         -80 + 4 * np.cos(2 * np.pi * meshes) + np.cos(4 * np.pi * meshes),
                         0 * time - 70, 9000 + 0 * time, 0 * time, 0 * time]).T
        (folder / "history.csv").write_text("\n".join(
            ["time [s],speed [rpm],mesh frequency [Hz],dte [arcsec],rim dte [arcsec],contact force total [N],"
             "energy error [-],strain energy [mJ]", *(",".join(map(repr, map(float, row))) for row in rows), ""]))
        (folder / "orders.csv").write_text(
            "time [s],speed [rpm],mesh frequency [Hz],mesh order [-],dte amplitude [arcsec],"
            "rim dte amplitude [arcsec],contact force total amplitude [N]\n"
            + "".join(f"{0.02 * k},{1000 * (1 + 0.2 * k)},{500 * (1 + 0.2 * k)},{order},{5 - order},0,10\n"
                      for k in range(1, 10) for order in (1, 2)))
        summary = json.loads((folder / "summary.json").read_text())
        del summary["figures"]["mesh frequency"], summary["steady part"]
        (folder / "summary.json").write_text(json.dumps(summary))
        for file in ("teeth.csv", "probes.csv", "rim.csv"):
            (folder / file).unlink()

    def test_plots(self):
        self.write(self.path)
        run = RunFolder(self.path)
        self.assertTrue(run.changes_speed())
        # -6000 rpm at the start: the integral of 1 + 10 t.
        turn = run.gear_turn(np.array([0.1, 0.2]))
        self.assertLess(np.abs(turn / (-200 * np.pi * np.array([0.15, 0.4])) - 1).max(), 1e-9)
        above, below = draw_orders(run).axes
        self.assertEqual([line.get_label() for line in above.lines], ["mesh order 1", "mesh order 2"])
        self.assertTrue(np.all(above.lines[0].get_ydata() == 4))
        self.assertTrue(np.all(below.lines[1].get_ydata() == 10))
        time, frequency, amplitude = compute_window_spectra(run.history["time"], run.history["dte"])
        mesh = np.interp(time, run.history["time"], run.history["mesh frequency"])
        top = frequency[np.argmax(amplitude, axis=1)]
        self.assertLess(np.abs(top / mesh - 1).max(), 0.1)
        main([str(self.path)])
        page = (self.path / "report.html").read_text()
        self.assertIn("changes from 1000 to 3000 rpm", page)
        drawn = {path.name for path in (self.path / "pictures").iterdir() if path.suffix == ".svg"}
        self.assertTrue({"orders.svg", "waterfall.svg", "dte.svg"} <= drawn)
        self.assertFalse({"spectra.svg", "sidebands.svg", "waterfall_force.svg"} & drawn)


class WholeRun(FolderTest):
    def test_all_pictures(self):
        write_run(self.path)
        main(["plots", str(self.path)])
        drawn = {path.name for path in (self.path / "pictures").iterdir() if path.suffix != ".csv"}
        self.assertEqual(drawn, {
            "dte.svg", "contact_force.svg", "load_sharing.svg", "contact_pattern.svg",
            "tooth_engagement.svg", "energies.svg", "probes.svg", "spectra.svg",
            "rim_content.svg", "rim_history.svg", "rim_waves.svg",
            "bodies.png", "teeth_in_mesh.png", "meridian_section.png", "deformation.png"})
        # The numbers beside a plot are those of the history; maps have none.
        table = Table(self.path / "pictures" / "contact_force.csv")
        total = table["curve"] == "total"
        self.assertEqual(np.count_nonzero(total), 101)
        self.assertTrue(np.all(table["y"][total] == 9000))
        self.assertFalse((self.path / "pictures" / "contact_pattern.csv").exists())

    def test_legends(self):
        """They stand beside the axes, where no curve is."""
        write_run(self.path, fields=False)
        run = RunFolder(self.path)
        for draw in (draw_transmission_error, draw_energies):
            plot = draw(run)
            plot.canvas.draw()
            legends = [(axes, axes.get_legend()) for axes in plot.axes if axes.get_legend()]
            self.assertTrue(legends)
            for axes, legend in legends:
                self.assertGreaterEqual(legend.get_window_extent().x0, axes.get_window_extent().x1)
                self.assertLessEqual(legend.get_window_extent().x1, plot.bbox.x1 + 1)

    def test_names_of_users(self):
        """An underscore in front or dollar signs make no name vanish, nor a formula of it."""
        names = ["_tip", "$a$ and $b$", "50 %", "a & b <c>", "cost$", "_"]
        plot, axes = plt.subplots()
        for name in names:
            axes.plot([0, 1], [0, 1], label=name)
        axes.plot([0, 1], [1, 1])
        axes.set_yticks([0, 1], ["$low$", "high"])
        add_legend(axes)
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], names)
        self.assertEqual([name for _, name, _ in list_curves(plot)], names + ["curve 1"])
        with tempfile.TemporaryDirectory() as folder, plt.rc_context({"svg.fonttype": "none"}):
            save(plot, Path(folder) / "names.svg")
            text = html.unescape((Path(folder) / "names.svg").read_text(encoding="utf-8"))
        for name in names[:-1] + ["$low$"]:
            self.assertIn(f">{name}</text>", text)

    def test_names_of_tooth_pairs(self):
        """As far as there is room for them."""
        for count, named in ((24, 24), (25, 0)):
            with tempfile.TemporaryDirectory() as name:
                write_run(Path(name), fields=False)
                (Path(name) / "teeth.csv").write_text(
                    "time [s],side,pinion tooth [-],gear tooth [-],force [N]\n" +
                    "".join(f"{k * 1e-5:g},drive,{k},{k},100\n" for k in range(count)))
                axes = draw_contact_force(RunFolder(Path(name))).axes[0]
                self.assertEqual(sum("/" in one.get_text() for one in axes.texts), named)
                self.assertEqual("pinion tooth/gear tooth" in axes.get_title(loc="left"), bool(named))

    def test_no_run(self):
        for folder, words in ((str(self.path), "neither histories nor fields"), (str(self.path / "a"), "no folder")):
            with self.assertRaisesRegex(SystemExit, words):
                main(["plots", folder])


if __name__ == "__main__":
    unittest.main()
