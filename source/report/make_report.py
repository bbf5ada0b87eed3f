#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Report of a folder of results: make_report.py DIR. Without arguments it prints all commands."""
import importlib.util
import os
import sys

# Debian's Python has the libraries that Debian installs, also where another one comes first in PATH.
DEBIAN_PYTHON = "/usr/bin/python3"
if (any(importlib.util.find_spec(name) is None for name in ("numpy", "matplotlib", "jinja2", "meshio"))
        and os.path.exists(DEBIAN_PYTHON) and not os.path.samefile(sys.executable, DEBIAN_PYTHON)):
    os.execv(DEBIAN_PYTHON, [DEBIAN_PYTHON, os.path.abspath(__file__)] + sys.argv[1:])

from vfife_report.command import main  # noqa: E402

if __name__ == "__main__":
    main(sys.argv[1:])
