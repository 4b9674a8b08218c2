# SPDX-License-Identifier: GPL-3.0-or-later
# What ./run, ./test and .ci/run have in common: install what is missing, configure, build. Source it in the project's folder.

# install_missing_packages [MARK...]: those of packages.txt that are not marked, and those with one of these marks.
install_missing_packages() {
  local wanted missing=() package
  wanted=$(awk -v marks=" $* " '!/^#/ && NF && (NF == 1 || index(marks, " " $2 " ")) {print $1}' packages.txt)
  local installed
  # It fails where it does not know a package, which is what we want to find out.
  # shellcheck disable=SC2086
  installed=$({ dpkg-query -W -f='${Package} ${db:Status-Status}\n' $wanted 2>/dev/null || true; } |
    awk '$2 == "installed" {print $1}')
  for package in $wanted; do
    grep -qx "$package" <<<"$installed" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0

  echo "Installing ${#missing[@]} missing Debian packages: ${missing[*]}"
  local privileged=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "Installing these packages needs root privileges, and there is no sudo. As root, run:" >&2
      echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    }
    echo "This needs root privileges: sudo may ask for your password."
    privileged=(sudo)
  fi
  "${privileged[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  "${privileged[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# What is built from scratch is built with clang++: it takes a sixth less time than g++, and what it makes is as fast. CXX chooses
# another compiler; a build folder keeps the one that it was made with. Sanitizers keep to the system's.
COMPILER=clang++-14

# configure PRESET [OPTION...]: configures build/PRESET if it is not yet, if an option, such as -DROBOTCONTROL_TESTS=ON, is not as in
# its cache, or if the presets have changed since.
configure() {
  local preset=$1 cache=build/$1/CMakeCache.txt option name needed=no
  shift
  [ -z "${ROBOTCONTROL_WERROR:-}" ] || set -- "$@" "-DROBOTCONTROL_WERROR=$ROBOTCONTROL_WERROR"
  [ -f "build/$preset/build.ninja" ] && [ "$cache" -nt CMakePresets.json ] || needed=yes
  for option in "$@"; do
    name=${option#-D}
    grep -q "^${name%%=*}:[A-Z]*=${name#*=}\$" "$cache" 2>/dev/null || needed=yes
  done
  [ $needed = no ] && return 0
  echo "Configuring build/$preset"
  [ "$preset" != release ] || export CXX=${CXX:-$COMPILER}
  cmake --preset "$preset" "$@" >"build-$preset.log" 2>&1 || { cat "build-$preset.log" >&2; rm -f "build-$preset.log"; return 1; }
  rm -f "build-$preset.log"
  touch "$cache"
}

# build PRESET TARGET...: brings the given targets up to date, quietly if they are. Waits for another build in the same folder.
# As many compilers as cores: two more, as ninja has it, fight for the caches, and take a sixth longer.
build() {
  local preset=$1
  shift
  if ninja -C "build/$preset" -n "$@" 2>/dev/null | grep -q 'no work to do'; then return 0; fi
  echo "Building $* (the first build takes some minutes)"
  flock "build/$preset/.building" ninja -C "build/$preset" -j "$(nproc)" "$@"
}
