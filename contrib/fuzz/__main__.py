#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Broken input of every sort: the program answers with one clear message and an exit code, whatever it gets.

python3 contrib/fuzz [options]      makes mutants of good input, runs each, and looks at how it ended

Kinds of mutants: parameters (files of prm/), command (arguments), mesh (files of meshes), checkpoint (of a run that
goes on), table (csv and json that the program reads), report (csv, json and vtu that the report reads), disk (a full
one), spelling (meshes and tables that mean the same, with the same answer). The mutant of a number is the same for the
same seed. What is found goes to a folder each, with a line that shows it again. Exit code 0: nothing was found; 1: something was; 2: the fuzzer cannot work.
"""
import argparse
import shutil
import sys
import tempfile
import threading
import time
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import checkpoints  # noqa: E402
import commands  # noqa: E402
import disks  # noqa: E402
import meshes  # noqa: E402
import parameters  # noqa: E402
import reports  # noqa: E402
import spellings  # noqa: E402
import tables  # noqa: E402
from job import ROOT, make_generator  # noqa: E402
from runner import Runner  # noqa: E402
from verdict import judge  # noqa: E402

# In the order of turns: most of all mutants are parameter files and meshes.
KINDS = {"parameters": (parameters, 4), "mesh": (meshes, 4), "checkpoint": (checkpoints, 2),
         "command": (commands, 1), "table": (tables, 1), "report": (reports, 1), "disk": (disks, 1),
         "spelling": (spellings, 2)}


def read_arguments():
    parser = argparse.ArgumentParser(prog="fuzz", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kind", action="append", choices=KINDS, help="only these; may be repeated")
    parser.add_argument("--seed", type=int, help="of all mutants; by default of the clock")
    parser.add_argument("--first", type=int, default=0, help="number of the first mutant")
    parser.add_argument("--count", type=int, help="how many mutants")
    parser.add_argument("--seconds", type=float, help="how long; without --count 60")
    parser.add_argument("--jobs", type=int, default=2, choices=(1, 2), help="mutants at a time")
    parser.add_argument("--limit", type=int, default=20, help="processor time of a mutant [s]")
    parser.add_argument("--memory", type=int, default=2500, help="address space of a mutant [MB]")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/vfife")
    parser.add_argument("--server", type=Path,
                        help="the program that runs many mutants without loading each time; by default "
                             "tests/fuzz/fork_server beside the program where it has been built")
    parser.add_argument("--python", default="/usr/bin/python3", help="Python with the report's libraries")
    parser.add_argument("--findings", type=Path, default=Path("fuzz_findings"), help="folder for what is found")
    parser.add_argument("--show", action="store_true", help="what every mutant is answered")
    asked = parser.parse_args()
    if asked.seed is None:
        asked.seed = time.time_ns() % 1000000
    if asked.count is None and asked.seconds is None:
        asked.seconds = 60.0
    asked.program = asked.program.resolve()
    if not asked.program.is_file():
        parser.error(f"there is no program {asked.program}; build it or name it by --program")
    if asked.server is None:
        server = asked.program.parent / "tests/fuzz/fork_server"
        asked.server = server if server.is_file() else None
    asked.findings = asked.findings.resolve()
    return asked


def turns(kinds):
    """The kinds in an order that is the same again and again."""
    order = []
    for place in range(max(share for _, share in KINDS.values())):
        order += [kind for kind in kinds if KINDS[kind][1] > place]
    return order


class Fuzzer:
    """Hands out numbers to the workers and collects what they find."""

    def __init__(self, asked, folder):
        self.asked, self.folder = asked, folder
        kinds = asked.kind or list(KINDS)
        if "report" in kinds and not reports.has_libraries(asked.python):
            print(f"without report: {asked.python} has not its libraries")
            kinds = [kind for kind in kinds if kind != "report"]
        self.order = turns(kinds)
        self.lock = threading.Lock()
        runner = Runner(asked)
        self.seeds = {kind: KINDS[kind][0].Seeds(runner, folder / f"seeds_{kind}") for kind in sorted(set(self.order))}
        self.next, self.start = asked.first, time.monotonic()
        self.counts, self.found, self.answers, self.error = Counter(), Counter(), Counter(), None

    def take_number(self):
        """None when it is enough."""
        with self.lock:
            asked = self.asked
            if self.error or (asked.count is not None and self.next - asked.first >= asked.count) or (
                    asked.seconds is not None and time.monotonic() - self.start >= asked.seconds):
                return None
            self.next += 1
            return self.next - 1

    def work(self, worker):
        try:
            runner = Runner(self.asked)
            while (number := self.take_number()) is not None:
                self.run_mutant(number, runner, self.folder / f"worker_{worker}")
        except Exception as error:  # a worker's error must end the others
            self.error = error
            raise

    def run_mutant(self, number, runner, folder):
        kind = self.order[number % len(self.order)]
        if folder.exists():
            shutil.rmtree(folder)
        folder.mkdir()
        job = self.seeds[kind].make(make_generator(self.asked.seed, kind, number), folder)
        ending = runner.run(job)
        what = judge(job, ending)
        with self.lock:
            self.counts[kind] += 1
            self.answers[kind, str(ending.code)] += 1
            if self.asked.show:
                said = " ".join(ending.errors.split())
                print(f"{kind} {number}: {ending.describe()}: {said[:300]!r} ({job.note[:200]})", flush=True)
            if what:
                self.found[kind, what] += 1
                self.keep(number, kind, what, job, ending)

    def keep(self, number, kind, what, job, ending):
        place = self.asked.findings / f"{kind}_{what.replace(' ', '_')}_{self.asked.seed}_{number}"
        if place.exists():
            shutil.rmtree(place)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copytree(job.folder, place, symlinks=True, ignore_dangling_symlinks=True)
        again = "".join(f" --kind {one}" for one in self.asked.kind or [])
        line = f"python3 {ROOT / 'contrib/fuzz'} --seed {self.asked.seed} --first {number} --count 1{again}"
        (place / "finding.txt").write_text(
            f"{what}: {ending.describe()}\nmutant: {job.note}\n\n{line}\ncd {place} && {job.show(self.asked)}\n\n"
            f"{ending.errors[-4000:]}\n", encoding="utf-8", errors="surrogateescape")
        said = " ".join(ending.errors.split())[-200:]
        print(f"{kind} {number}: {what}: {ending.describe()}: {said!r} ({job.note}) in {place}", flush=True)


def main():
    asked = read_arguments()
    print(f"fuzz: seed {asked.seed}, {asked.program}", flush=True)
    with tempfile.TemporaryDirectory(prefix="vfife_fuzz_") as name:
        fuzzer = Fuzzer(asked, Path(name).resolve())
        workers = [threading.Thread(target=fuzzer.work, args=(k,)) for k in range(asked.jobs)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
    for kind in dict.fromkeys(fuzzer.order):
        found = {what: n for (of_kind, what), n in sorted(fuzzer.found.items()) if of_kind == kind}
        codes = {code: n for (of_kind, code), n in sorted(fuzzer.answers.items()) if of_kind == kind}
        print(f"{kind}: {fuzzer.counts[kind]} mutants; exit codes "
              f"{', '.join(f'{code}: {n}' for code, n in codes.items())}; "
              f"{', '.join(f'{n} {what}' for what, n in found.items()) or 'nothing found'}")
    print(f"fuzz: {sum(fuzzer.counts.values())} mutants, {sum(fuzzer.found.values())} findings")
    if fuzzer.error:
        return 2
    return 1 if fuzzer.found else 0


if __name__ == "__main__":
    sys.exit(main())
