# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# Shell functions that ./run and ./check share: packages, build, processors. Sourced with the current
# folder at the project's root. Everything said here goes to stderr.
# shellcheck shell=bash

build=build/release
required_packages=(g++ cmake make perl git python3 ninja-build libdeal.ii-dev libeigen3-dev
  libboost-program-options-dev libboost-serialization-dev nlohmann-json3-dev openmpi-bin numdiff)
# Faster BLAS, compiling and linking, the report, the check of docstrings: done without where they cannot be had.
wanted_packages=(libopenblas0-pthread ccache mold python3-numpy python3-matplotlib python3-jinja2
  python3-meshio python3-h5py doxygen)
# Wanted by ./check only: CalculiX (ccx), which reads exported meshes in a test; what Python's module _vfife is built of.
# shellcheck disable=SC2034
check_packages=(calculix-ccx pybind11-dev python3-dev)

say() {
  printf '%s\n' "$*" >&2
}

fail() {
  say "$program: $*"
  exit 1
}

# Those of the given packages that are not installed.
missing_packages() {
  local package
  local -A installed=()
  while read -r package; do installed[$package]=1; done < <(
    dpkg-query -W -f '${db:Status-Abbrev} ${binary:Package}\n' "$@" 2>/dev/null |
      sed -n 's/^[hi]i  *\([^: ]*\).*/\1/p')
  for package in "$@"; do
    [ -n "${installed[$package]:-}" ] || printf '%s\n' "$package"
  done
}

# How many packages that makes with all that they need, what is fetched and what they take.
describe_amount() {
  local text
  text=$(env LC_ALL=C apt-get install --assume-no --no-install-recommends "$@" 2>/dev/null </dev/null || true)
  printf '%s\n' "$text" | sed -n -e 's/^[0-9]* upgraded, \([0-9]* newly installed\).*/  \1/p' \
    -e 's/^\(Need to get .*\)$/  \1/p' -e 's/^\(After this operation.*\)$/  \1/p' >&2
}

# Why apt-get failed, by its log.
describe_failure() {
  if grep -q -i -e 'could not resolve' -e 'temporary failure resolving' -e 'network is unreachable' \
    -e 'could not connect' -e 'unable to connect' -e 'connection timed out' -e 'no route to host' "$1"; then
    echo "there is no way to the network, from which packages come"
  else
    grep '^E:' "$1" | tail -n 1
  fi
}

# Installs what is missing, also of the packages given here, which are wanted: as root, else by sudo.
install_packages() {
  command -v dpkg-query >/dev/null || return 0 # no Debian: CMake says what it does not find
  local all_wanted=("${wanted_packages[@]}" "$@") required wanted root=() log
  mapfile -t required < <(missing_packages "${required_packages[@]}")
  mapfile -t wanted < <(missing_packages "${all_wanted[@]}")
  [ $((${#required[@]} + ${#wanted[@]})) -gt 0 ] || return 0

  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null || { [ ! -t 0 ] && ! sudo -n true 2>/dev/null; }; then
      [ ${#required[@]} -eq 0 ] && return 0
      fail "these packages are missing and installing them needs root or sudo: ${required[*]}"
    fi
    root=(sudo)
  fi

  mkdir -p build
  log=build/install.log
  local apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get)
  "${apt[@]}" update >"$log" 2>&1 </dev/null ||
    say "$program: apt-get update failed (see $log), going on with the lists that are there"
  say Installing "${required[@]}" "${wanted[@]}" ...
  describe_amount "${required[@]}" "${wanted[@]}"
  if ! "${apt[@]}" install -y --no-install-recommends "${required[@]}" "${wanted[@]}" \
    >>"$log" 2>&1 </dev/null; then
    if [ ${#required[@]} -gt 0 ]; then
      "${apt[@]}" install -y --no-install-recommends "${required[@]}" >>"$log" 2>&1 </dev/null ||
        fail "apt-get could not install ${required[*]}: $(describe_failure "$log") (see $log)"
    fi
    # One at a time: a package that cannot be had keeps no other one away.
    local package
    for package in "${wanted[@]}"; do
      "${apt[@]}" install -y --no-install-recommends "$package" >>"$log" 2>&1 </dev/null || true
    done
    mapfile -t wanted < <(missing_packages "${all_wanted[@]}")
    [ ${#wanted[@]} -eq 0 ] || say "$program: without ${wanted[*]}: $(describe_failure "$log") (see $log)"
  fi
  installed_packages=1
}

# Whole processors that a control group (version 2 or 1) grants; nothing if it sets no limit.
control_group_processors() {
  local quota period path=""
  if [ -r /sys/fs/cgroup/cgroup.controllers ]; then
    path=$(sed -n 's/^0:://p' /proc/self/cgroup)
    for path in "/sys/fs/cgroup$path/cpu.max" /sys/fs/cgroup/cpu.max; do
      if [ -r "$path" ]; then
        read -r quota period <"$path"
        break
      fi
    done
  elif [ -r /sys/fs/cgroup/cpu/cpu.cfs_quota_us ]; then
    quota=$(cat /sys/fs/cgroup/cpu/cpu.cfs_quota_us)
    period=$(cat /sys/fs/cgroup/cpu/cpu.cfs_period_us)
  fi
  if [[ ${quota:-} =~ ^[0-9]+$ ]] && [ "${period:-0}" -gt 0 ]; then
    echo $((quota < period ? 1 : quota / period))
  fi
}

# The smaller of the two numbers; the second may be empty.
smaller() {
  if [ -n "${2:-}" ] && [ "$2" -lt "$1" ]; then echo "$2"; else echo "$1"; fi
}

# Physical cores (hardware threads of one core add nothing to a run that waits for memory) among the
# processors this process may use, within the control group's limit.
count_cores() {
  local range cpu siblings
  local -A cores=()
  for range in $(sed -n 's/^Cpus_allowed_list:[[:space:]]*//p' /proc/self/status | tr ',' ' '); do
    for ((cpu = ${range%-*}; cpu <= ${range#*-}; ++cpu)); do
      siblings=/sys/devices/system/cpu/cpu$cpu/topology/thread_siblings_list
      if [ -r "$siblings" ]; then cores[$(<"$siblings")]=1; else cores[$cpu]=1; fi
    done
  done
  smaller "$((${#cores[@]} > 0 ? ${#cores[@]} : $(nproc)))" "$(control_group_processors)"
}

# Compilers that fit in memory at 1.6 GB each, at most one a processor.
count_jobs() {
  local available limit used
  available=$(awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo)
  if [ -r /sys/fs/cgroup/memory.max ]; then
    limit=$(cat /sys/fs/cgroup/memory.max)
    used=$(cat /sys/fs/cgroup/memory.current)
    [ "$limit" = max ] || available=$(smaller "$available" $(((limit - used) / 1048576)))
  fi
  local jobs
  jobs=$(smaller "$(nproc)" "$(control_group_processors)")
  jobs=$(smaller "$jobs" $((available / 1600)))
  echo $((jobs > 0 ? jobs : 1))
}

# Runs ninja with the given targets; what it prints goes to a log, on a terminal with one progress
# line, and to the screen if it fails.
run_ninja() {
  local log=$build/build.log line status
  set +e
  NINJA_STATUS='[%f/%t] ' ninja -C $build -j "$(count_jobs)" "$@" 2>&1 | tee $log |
    while IFS= read -r line; do
      if [ -t 2 ] && [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] && [ "${BASH_REMATCH[2]}" -gt 4 ]; then
        printf '\r\033[KBuilding vfife: %s of %s' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
      fi
    done
  status=${PIPESTATUS[0]}
  set -e
  [ -t 2 ] && printf '\r\033[K' >&2
  if [ "$status" -ne 0 ]; then
    if ! grep -q '^FAILED' $log; then cat $log >&2; fi
    sed -n '/^FAILED/,$p' $log | grep -v -E '^\[[0-9]+/[0-9]+\]|^/usr/bin/cmake -E env' >&2 || true
    fail "the build failed (all of it: $log)"
  fi
}

# Configures where needed and builds the given ninja targets.
build_targets() {
  local start=$SECONDS
  if [ ! -w "${CCACHE_DIR:-${HOME:-/nonexistent}}" ]; then
    export CCACHE_DIR=$PWD/build/ccache
  fi
  export CCACHE_PCH_EXTSUM=true # cmake/precompiled_header.cmake
  mkdir -p $build
  exec 9>build/lock # two runs may start at once
  if ! flock -n 9; then
    say "Waiting for another build ..."
    flock 9
  fi
  # A tree that was copied or moved with its build folder.
  if [ -f $build/CMakeCache.txt ] &&
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" $build/CMakeCache.txt; then
    rm -rf $build
    mkdir -p $build
  fi
  [ -f $build/build.ninja ] ||
    say "Building vfife with $(count_jobs) compilers: some minutes the first time ..."
  # What can be built depends on the packages that there are.
  if [ ! -f $build/build.ninja ] || [ -n "${installed_packages:-}" ]; then
    if ! cmake --preset release >$build/configure.log 2>&1 </dev/null; then
      sed -n '/CMake Error/,$p' $build/configure.log >&2
      fail "the configuration failed (all of it: $build/configure.log)"
    fi
  fi
  run_ninja "$@"
  exec 9>&-
  if [ $((SECONDS - start)) -gt 5 ]; then
    say "Built in $((SECONDS - start)) s."
  fi
}

# Open MPI and BLAS as the program wants them; nothing is said about networks that are not there.
export_environment() {
  export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
  export OMPI_MCA_btl_base_warn_component_unused=0
  # Containers forbid to read other processes' memory.
  export OMPI_MCA_btl_vader_single_copy_mechanism=none
  # Two runs bound to the same cores would share them while others idle.
  export OMPI_MCA_hwloc_base_binding_policy=none
  export OMPI_MCA_rmaps_base_oversubscribe=1
  # What the program has said is enough where it ends with another code than 0.
  export OMPI_MCA_orte_execute_quiet=1
  # The same for Open MPI 5, whose mpirun is PRRTE's.
  export PRTE_MCA_hwloc_default_binding_policy=none
  export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
  if [ "$(id -u)" -eq 0 ]; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  fi
}
