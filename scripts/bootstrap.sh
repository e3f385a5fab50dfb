# Sourced by run.sh and test.sh: installs what is missing, so that both work on a fresh Debian or Ubuntu.
#     bootstrap run         what is built: a C compiler, cmake, make; Expat and zlib, which reading VTU needs; and a C++
#                           compiler with CGAL, the oracle
#     bootstrap tests       and what the tests need: Check, pkg-config, xz; TetGen, a second oracle, where there is a package
# Elsewhere it says what is needed, and ends the script if there is no compiler or no cmake.
# shellcheck shell=bash

say() {
  printf 'gmds: %s\n' "$*" >&2
}

has() {
  command -v "$1" >/dev/null
}

has_package() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# What can be built with at all.
require_compiler_and_cmake() {
  if ! has cc && ! has gcc && ! has clang; then
    say "there is no C compiler"
    exit 1
  fi
  if ! has cmake; then
    say "there is no cmake"
    exit 1
  fi
  local version
  version=$(cmake --version | sed -n '1s/.* //p')
  if [ "$(printf '3.25\n%s\n' "$version" | sort -V | head -n 1)" != 3.25 ]; then
    say "cmake 3.25 or later is needed, this is $version"
    exit 1
  fi
}

# The Debian packages that are missing, one a line.
missing_packages() {
  has cc || printf '%s\n' gcc libc6-dev
  has c++ || echo g++
  has cmake || echo cmake
  has make || has ninja || echo make
  local package packages="libcgal-dev libgmp-dev libmpfr-dev libexpat1-dev zlib1g-dev"
  if [ "$1" = tests ]; then
    has pkg-config || echo pkg-config
    has xz || echo xz-utils
    packages="$packages check"
  fi
  for package in $packages; do
    has_package "$package" || echo "$package"
  done
}

# Those that are installed where the distribution has them.
optional_packages() {
  if [ "$1" = tests ] && ! has_package libtet1.5-dev; then
    echo libtet1.5-dev
  fi
}

apt_get() {
  if [ "$(id -u)" = 0 ]; then
    DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@" >/dev/null
  else
    sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@" >/dev/null
  fi
}

bootstrap() {
  local missing optional package
  if has apt-get && has dpkg-query; then
    mapfile -t missing < <(missing_packages "$@")
    mapfile -t optional < <(optional_packages "$@")
    if [ ${#missing[@]} -gt 0 ]; then
      if [ "$(id -u)" != 0 ] && ! has sudo; then
        say "please install as root: ${missing[*]}"
      else
        say "installing ${missing[*]}"
        apt_get update || say "the package lists could not be brought up to date"
        apt_get -y --no-install-recommends install "${missing[@]}" || say "not everything could be installed"
      fi
    fi
    for package in ${optional[@]+"${optional[@]}"}; do
      if apt-cache show "$package" >/dev/null 2>&1 && { [ "$(id -u)" = 0 ] || has sudo; }; then
        say "installing $package"
        apt_get -y --no-install-recommends install "$package" || say "$package could not be installed: its tests are skipped"
      else
        say "there is no package $package here: its tests are skipped"
      fi
    done
  else
    say "no apt-get here, so please install a C compiler, cmake 3.25 or later, make or ninja, Expat and zlib for" \
      "reading VTU, and, for all tests, pkg-config, Check, xz and a C++ compiler with GMP, MPFR and CGAL"
  fi
  require_compiler_and_cmake
  if has ninja; then
    export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
  fi
}

# How many processes may run at once.
jobs_at_once() {
  nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2
}
