#!/bin/bash
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# first_run.sh PROJECT: ./run and ./check of a fresh copy with a made-up apt-get. Help and version come at once; what is installed, and how
# much, is said before; a network that is not there is called that.
set -euo pipefail
project=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/copy/contrib" "$folder/bin"
cp "$project"/{run,check,README.md,CMakeLists.txt} "$folder/copy"
cp "$project/contrib/prepare.sh" "$folder/copy/contrib"

# No package is installed; whoever asks is noted.
cat >"$folder/bin/dpkg-query" <<'END'
#!/bin/bash
exit 1
END
cat >"$folder/bin/apt-get" <<END
#!/bin/bash
echo "\$*" >>"$folder/calls"
case "\$*" in
update) ;;
*--assume-no*)
  printf '%s\n' '0 upgraded, 812 newly installed, 0 to remove and 0 not upgraded.' \\
    'Need to get 1,234 MB of archives.' 'After this operation, 4,567 MB of additional disk space will be used.'
  exit 1 ;;
*)
  echo "E: Failed to fetch http://deb.debian.org/x.deb  Temporary failure resolving 'deb.debian.org'"
  exit 100 ;;
esac
END
printf '#!/bin/bash\n[ "$1" = -u ] && echo 0\n' >"$folder/bin/id"
chmod +x "$folder"/bin/*
export PATH=$folder/bin:$PATH

fail() {
  echo "FAILED: $1"
  cat "$folder/said"
  exit 1
}

cd "$folder/copy"
for option in --version --help -h; do
  ./run prm/any.prm $option >"$folder/said" 2>&1 || fail "$option ends with $?"
  [ ! -e "$folder/calls" ] && [ ! -e build ] || fail "$option installs or builds"
done
for option in --help -h; do
  ./check $option >"$folder/said" 2>&1 || fail "$option of ./check ends with $?"
  grep -q '^usage: ./check' "$folder/said" || fail "$option of ./check says nothing of it"
  [ ! -e "$folder/calls" ] && [ ! -e build ] || fail "$option of ./check installs or builds"
done
./run --version >"$folder/said"
version=$(sed -n 's/^project(vfife VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ "$(cat "$folder/said")" = "vfife $version (not built yet)" ] || fail "the version is another one"
./run --help >"$folder/said"
grep -q -e '--restart' "$folder/said" || fail "the help names no options"

if ./run >"$folder/said" 2>&1; then fail "without packages it goes on"; fi
grep -q '812 newly installed' "$folder/said" || fail "how many packages is not said"
grep -q 'Need to get 1,234 MB' "$folder/said" || fail "how much is fetched is not said"
grep -q 'After this operation, 4,567 MB' "$folder/said" || fail "what it takes is not said"
grep -q 'no way to the network' "$folder/said" || fail "a missing network is not named"
said=$(grep -n -- --assume-no "$folder/calls" | head -n 1 | cut -d: -f1)
done=$(grep -n 'install -y' "$folder/calls" | head -n 1 | cut -d: -f1)
[ "$said" -lt "$done" ] || fail "the amount is said too late"

# What is needed is there, and what is only wanted cannot be had: it goes on (here as far as CMake) and says why.
cat >"$folder/bin/dpkg-query" <<'END'
#!/bin/bash
for package in "${@:4}"; do [[ $package == python3-* ]] || echo "ii  $package"; done
END
printf '#!/bin/bash\nexit 1\n' >"$folder/bin/cmake"
chmod +x "$folder/bin/cmake"
if ./run >"$folder/said" 2>&1; then fail "without CMake it goes on"; fi
grep -q 'without python3-.*: there is no way to the network' "$folder/said" || fail "why packages are missing is not said"
grep -q 'the configuration failed' "$folder/said" || fail "it does not go on without them"
echo "first run: ok"
