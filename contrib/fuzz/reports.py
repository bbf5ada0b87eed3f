# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutants of the files of which the report is made: of a run and of studies with tables of their own."""
import json
import shutil
import subprocess

from job import ROOT, Job
from mutation import NUMBERS, mutate_text, pick

WORDS = ["time [s]", '"a', "{", "}", "null", "[]", "1,2", "nan", ",", "dte [mm]", '"value": "x"', "<x>", *NUMBERS]
MAKE_RUN = """import sys
sys.path.insert(0, {tests!r})
from pathlib import Path
from made_up_run import write_run
write_run(Path({folder!r}))
"""


def has_libraries(python):
    return subprocess.run([python, "-c", "import numpy, matplotlib, jinja2, meshio"], capture_output=True,
                          check=False).returncode == 0


def spoil_json(rng, value):
    """The same with one value replaced, missing, or of another kind."""
    places = []

    def collect(one):
        if isinstance(one, dict):
            places.extend((one, key) for key in one)
            for below in one.values():
                collect(below)
        elif isinstance(one, list):
            places.extend((one, k) for k in range(len(one)))
            for below in one:
                collect(below)

    collect(value)
    if not places:
        return "nothing", value
    owner, key = pick(rng, places)
    if rng.random() < 0.3:
        del owner[key]
        return f"{key!r} is missing", value
    owner[key] = pick(rng, [None, "x", 0, -1, 1e308, float("nan"), float("inf"), [], {}, True, [1], {"value": 1}, "", 10**30])
    return f"{key!r} is {owner[key]!r}", value


class Seeds:
    def __init__(self, runner, folder):
        folder.mkdir()
        (folder / "run").mkdir()
        made = subprocess.run([runner.asked.python, "-B", "-c", MAKE_RUN.format(
            tests=str(ROOT / "tests/report"), folder=str(folder / "run"))], capture_output=True, text=True, check=False)
        if made.returncode != 0:
            raise RuntimeError(f"the report's libraries are missing: {made.stdout}{made.stderr}")
        # Studies whose tables have plots of their own. Only mutants draw them.
        for name, case, section in (("lumped", "prm/lumped/torsional_pair.prm", "Lumped"),
                                    ("teeth", "prm/gear/paper_tca.prm", "Output")):
            runner.run_good(folder, str(ROOT / case), "-o", name, "--set", f"{section}/report=no")
        (folder / "ledger").mkdir()
        row = {"quantity": "mean dte", "unit": "arcsec", "value": -84.0, "reference": -80.0, "reference kind": "FEM",
               "difference": -4.0, "tolerance": 1.0, "verdict": "differs", "reason": "coarse"}
        (folder / "ledger/comparison.json").write_text(json.dumps({"title": "t", "rows": [row]}))
        self.folders = {path.name: path for path in sorted(folder.iterdir())}

    def make(self, rng, folder):
        name = pick(rng, ["run"] * 5 + sorted(self.folders))
        shutil.copytree(self.folders[name], folder / "results")
        files = sorted(path for path in (folder / "results").rglob("*")
                       if path.suffix in (".csv", ".json", ".vtu", ".pvd"))
        if name == "run":
            # Pictures take long: fields only sometimes.
            if rng.random() < 0.8:
                (folder / "results/fields.pvd").unlink()
                files = [path for path in files if path.suffix in (".csv", ".json")]
        path = pick(rng, files)
        if path.suffix == ".json" and rng.random() < 0.6:
            note, value = spoil_json(rng, json.loads(path.read_text()))
            path.write_text(json.dumps(value))
        else:
            note, content = mutate_text(rng, path.read_bytes(), WORDS)
            path.write_bytes(content)
        return Job(folder, ["results"], f"{name}/{path.name}: {note}", report=True, names=(path.name, "results"))
