#!/bin/bash
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# completion.sh PROJECT PROGRAM: what bash offers after the words of a command line: all options of the program, all kinds
# of studies, parameter files and folders.
set -euo pipefail
project=$1 program=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/cases" "$folder/other"
touch "$folder/case.prm" "$folder/case.txt" "$folder/cases/one.prm"
cd "$folder"
# shellcheck source=contrib/completion.bash
. "$project/contrib/completion.bash"

# Answers after these words, the last one being written, a line each, sorted.
complete_words() {
  COMP_WORDS=("$program" "$@")
  COMP_CWORD=$#
  _vfife
  printf '%s\n' "${COMPREPLY[@]}" | sort
}

expect() {
  if [ "$2" != "$3" ]; then
    printf 'FAILED: %s\nexpected:\n%s\nbut it is\n%s\n' "$1" "$3" "$2"
    exit 1
  fi
}

expect "files and folders" "$(complete_words ca)" $'case.prm\ncases'
expect "a file in a folder" "$(complete_words cases/)" cases/one.prm
expect "folders for results" "$(complete_words -o '')" $'cases\nother'
options=$("$program" --help | sed -n 's/.*\(--[a-z-]*\).*/\1/p' | grep -x -e '--[a-z-]\+' | sort -u)
expect "options" "$(complete_words --)" "$options"
expect "one option" "$(complete_words --par)" --parameter-reference
expect "the entry" "$(complete_words --set St)" Study/kind=
expect "kinds as bash splits words" "$(complete_words --set Study/kind = l)" \
  $'linear\\ static\nloaded\\ tooth\\ contact\\ analysis\nlumped'
expect "a kind in quotes" "$(complete_words --set '"Study/kind=tooth')" 'Study/kind=tooth contact analysis'

# All kinds, by the page that the program has written.
kinds=$(sed -n '/^## Study$/,/^## /s/^| kind |.*(\([^()]*\)) |$/\1/p' "$project/doc/parameter_reference.md" |
  sed 's/, /\n/g' | sort)
expect "all kinds" "$(complete_words --set '"Study/kind=' | sed 's/.*=//' | sort)" "$kinds"
echo ok
