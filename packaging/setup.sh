# SPDX-License-Identifier: GPL-3.0-or-later
# What ./run and ./test have in common: install what is missing, configure, build. Source it in the project's folder.

install_missing_packages() {
  local wanted missing=() package
  wanted=$(grep -v '^#' packages.txt)
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
      echo "These packages need the right of root to be installed, and there is no sudo. As root, run:" >&2
      echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    }
    echo "This needs the right of root: sudo may ask for your password."
    privileged=(sudo)
  fi
  "${privileged[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  "${privileged[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# build TARGET...: brings the given targets up to date, quietly if they are.
build() {
  if [ ! -f build/release/build.ninja ]; then
    echo "Configuring build/release"
    cmake --preset release >build-release.log 2>&1 || { cat build-release.log >&2; rm -f build-release.log; return 1; }
    rm -f build-release.log
  fi
  if ninja -C build/release -n "$@" 2>/dev/null | grep -q 'no work to do'; then return 0; fi
  echo "Building $* (the first time takes some minutes)"
  ninja -C build/release "$@"
}
