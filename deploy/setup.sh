# shellcheck shell=bash
# What run, test and the checks of .ci share: saying what happens, installing packages, building a preset.

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=deploy/packages.sh
. "$top/deploy/packages.sh"

say() { printf '\n\033[1m== %s\033[0m\n' "$*"; }

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# install PACKAGE...: those that are missing; asks for nothing, and does nothing the second time.
install_packages() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' ||
      missing+=("$package")
  done
  if [ ${#missing[@]} = 0 ]; then
    echo "all ${#} packages are there"
    return
  fi
  echo "${#missing[@]} to install: ${missing[*]}"
  as_root apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# build PRESET [cmake option...] -- [target...]: configures and builds; ninja shows how far it is and how long it takes.
build() {
  local preset=$1 options=()
  shift
  while [ $# -gt 0 ] && [ "$1" != -- ]; do options+=("$1"); shift; done
  [ $# -gt 0 ] && shift
  (
    cd "$top"
    cmake --preset "$preset" "${options[@]}" >"$top/build/$preset.configure.log" 2>&1 || {
      cat "$top/build/$preset.configure.log"
      echo "configuring failed; the log is build/$preset.configure.log"
      exit 1
    }
    NINJA_STATUS='[%f/%t, %es] ' cmake --build --preset "$preset" -j "$(nproc)" ${1:+--target "$@"}
  )
}
