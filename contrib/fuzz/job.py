# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What is run: a folder with mutated files and the arguments of the program, and how it ended."""
import random
import shlex
import signal
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def make_generator(seed, kind, number):
    """The same numbers for the same mutant, whichever were made before."""
    return random.Random(f"{seed} {kind} {number}")


@dataclass
class Job:
    """Arguments are texts or bytes; `folder` is where the program runs, all it needs lies below."""
    folder: Path
    arguments: list
    note: str  # what has been done to the input
    report: bool = False  # the report's script instead of the program
    names: tuple = ()  # one of these must stand in a message of failure
    fails: bool = False  # success would be wrong
    same: tuple = ()  # figures that the program must print, of the same input in another spelling

    def show(self, asked):
        """As a line for the shell."""
        words = [f"{asked.python} {ROOT / 'source/report/make_report.py'}" if self.report else str(asked.program)]
        for argument in self.arguments:
            if isinstance(argument, bytes):
                words.append("$'" + "".join(f"\\x{byte:02x}" for byte in argument) + "'")
            else:
                words.append(shlex.quote(argument))
        return " ".join(words)


@dataclass
class Ending:
    code: object  # exit code, or the name of the signal
    output: str = ""
    errors: str = ""
    limits: tuple = field(default=(signal.SIGXCPU, signal.SIGALRM, signal.SIGKILL), repr=False)

    @property
    def crashed(self):
        return isinstance(self.code, signal.Signals) and self.code not in self.limits

    @property
    def timed_out(self):
        return isinstance(self.code, signal.Signals) and self.code in self.limits

    def describe(self):
        return f"signal {self.code.name}" if isinstance(self.code, signal.Signals) else f"exit code {self.code}"
