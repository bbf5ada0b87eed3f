# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""report_server.py FOLDER: the report's script as often as asked without loading its libraries each time. The same
lines of jobs and answers as tests/fuzz/fork_server.cpp."""
import os
import resource
import signal
import sys

sys.path.insert(0, sys.argv[1])
import matplotlib.pyplot  # noqa: E402, F401
from vfife_report.command import main  # noqa: E402


def decode(digits):
    return b"" if digits == "-" else bytes.fromhex(digits)


def run(seconds, size, folder, output, errors, *arguments):
    signal.alarm(10 * seconds)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_AS, (size, size))
    os.chdir(folder)
    for path, stream in ((b"/dev/null", 0), (output, 1), (errors, 2)):
        os.dup2(os.open(path, os.O_RDWR | os.O_CREAT | os.O_TRUNC), stream)
    code = 0
    try:
        main([os.fsdecode(argument) for argument in arguments])
    except SystemExit as ended:
        code = ended.code if isinstance(ended.code, int) else 0 if ended.code is None else 1
        if isinstance(ended.code, str):
            print(ended.code, file=sys.stderr)
    except BaseException:
        sys.excepthook(*sys.exc_info())
        code = 1
    for stream in (sys.stdout, sys.stderr):
        stream.flush()
    os._exit(code)


for line in sys.stdin:
    words = line.split()
    child = os.fork()
    if child == 0:
        os.setpgid(0, 0)
        run(int(words[0]), int(words[1]), *map(decode, words[2:]))
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        print("signal", os.WTERMSIG(status), flush=True)
    else:
        print("exit", os.WEXITSTATUS(status), flush=True)
