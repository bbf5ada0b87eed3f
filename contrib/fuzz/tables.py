# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutants of tables and results that the program reads: histories of loads, the stiffness table of a lumped model, cases
that are compared."""
import shutil

from job import ROOT, Job
from mutation import NUMBERS, SMALL_BODY, mutate_text, pick

BLOCK = """subsection Study
  set kind = static
end
subsection Model
  set bodies = a
  set probes = p
  set constraints = foot
  set loads = end
""" + SMALL_BODY + """  subsection Constraint foot
    set body = a
    set nodes = x-
  end
  subsection Load end
    set body = a
    set nodes = x+
    set force = 1, 0, 0 N
  end
  subsection Probe p
    set body = a
    set point = 10, 0, 0 mm
  end
end
subsection Output
  set report = no
end
"""
COMPARE = """subsection Study
  set kind = compare
  set output folder = compared
end
subsection Compare
  set cases = rest, linear
  set report = no
  subsection Case rest
    set results = rest
  end
  subsection Case linear
    set results = linear
  end
end
"""
# A table of a loaded tooth contact analysis as far as a lumped model reads it.
STIFFNESS = "position [-],unloaded transmission error [arcsec],transmission error [arcsec],contact torque on the gear [N m]," \
    "tangent stiffness [N m/rad]\n" + "".join(f"{k / 8},{-1 - k % 3},{-80 - k % 5},800,{2.2e6 + 1e4 * k}\n" for k in range(8))
HISTORY = "time [s],factor\n" + "".join(f"{1e-4 * k},{k / 10}\n" for k in range(11))
RESULTS = ["history.csv", "summary.json", "parameters.json", "parameters.prm"]
WORDS = ["time [s]", '"a', "{", "}", "null", "[]", "1,2", "nan", ",", "time [mm]", '"value": "x"', *NUMBERS]


class Seeds:
    def __init__(self, runner, folder):
        folder.mkdir()
        self.folder = folder
        (folder / "block.prm").write_text(BLOCK)
        runner.run_good(folder, "block.prm", "-o", "rest")
        runner.run_good(folder, "block.prm", "-o", "linear", "--set", "Study/kind=linear static")
        (folder / "compare.prm").write_text(COMPARE)
        runner.run_good(folder, "compare.prm")

    def make(self, rng, folder):
        how = rng.randrange(3)
        if how == 0:
            for name in ("rest", "linear"):
                shutil.copytree(self.folder / name, folder / name)
            (folder / "compare.prm").write_text(COMPARE)
            path = folder / pick(rng, ["rest", "linear"]) / pick(rng, RESULTS)
            note, content = mutate_text(rng, path.read_bytes(), WORDS)
            path.write_bytes(content)
            return Job(folder, ["compare.prm"], f"{path.parent.name}/{path.name}: {note}")
        path = folder / "table.csv"
        note, content = mutate_text(rng, (STIFFNESS if how == 1 else HISTORY).encode(), WORDS)
        path.write_bytes(content)
        if how == 1:
            arguments = [str(ROOT / "prm/lumped/torsional_pair.prm"), "--set=Lumped/mesh stiffness source=loaded contact",
                         "--set=Lumped/table=table.csv", "--check"]
        else:
            (folder / "block.prm").write_text(BLOCK)
            arguments = ["block.prm", "--set=Model/Load end/history=table.csv", "--check"]
        return Job(folder, arguments, f"{'stiffness' if how == 1 else 'history'}: {note}")
