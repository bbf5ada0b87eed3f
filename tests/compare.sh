#!/bin/sh
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# compare.sh SCRIPTS NUMDIFF PERL TEST EXPECTED COMMAND...: runs COMMAND in a folder of its own below the current one and
# compares its output with EXPECTED by deal.II's scripts.
set -eu
scripts=$1 numdiff=$2 perl=$3 test=$4 expected=$5
shift 5
mkdir -p "${test#*/}.run"
cd "${test#*/}.run"
sh "$scripts/run_test.sh" run "$test" "$@"
"$perl" -pi "$scripts/normalize.pl" output
sh "$scripts/run_test.sh" diff "$test" "$numdiff" "$expected"
