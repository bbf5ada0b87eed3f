# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with the way in which a mutant ended."""
import re

# Words that a library or the language says, not this program.
INNER = re.compile(
    r"deal\.?II|dealii|Trilinos|Epetra|Teuchos|Amesos|[Bb]oost|nlohmann|json\.exception|std::|terminate called|Traceback|"
    r"[Ss]tack ?trace|what\(\)|bad_alloc|basic_string|_M_|\bExc[A-Z]\w+|Aborted|Assert|\bsto[idul]+\b|muParser|"
    r"filesystem error|iostream|lexical|\bexception|MPI_|\[\w+:\d+\] |Segmentation|Eigen|CGAL|boost::|"
    r"\w+Error\b|invalid literal|object has no|not subscriptable|NoneType|codec can't|could not convert|array\(|dtype|"
    r"list index|Expecting (value|property|',)|Unterminated string|\ban error inside|an error of unknown kind|"
    r"\.(cc|cpp|h|py):\d+|File \"", re.A)
NOT_A_NUMBER = re.compile(r"(?<![\w-])[-+]?(nan|inf)\b(?! ?[(=])", re.I)
LONGEST = 20000  # of a message


# Counts, mass, displacement and energy of a body.
FIGURES = (re.compile(r"(\d+) elements, (\d+) nodes, mass (\S+) kg"),
           re.compile(r"largest displacement (\S+) um.* strain energy (\S+) mJ"))


def figures(output):
    """What the program prints of a body and its answer; empty where something of it is missing."""
    found = [pattern.search(output) for pattern in FIGURES]
    return () if None in found else tuple(float(number) for match in found for number in match.groups())


def agree(wanted, output):
    """Six digits are printed; formats write places with as many."""
    found = figures(output)
    return len(found) == len(wanted) and all(abs(a - b) <= 1e-4 * abs(b) for a, b in zip(found, wanted))


def judge(job, ending):
    """The class of a finding; empty where all is as it should be."""
    if ending.crashed:
        return "crash"
    if ending.timed_out:
        return "hang"
    if ending.code not in (0, 1, 2):
        return "wrong exit code"
    if ending.code == 0:
        if job.fails:
            return "accepted"
        if job.same and not agree(job.same, ending.output):
            return "read otherwise than written"
        return "stray message" if ending.errors.strip() else "not a number" if says_nan(job, ending.output) else ""
    if job.same:
        return "refused in another spelling"
    message = ending.errors
    if not message.strip():
        return "empty message"
    # What the user wrote may stand in a message: names of files as the fuzzer's own do.
    if INNER.search(message.replace(str(job.folder), "")):
        return "inner message"
    if "not enough memory" in message:
        return "memory"
    if len(message) > LONGEST:
        return "long message"
    if not job.report and not message.startswith("vfife: "):
        return "stray message"
    if job.names and not any(name in message for name in job.names):
        return "no place"
    return ""


def says_nan(job, output):
    """Numbers of the screen; the report prints none, and a comparison says that it judges none."""
    if job.report or "--print-parameters" in job.arguments:
        return False
    return any(NOT_A_NUMBER.search(line) for line in output.splitlines() if not line.endswith("not judged"))
