#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Report of a folder of results: make_report.py DIR. Without arguments it says what else it can do."""
import sys

from vfife_report.command import main

if __name__ == "__main__":
    main(sys.argv[1:])
