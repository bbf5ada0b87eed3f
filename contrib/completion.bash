# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# Completion of vfife for bash: options, parameter files, folders, kinds of studies. Installed it is found by
# bash-completion; from the tree: source contrib/completion.bash
# shellcheck shell=bash

_vfife() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} setting
  COMPREPLY=()

  # A kind has blanks, and "=" is a word of its own to bash: --set Study/kind = kind
  local kinds="run
reduced
waves
static
tooth contact analysis
flank fit
mesh
modal
linear static
loaded tooth contact analysis
lumped
sweep
compare"
  setting=${current#[\"\']}
  if [[ $current == = && $previous == *Study/kind ]] || [[ $setting == Study/kind=* ]] ||
    [[ $previous == = && ${COMP_WORDS[COMP_CWORD - 2]} == *Study/kind ]]; then
    local before="" begun=$current IFS=$'\n'
    [[ $current == = ]] && begun=
    [[ $setting == Study/kind=* ]] && before=Study/kind= begun=${setting#Study/kind=}
    mapfile -t COMPREPLY < <(compgen -P "$before" -W "$kinds" -- "${begun#[\"\']}")
    # blanks within quotes stand for themselves
    [[ $current == [\"\']* ]] || mapfile -t COMPREPLY < <(printf '%s\n' "${COMPREPLY[@]}" | sed 's/ /\\ /g')
    return
  fi

  case $previous in
  -o | --output)
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$current")
    return
    ;;
  --set)
    compopt -o nospace 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -W "Study/kind=" -- "$setting")
    return
    ;;
  esac
  if [[ $current == -* ]]; then
    # those of the program itself
    mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" --help 2>/dev/null | grep -o -e '--[a-z-]*' | sort -u)" -- "$current")
    return
  fi
  # Parameter files and the folders on the way to them, or to one to go on in.
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -X '!*.prm' -- "$current"; compgen -d -- "$current")
}
complete -F _vfife vfife
