# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""A disk that is full when one of the files of a run is written: its name is a link to /dev/full."""
from pathlib import Path

from commands import CASE
from job import Job
from mutation import pick

FILES = ["parameters.prm.part", "parameters.json.part", "run.log", "history.csv", "fields/00000.vtu.part",
         "fields/00001.vtu.part", "fields.pvd.part", "summary.json.part", "checkpoint.new.bin.part"]
MORE = ["--set", "Output/field output interval=1", "--set", "Output/steps per sample=1"]


class Seeds:
    def __init__(self, runner, folder):
        pass

    def make(self, rng, folder):
        name = pick(rng, FILES)
        (folder / "case.prm").write_text(CASE)
        place = folder / "out" / name
        place.parent.mkdir(parents=True)
        place.symlink_to("/dev/full")
        return Job(folder, ["case.prm", *MORE], f"full disk at {name}", names=(Path(name).name.replace(".part", ""),),
                   fails=True)
