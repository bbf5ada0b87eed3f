# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports, plots and pictures from the files of results. Rooms, each using those before it only:
data (what the files say), measures (numbers computed from them), plots (two-dimensional), pictures
(of fields), the table of all plots, page (the report)."""
