# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs jobs within limits of processor time and address space, by servers where there are any."""
import os
import resource
import signal
import subprocess
import threading
from pathlib import Path

from job import ROOT, Ending, Job

ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
    "OMPI_MCA_btl": "self", "OMPI_MCA_pml": "ob1", "OMPI_MCA_ess_singleton_isolated": "1",
    "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MPLBACKEND": "agg", "PYTHONDONTWRITEBYTECODE": "1"}
REPORT_SERVER = Path(__file__).with_name("report_server.py")


def as_bytes(text):
    return text if isinstance(text, bytes) else os.fsencode(text)


def digits(text):
    return as_bytes(text).hex() or "-"


class Server:
    """A process that answers lines of jobs (tests/fuzz/fork_server.cpp)."""

    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                        env={**os.environ, **ENVIRONMENT})
        self.lock = threading.Lock()

    def run(self, limits, folder, output, errors, arguments):
        with self.lock:  # workers share the server of good input
            self.process.stdin.write(" ".join([*map(str, limits), *map(digits, (folder, output, errors, *arguments))]) + "\n")
            self.process.stdin.flush()
            words = self.process.stdout.readline().split()
        if len(words) != 2:
            raise RuntimeError(f"the server {self.process.args[0]} has ended")
        return signal.Signals(int(words[1])) if words[0] == "signal" else int(words[1])


class Runner:
    def __init__(self, asked):
        self.asked = asked
        self.server = Server([asked.server]) if asked.server else None
        self.report_server = None

    def run(self, job):
        """How a job ends."""
        output, errors = job.folder.with_suffix(".output"), job.folder.with_suffix(".errors")
        limits = (self.asked.limit, self.asked.memory * 10**6)
        if job.report:
            if self.report_server is None:
                self.report_server = Server([self.asked.python, "-B", REPORT_SERVER, ROOT / "source/report"])
            code = self.report_server.run(limits, job.folder, output, errors, job.arguments)
        elif self.server:
            code = self.server.run(limits, job.folder, output, errors, job.arguments)
        else:
            code = self.run_program(limits, job, output, errors)
        return Ending(code, *(path.read_bytes().decode("utf-8", "surrogateescape") for path in (output, errors)))

    def run_program(self, limits, job, output, errors):
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (limits[0], limits[0]))
            resource.setrlimit(resource.RLIMIT_AS, (limits[1], limits[1]))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            os.setpgid(0, 0)

        with open(output, "wb") as out, open(errors, "wb") as err:
            process = subprocess.Popen([self.asked.program, *map(as_bytes, job.arguments)], cwd=job.folder, stdout=out,
                                       stderr=err, stdin=subprocess.DEVNULL, preexec_fn=limit,
                                       env={**os.environ, **ENVIRONMENT})
            try:
                process.wait(10 * limits[0])
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
        return process.returncode if process.returncode >= 0 else signal.Signals(-process.returncode)

    def print_parameters(self, path, folder):
        """All parameters in force of a file. What is printed is kept beside the folder."""
        return self.run_good(folder, str(path), "--print-parameters")

    def run_good(self, folder, *arguments):
        """Runs the program on good input in a folder, which it must take; what it prints. What it writes is mutated later."""
        job = Job(folder, arguments, "good input")
        ended = self.run(job)
        if ended.code != 0:
            raise RuntimeError(f"cd {folder} && {job.show(self.asked)}: {ended.describe()}\n{ended.output}{ended.errors}")
        return ended.output
