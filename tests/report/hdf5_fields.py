#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""hdf5_fields.py PROGRAM: fields of a run in HDF5 with XDMF, read by meshio and h5py, against its .vtu series; on two
ranks, after a restart, damaged, and without h5py."""
import contextlib
import io
import os
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import made_up_run  # noqa: F401  first: ends the test without the libraries

try:
    import h5py
except ImportError:
    sys.exit(77)
import meshio
import numpy as np
from vfife.result import Result
from vfife_report.command import main
from vfife_report.data.fields import read_last_fields, read_piece
from vfife_report.data.files import DamagedFile

PROGRAM = sys.argv.pop(1)
CASE = Path(__file__).with_suffix(".prm")


def read_series(folder):
    """Places of the first instant and, for each, time and data by name, at the corners of the hexahedra."""
    with meshio.xdmf.TimeSeriesReader(folder / "fields.xdmf") as reader:
        points, (cells,) = reader.read_points_cells()
        instants = []
        for number in range(reader.num_steps):
            time, data, cell_data = reader.read_data(number)
            at_corners = {name.partition(" [")[0]: values[cells.data] for name, values in data.items()}
            for name, (values,) in cell_data.items():
                at_corners[name] = np.repeat(values[:, None], 8, axis=1)
            instants.append((time, at_corners))
        return points[cells.data], instants


class Hdf5Fields(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.run_case("vtu", "--set", "Output/field format=vtu")
        cls.run_case("whole")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def run_case(cls, name, *more, ranks=1, code=0):
        start = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
        ended = subprocess.run([*start, PROGRAM, CASE, "-o", cls.folder / name, *more],
                               capture_output=True, text=True, check=False)
        if ended.returncode != code:
            raise AssertionError(f"exit code {ended.returncode}: {ended.stderr}{ended.stdout}")
        return ended.stderr + ended.stdout

    def test_vtu_series(self):
        """Digit by digit the same arrays in the same cells at the same times."""
        pvd = ElementTree.parse(self.folder / "vtu" / "fields.pvd").getroot()
        listed = [(float(one.attrib["timestep"]), one.attrib["file"]) for one in pvd.findall("Collection/DataSet")]
        first_points, instants = read_series(self.folder / "whole")
        self.assertGreater(len(listed), 3)
        self.assertEqual(len(instants), len(listed))
        for number, ((time, data), (vtu_time, file)) in enumerate(zip(instants, listed)):
            points, vtu_data = read_piece(self.folder / "vtu" / file)
            self.assertAlmostEqual(time / vtu_time if vtu_time else 1, 1, delta=1e-5)
            self.assertEqual(set(data), set(vtu_data))
            for name, values in vtu_data.items():
                np.testing.assert_array_equal(data[name], values, f"{name} of instant {number}")
            if number == 0:
                np.testing.assert_array_equal(first_points, points)
        self.assertGreater(np.max(instants[-1][1]["von mises"]), 1)

    def test_last_fields(self):
        one, other = (Result(self.folder / name).fields() for name in ("vtu", "whole"))
        np.testing.assert_array_equal(one.points, other.points)
        self.assertAlmostEqual(one.time / other.time, 1, delta=1e-5)
        for name, values in one.data.items():
            np.testing.assert_array_equal(values, other[name], name)

    def test_size(self):
        """Cells are stored once."""
        series = sum(path.stat().st_size for path in (self.folder / "vtu" / "fields").iterdir())
        self.assertLess((self.folder / "whole" / "fields.h5").stat().st_size, 0.9 * series)

    def test_ranks(self):
        """Nodes and elements of the model, whatever rank has them; sums have another order."""
        self.run_case("ranks", ranks=2)
        points, instants = read_series(self.folder / "whole")
        ranks_points, ranks_instants = read_series(self.folder / "ranks")
        np.testing.assert_array_equal(points, ranks_points)
        self.assertEqual(len(instants), len(ranks_instants))
        for (_, data), (_, ranks_data) in zip(instants, ranks_instants):
            for name, values in data.items():
                np.testing.assert_allclose(ranks_data[name], values, rtol=0, atol=1e-5 * max(1, np.max(np.abs(values))))

    def test_restart(self):
        """No instant twice, none after the checkpoint, and a whole file at each stop; then the digits of one run."""
        for steps, more in ((130, []), (290, ["--restart"])):
            self.run_case("parts", *more, "--set", f"Dynamics/maximum number of steps={steps}")
            times = [time for time, _ in read_series(self.folder / "parts")[1]]
            self.assertEqual(times, sorted(set(times)))
        # As after a run that was killed behind its last checkpoint: an instant that the list does not name.
        with h5py.File(self.folder / "parts" / "fields.h5", "a") as file:
            file.copy("instants/00001", f"instants/{len(times):05d}")
        self.run_case("parts", "--restart")
        with h5py.File(self.folder / "parts" / "fields.h5") as one, h5py.File(self.folder / "whole" / "fields.h5") as other:
            self.assertEqual(list(one["instants"]), list(other["instants"]))
            for name, instant in one["instants"].items():
                self.assertEqual(instant.attrs["time"], other["instants"][name].attrs["time"])
                for array, values in instant.items():
                    np.testing.assert_array_equal(values[:], other["instants"][name][array][:])
        self.assertEqual(*((self.folder / name / "fields.xdmf").read_text() for name in ("parts", "whole")))

    def test_damaged(self):
        self.run_case("damaged", "--set", "Dynamics/maximum number of steps=130")
        path = self.folder / "damaged" / "fields.h5"
        os.truncate(path, 3000)
        with self.assertRaisesRegex(DamagedFile, "fields.h5 is damaged"):
            read_last_fields(path)
        said = self.run_case("damaged", "--restart", code=2)
        self.assertIn("fields.h5", said)
        self.assertNotIn("HDF5-DIAG", said)
        # Without the file the run goes on with a new one.
        path.unlink()
        self.run_case("damaged", "--restart")
        self.assertGreater(len(read_series(self.folder / "damaged")[1]), 1)

    def test_without_h5py(self):
        said = io.StringIO()
        with unittest.mock.patch.dict(sys.modules, {"h5py": None}), contextlib.redirect_stdout(said):
            with self.assertRaises(SystemExit) as ended:
                main([str(self.folder / "whole")])
        self.assertEqual(ended.exception.code, 77)
        self.assertIn("fields.h5 requires h5py (Debian: python3-h5py)", said.getvalue())

    def test_refused(self):
        said = self.run_case("refused", "--set", "Study/kind=linear static", code=1)
        self.assertIn("Output/field format", said)
        self.assertIn("expected vtu, got hdf5", said)


if __name__ == "__main__":
    unittest.main()
