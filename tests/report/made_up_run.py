# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""A made-up run of two rings that pass for a gear pair: the files of its folder. Makes the package of
source/report importable; ends with 77 (skipped) without the libraries that it needs."""
import json
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "source" / "report"))
sys.dont_write_bytecode = True
try:
    import jinja2  # noqa: F401
    import matplotlib  # noqa: F401
    import meshio
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

from vfife_report.command import main  # noqa: E402
from vfife_report.data.fields import Fields  # noqa: E402
from vfife_report.plots.style import plt  # noqa: E402


class FolderTest(unittest.TestCase):
    """Each test has a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name)


CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                    [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)


def make_ring(inner, outer, length, teeth):
    """Cells around the z axis, each second one twice as high, as teeth are."""
    angle = 2 * np.pi / teeth
    unit = np.repeat(CORNERS[None], teeth, axis=0)
    turn = (unit[..., 1] + np.arange(teeth)[:, None]) * angle
    height = np.where(np.arange(teeth)[:, None] % 2, 2, 1) * length
    radius = inner + (outer - inner) * unit[..., 0]
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), height * unit[..., 2]], axis=-1)


def write_vtu(path, fields):
    """Bodies are data of cells, as the program writes them; each cell has its own eight points."""
    n = len(fields)
    units = {"displacement": " [mm]", "von mises": " [MPa]", "contact pressure": " [MPa]"}
    data = {name + units.get(name, ""): values.reshape((8 * n,) + values.shape[2:])
            for name, values in fields.data.items() if name != "body"}
    meshio.Mesh(fields.points.reshape(-1, 3), [("hexahedron", np.arange(8 * n).reshape(n, 8))],
                data, {"body": [fields["body"][:, 0]]}).write(path)


def make_pair():
    """Two rings with axes x and z that meet at the origin."""
    gear = make_ring(60, 80, 10, 24) + [0, 0, 40]
    pinion = make_ring(10, 40, 12, 12)[..., [2, 0, 1]] + [60, 0, 0]
    points = np.concatenate([gear, pinion])
    body = np.repeat([1.0, 0.0], [len(gear), len(pinion)])[:, None] * np.ones(8)
    pressure = np.where(np.linalg.norm(points - [70, 0, 40], axis=-1) < 12, 500.0, 0.0)
    data = {"body": body, "contact pressure": pressure, "von mises": 1.0 + points[..., 2] ** 2,
            "displacement": 1e-3 * points}
    return Fields(points, data, 1e-3)


def write_rim(folder, time):
    """Mean 80 um; one diameter of 20 um that stands in space; three diameters of 0.1 um at 9 kHz."""
    turn = 2 * np.pi * 100 * time  # the gear turns at -6000 rpm
    wave = 2 * np.pi * 9000 * time
    columns = {"time [s]": time}
    for component in ("r", "theta", "z"):
        columns[f"{component} cos 0 [um]"] = np.full(len(time), 80.0)
        for n in (1, 2, 3):
            size = {1: 20, 2: 0, 3: 0.1}[n]
            columns[f"{component} cos {n} [um]"] = size * np.cos(turn if n == 1 else wave)
            columns[f"{component} sin {n} [um]"] = size * np.sin(turn if n == 1 else wave)
    rows = np.array(list(columns.values())).T
    (folder / "rim.csv").write_text("\n".join(
        [",".join(columns)] + [",".join(f"{v:.12g}" for v in row) for row in rows]) + "\n")


def quantity(value, unit="-"):
    return {"value": value, "unit": unit}


def make_summary():
    columns = {name: {"mean": -80, "peak to peak": 2, "standard deviation": 0.7, "unit": "arcsec"}
               for name in ("dte", "rim dte")}
    return {
        "status": "finished", "version": "0", "revision": "made up",
        "figures": {"mesh frequency": quantity(9000, "Hz"), "gear torque": quantity(800, "N m")},
        "mesh": {"cells": 36, "bodies": [
            {"name": name, "cells": 12, "nodes": 48, "mass": quantity(1, "kg"),
             "speed at the start": quantity(speed, "rpm")}
            for name, speed in (("pinion", 20000), ("gear", -6000))]},
        "run": {"time": quantity(1e-3, "s"), "steps": 100, "run time": quantity(1, "s"), "ranks": 1,
                "element-steps per second": quantity(3600, "1/s"), "timers": {"total": quantity(1, "s")}},
        "steady part": {"start": quantity(2e-4, "s"), "end": quantity(1e-3, "s"), "found": True,
                        "mesh cycles": 7, "explanation": "steady from 0.2 ms", "columns": columns},
        "energy": {"strain": quantity(1200, "mJ")}, "input conflicts": ["<one> & another"],
        "warnings": [], "contact losses": {"count": 0}}


def make_parameters(web_thickness="5"):
    """Values and units by path."""
    body = "Gear pair/Gear/Body/"
    return {"Study/kind": ("run", ""),
            "Gear pair/Pinion/Blank/number of teeth": ("27", "-"),
            "Gear pair/Gear/Blank/number of teeth": ("79", "-"),
            body + "body type": ("conical web", ""),
            body + "web thickness": (web_thickness, "mm"),
            body + "web inclination": ("70 deg", "deg"),
            body + "web direction": ("towards back", ""),
            body + "web attachment": ("toe", ""),
            body + "rim thickness": ("8.5 mm", "mm"),
            "Operation/speed": ("20000 rpm", "rpm"),
            "Operation/torque": ("800 N m", "N m"),
            "Dynamics/start": ("static equilibrium", "")}


def write_parameters(folder, parameters):
    """parameters.json as the program writes it, of values, units and, where they count, defaults."""
    (folder / "parameters.json").write_text(json.dumps(
        {name: {"value": value, "unit": unit, "default": default[0] if default else ""}
         for name, (value, unit, *default) in parameters.items()}))


def write_run(folder, web_thickness="5", fields=True):
    """Histories and, on demand, fields at the last instant."""
    time = np.arange(101) * 1e-3 / 100
    names = ["time [s]", "dte [arcsec]", "rim dte [arcsec]", "contact force total [N]",
             "energy error [-]", "strain energy [mJ]"]
    rows = [[t, -80 + np.sin(5e4 * t), -70, 9000, 1e-3, 1200 + t] for t in time]
    text = "\n".join([",".join(names)] + [",".join(map(str, row)) for row in rows])
    (folder / "history.csv").write_text(text + "\n0.001,3")  # the last line is cut off
    (folder / "teeth.csv").write_text(
        "time [s],side,pinion tooth [-],gear tooth [-],force [N],largest pressure [MPa],"
        "mean pressure [MPa],hertz pressure [MPa]\n"
        "0,drive,0,0,9000,1000,800,1300\n0.001,drive,26,1,8000,1100,700,1250\n"
        "0.001,coast,1,0,10,20,15,130\n")
    places = [(r, z) for r in range(5) for z in range(4)]
    (folder / "pattern.csv").write_text(
        "body,side,r [mm],z [mm],largest pressure [MPa]\n"
        + "".join(f"{body},{side},{r},{z},{100 * r * z}\n" for body in ("pinion", "gear")
                  for side in ("drive", "coast") for r, z in places))
    (folder / "probes.csv").write_text(
        "time [s],probe,von mises [MPa]\n0,a,1\n0,b,2\n0.001,a,3\n0.001,b,3\n")
    write_rim(folder, time)
    (folder / "summary.json").write_text(json.dumps(make_summary()))
    write_parameters(folder, make_parameters(web_thickness))
    if not fields:
        return
    (folder / "fields.pvd").write_text('<VTKFile><Collection><DataSet timestep="0.001" '
                                       'file="last.vtu"/></Collection></VTKFile>')
    write_vtu(folder / "last.vtu", make_pair())


def read_report(folder):
    """The page that is made of a folder."""
    main([str(folder)])
    return (Path(folder) / "report.html").read_text(encoding="utf-8")


def write_blank(plot, path):
    """In place of a picture's rendering, which takes most of a report's time."""
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg"/>', encoding="utf-8")
    plt.close(plot)


def make_page(folder):
    """The page with plots that are drawn, but not rendered: for tests of the page's text."""
    with mock.patch("vfife_report.plots.style.save", write_blank):
        main([str(folder)])
