# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Where mutants are built and tested: a copy of the tree with a build folder of its own.

The library is static: an edit costs one compilation, the archive and a link of each test that is named. With ccache,
which the build uses by itself, putting a text back costs the archive alone.
"""
import json
import os
import re
import shutil
import signal
import subprocess
import time
from hashlib import sha256
from pathlib import Path

from table import ROOT

# What a build reads, and what makes tests pass or fail.
TELLING = ("CMakeLists.txt", "CMakePresets.json", "cmake", "include", "meshes", "prm", "source", "tests")
CONTENT = (*TELLING, "README.md", "LICENSE", "run", "check", "contrib", "doc", "examples")


class WorkshopError(Exception):
    pass


def list_files():
    for name in CONTENT:
        top = ROOT / name
        for path in sorted(top.rglob("*")) if top.is_dir() else [top]:
            if path.is_file() and "__pycache__" not in path.parts:
                yield path.relative_to(ROOT)


class Workshop:
    def __init__(self, folder, jobs, limit):
        self.tree, self.jobs, self.limit = folder, jobs, limit
        self.build = folder / "build/release"
        self.log = folder / "mutants.log"
        self.results = folder / "mutants.json"  # of earlier calls
        self.digest = ""
        self.programs = {}  # target that builds a test, by its name in ctest; None: needs nothing built

    def prepare(self):
        """The tree as it is now; files that are alike stay untouched, so that little is built anew."""
        digest = sha256()
        wanted = set()
        self.tree.mkdir(parents=True, exist_ok=True)
        for path in list_files():
            content = (ROOT / path).read_bytes()
            if path.parts[0] in TELLING:
                digest.update(str(path).encode() + b"\0" + content + b"\0")
            wanted.add(path)
            copy = self.tree / path
            if not copy.is_file() or copy.read_bytes() != content:
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / path, copy)
                shutil.copymode(ROOT / path, copy)
        for name in CONTENT:
            for copy in (self.tree / name).rglob("*") if (self.tree / name).is_dir() else ():
                if copy.is_file() and copy.relative_to(self.tree) not in wanted:
                    copy.unlink()
        self.digest = digest.hexdigest()
        if not (self.build / "build.ninja").is_file():
            self.call(["cmake", "--preset", "release", f"-DTEST_TIME_LIMIT={self.limit}"], self.tree, check=True)
        self.list_tests()

    def call(self, command, folder, limit=None, check=False):
        """Exit code and output, which goes to the log; no code where the time was not enough."""
        begin = time.monotonic()
        process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   errors="replace", start_new_session=True)
        try:
            output, _ = process.communicate(timeout=limit)
            code = process.returncode
        except BaseException as error:
            os.killpg(process.pid, signal.SIGKILL)
            output, _ = process.communicate()
            if not isinstance(error, subprocess.TimeoutExpired):
                raise
            code = None
        with self.log.open("a", encoding="utf-8") as log:
            log.write(f"$ {' '.join(command)}\n{output}[{code}, {time.monotonic() - begin:.1f} s]\n")
        if check and code != 0:
            raise WorkshopError(f"{' '.join(command[:4])}... failed: see {self.log}")
        return code, output

    def list_tests(self):
        # ninja makes its files anew where tests came or went.
        self.call(["ninja", "build.ninja"], self.build, check=True)
        _, output = self.call(["ctest", "--show-only=json-v1"], self.build, check=True)
        for test in json.loads(output[output.index("{"):])["tests"]:
            # build/release/tests/fem/fem_tests is the target fem_tests.
            program = next((Path(word).name for word in test.get("command", ()) if word.endswith("_tests")), None)
            # Scripts are handed the program that they run.
            if program is None and str(self.build / "vfife") in test.get("command", ()):
                program = "vfife_main"
            self.programs[test["name"]] = program

    def find_tests(self, name):
        """fem/ranks: fem/ranks.mpirun=2"""
        return [test for test in self.programs if test == name or test.startswith(name + ".")]

    def make(self, tests):
        """Whether all that the tests need could be built."""
        targets = sorted({self.programs[test] for test in tests} - {None})
        return not targets or self.call(["ninja", f"-j{self.jobs}", "-k0", *targets], self.build)[0] == 0

    def passes(self, test):
        """Whether the test passes; it has the time of TEST_TIME_LIMIT, this is for what hangs beyond it."""
        code, _ = self.call(["ctest", "-j1", "-R", f"^{re.escape(test)}$"], self.build, 3 * self.limit)
        return code == 0

    def put(self, mutant):
        path = self.tree / mutant.path
        path.write_text(mutant.apply((ROOT / mutant.path).read_text(encoding="utf-8")), encoding="utf-8")

    def put_back(self, mutant):
        # With the time of now: the object is of the mutant.
        (self.tree / mutant.path).write_bytes((ROOT / mutant.path).read_bytes())

    def read_results(self):
        return json.loads(self.results.read_text()) if self.results.is_file() else {"mutants": {}, "tests": {}}

    def write_results(self, results):
        part = self.results.with_suffix(".part")
        part.write_text(json.dumps(results, indent=1))
        part.replace(self.results)
