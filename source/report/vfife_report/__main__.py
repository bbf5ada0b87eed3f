# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m vfife_report ...: the command."""
import sys

from .command import main

if __name__ == "__main__":
    main(sys.argv[1:])
