#!/bin/bash
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# CalculiX reads an exported pair, pinion and gear, finds the mass and volume that the study reports,
# and holds the bodies by their bores against forces on their tips.
# calculix.sh VFIFE PRM FOLDER; without CalculiX (ccx) the test is skipped (77).
set -eu
vfife=$1 prm=$2 folder=$3
# Looked for here, not when the build is configured: it may be installed later.
ccx=$(command -v ccx) || exit 77
rm -rf "$folder"
# The coarsest meshes: volumes, masses and sums of forces are as exact.
entries=(--set Output/report=no)
for member in Pinion Gear; do
  for size in "elements along face width" "elements along profile" "elements through rim"; do
    entries+=(--set "Gear pair/$member/Mesh/$size=2")
  done
done
"$vfife" "$prm" --output "$folder" "${entries[@]}" >/dev/null
cd "$folder"
declare -A support=([pinion]=PINION_BORE [gear]=GEAR_RIM_UNDERSIDE)
for mesh in pinion gear pair; do
  bodies=$mesh
  [ $mesh != pair ] || bodies="pinion gear"
  {
    printf '*INCLUDE, INPUT=%s.inp\n*BOUNDARY\n' $mesh
    for body in $bodies; do printf '%s, 1, 3\n' "${support[$body]}"; done
    printf '*STEP\n*STATIC\n*CLOAD\n'
    for body in $bodies; do printf '%s_TIP, 2, 0.6\n%s_TIP, 3, 0.8\n' "${body^^}" "${body^^}"; done
    for body in $bodies; do
      printf '*NODE PRINT, NSET=%s, TOTALS=ONLY\nRF\n' "${support[$body]}"
      printf '*EL PRINT, ELSET=%s, TOTALS=ONLY\nEVOL, EMAS\n' "${body^^}"
    done
    printf '*END STEP\n'
  } >load_$mesh.inp
  "$ccx" load_$mesh >ccx_$mesh.log
  # It goes on with a folded element and says so.
  if grep -i -e nonpositive -e '\*ERROR' ccx_$mesh.log; then exit 1; fi
done
python3 - <<'END'
import csv, re
rows = {row["body"]: row for row in csv.DictReader(open("mesh.csv"))}
for mesh in ("pinion", "gear", "pair"):
    text = open(f"load_{mesh}.dat").read()
    found, forces = {}, {}
    for kind, body, value in re.findall(r"total (volume|mass) for set (\w+)[^\n]*\n\s*([-+.\dE]+)", text):
        found[body.lower(), kind] = float(value)
    for name, values in re.findall(r"total force \(fx,fy,fz\) for set (\w+)[^\n]*\n\s*([^\n]+)", text):
        forces[name.split("_")[0].lower()] = [float(value) for value in values.split()]
    for body in ("pinion", "gear") if mesh == "pair" else (mesh,):
        for kind, column, unit in (("volume", "volume [mm^3]", 1.0), ("mass", "mass [kg]", 1e3)):
            ours, theirs = float(rows[body][column]), unit * found[body, kind]
            print(mesh, body, kind, ours, theirs)
            # CalculiX prints seven digits
            assert abs(theirs / ours - 1) < 1e-6, (body, kind, ours, theirs)
        # 1 N along (0, 0.6, 0.8) at each node of the tips; a direct solver's round-off
        tip = re.search(rf"NSET={body.upper()}_TIP\n([\d,\s]+)", open(f"{mesh}.inp").read()).group(1)
        n = len(tip.replace(",", " ").split())
        print(mesh, body, "force", forces[body], n)
        for value, part in zip(forces[body], (0, -0.6, -0.8)):
            assert abs(value - part * n) < 1e-5 * n, (body, forces[body], n)
END
