# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Where mutants are built and tested: a copy of the tree with a build folder of its own.

The library is static: an edit costs one compilation, the archive and a link of each test program.
"""
import json
import os
import re
import shutil
import signal
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FAILED = re.compile(r"Test +#\d+: (\S+) \.*.*?(?:\*\*\*|Subprocess )(Timeout)?")


class WorkshopError(Exception):
    pass


class Workshop:
    def __init__(self, folder, jobs, limit):
        self.tree, self.jobs, self.limit = folder, jobs, limit
        self.build = folder / "build/release"
        self.log = folder / "mutants.log"
        self.tests = {}  # target that builds a test, by its name in ctest; None: needs nothing built

    def prepare(self):
        """The tree as it is; files that are alike stay untouched, so that little is built anew."""
        listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                                stdout=subprocess.PIPE, text=True).stdout
        wanted = {Path(name) for name in listed.split("\0") if name and (ROOT / name).is_file()}
        for path in sorted(wanted):
            copy = self.tree / path
            if not copy.is_file() or copy.read_bytes() != (ROOT / path).read_bytes():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / path, copy)
                shutil.copymode(ROOT / path, copy)
        for top in {path.parts[0] for path in wanted}:
            for copy in (self.tree / top).rglob("*"):
                if copy.is_file() and copy.relative_to(self.tree) not in wanted:
                    copy.unlink()
        self.call(["cmake", "--preset", "release", f"-DTEST_TIME_LIMIT={self.limit}"], self.tree, must_work=True)
        output = self.call(["ctest", "--show-only=json-v1"], self.build, must_work=True)[1]
        for test in json.loads(output[output.index("{"):])["tests"]:
            words = test.get("command", ())
            program = next((Path(word).name for word in words if word.endswith("_tests")), None)
            # Scripts are handed the program that they run.
            self.tests[test["name"]] = program or ("vfife_main" if str(self.build / "vfife") in words else None)

    def call(self, command, folder, must_work=False):
        """Exit code and output, which is added to the log."""
        # ccache hashes what the precompiled header is made of (cmake/precompiled_header.cmake).
        os.environ.setdefault("CCACHE_PCH_EXTSUM", "true")
        process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   errors="replace", start_new_session=True)
        try:
            output, _ = process.communicate()
        except BaseException:
            # ninja ends its compilers.
            os.killpg(process.pid, signal.SIGINT)
            process.communicate()
            raise
        with self.log.open("a", encoding="utf-8") as log:
            log.write(f"$ {' '.join(command)}\n{output}[{process.returncode}]\n")
        if must_work and process.returncode != 0:
            raise WorkshopError(f"{' '.join(command[:4])}... failed: see {self.log}")
        return process.returncode, output

    def verdict(self, pattern):
        """Of the tree as it stands, and the test that failed first."""
        tests = [test for test in self.tests if re.search(pattern, test)]
        if not tests:
            raise WorkshopError(f'no test has a name with "{pattern}"')
        targets = sorted({self.tests[test] for test in tests} - {None})
        if targets and self.call(["ninja", f"-j{self.jobs}", *targets], self.build)[0] != 0:
            return "not built", ""
        code, output = self.call(["ctest", f"-j{self.jobs}", "--stop-on-failure", "-R", pattern], self.build)
        if code == 0:
            return "survived", ""
        failed = FAILED.search(output)
        return ("timed out" if failed and failed[2] else "killed"), failed[1] if failed else ""

    def put(self, file, content):
        (self.tree / file).write_text(content, encoding="utf-8")
