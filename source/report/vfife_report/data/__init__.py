# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What the files of results say: run folders, tables, parameters, fields, variants of a study."""
