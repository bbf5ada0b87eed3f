# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of history.csv that more than one module looks at (doc/reference/files.md)."""

TRANSMISSION_ERROR = "dte"
RIM_TRANSMISSION_ERROR = "rim dte"
CONTACT_FORCE = "contact force total"
# Whose ripple, periodicity and lines are judged.
JUDGED = (TRANSMISSION_ERROR, RIM_TRANSMISSION_ERROR, CONTACT_FORCE)
