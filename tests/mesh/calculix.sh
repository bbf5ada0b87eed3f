#!/bin/bash
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# CalculiX reads an exported pair and finds the mass and volume that the study reports.
# calculix.sh VFIFE PRM FOLDER; without CalculiX (ccx) the test is skipped (77).
set -eu
vfife=$1 prm=$2 folder=$3
# Looked for here, not when the build is configured: it may be installed later.
ccx=$(command -v ccx) || exit 77
rm -rf "$folder"
"$vfife" "$prm" --output "$folder" >/dev/null
cd "$folder"
cat >load.inp <<'END'
*INCLUDE, INPUT=pair.inp
*BOUNDARY
PINION_BORE, 1, 3
GEAR_RIM_UNDERSIDE, 1, 3
*STEP
*STATIC
*EL PRINT, ELSET=PINION, TOTALS=ONLY
EVOL, EMAS
*EL PRINT, ELSET=GEAR, TOTALS=ONLY
EVOL, EMAS
*END STEP
END
"$ccx" load >ccx.log
python3 - <<'END'
import csv, re
rows = {row["body"]: row for row in csv.DictReader(open("mesh.csv"))}
found = {}
for kind, body, value in re.findall(r"total (volume|mass) for set (\w+)[^\n]*\n\s*([-+.\dE]+)", open("load.dat").read()):
    found[body.lower(), kind] = float(value)
for body in ("pinion", "gear"):
    for kind, column, unit in (("volume", "volume [mm^3]", 1.0), ("mass", "mass [kg]", 1e3)):
        ours, theirs = float(rows[body][column]), unit * found[body, kind]
        print(body, kind, ours, theirs)
        # CalculiX prints seven digits
        assert abs(theirs / ours - 1) < 1e-6, (body, kind, ours, theirs)
END
