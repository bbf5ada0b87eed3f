# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers computed from the data; doc/theory/steady-part.md defines them."""
