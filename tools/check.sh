#!/bin/bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# Checks that take longer than the tests: ./dev check KIND. Whatever differs from ./dev test is
# decided by round-off or by the machine, and is mended by a law that holds on every machine.
# A kind is a function check_KIND and a line of the usage.
set -euo pipefail

cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
python=/usr/bin/python3

usage() {
  cat <<'END'
usage: ./dev check <kind> [ARGS]

  --debian 12|13 [FOLDER]  demo and tests in fresh chroots of that Debian, kept in FOLDER
                           (default: build/debian); needs root and debootstrap
  --package 12|13 [FOLDER] a package made in a fresh chroot of that Debian, and tried in another one
  --perturb [ARGS]         all tests with initial velocities that differ by 1e-12, up and down
  --no-native [ARGS]       all tests, compiled for any processor
  --no-fma [ARGS]          all tests, compiled without fused multiply-add
  --debug [ARGS]           the tests of single modules, with the assertions of deal.II
  --sanitize [ARGS]        the tests of single modules and small scenes, with the sanitizers for
                           addresses and undefined behaviour
  --memory [ARGS]          10 000 steps on changing meshes: the memory must not grow (--steps N)
  --siconos [ARGS]         Siconos (31 MB to download, 226 MB on the disk) solves problems of steps
                           to the same forces
  --clang                  compiles program and tests with Clang, warnings as errors
  --format                 whether clang-format would change a source (version 14 is the reference)
                           (ARGS go to ctest: ./dev check --perturb -R step_size)
END
}

# Builds into a folder of its own and runs the tests. $1: its name, then options of cmake up to --,
# then those of ctest.
build_and_test() {
  local folder=build/check-$1 options=()
  shift
  while [[ $1 != -- ]]; do
    options+=("$1")
    shift
  done
  shift
  cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "${options[@]}"
  cmake --build "$folder"
  ctest --test-dir "$folder" --output-on-failure -j2 "$@"
}

check_debian() {
  tools/check_debian.sh "$@"
}

check_package() {
  tools/check_debian.sh "$1" "${2:-build/debian}" package try-package
}

check_perturb() {
  local failed=0 part
  cmake --preset release
  cmake --build --preset release
  for part in 1e-12 -1e-12; do
    echo "./dev: all tests with initial velocities changed by $part of themselves"
    SIGNORINI_PERTURB=$part ctest --preset release -j2 "$@" || failed=1
  done
  return $failed
}

check_no_native() {
  build_and_test no-native -DSIGNORINI_NATIVE=OFF -- "$@"
}

check_no_fma() {
  build_and_test no-fma -DCMAKE_CXX_FLAGS=-ffp-contract=off -- "$@"
}

# Whole scenes would take ten times as long as in release, and show nothing more.
check_debug() {
  cmake --preset debug -DSIGNORINI_WARNINGS_AS_ERRORS=ON
  cmake --build --preset debug
  ctest --preset debug -j2 -LE "scenes|verification|style|plotting" "$@"
}

# Leaks of MPI and of libraries that live as long as the program are left out, by the list of
# suppressions. OpenMPI starts programs of its own, which would be asked for leaks, too.
check_sanitize() {
  cmake --preset sanitize
  cmake --build --preset sanitize
  local suppressions=$PWD/tools/sanitizers/leaks.txt
  export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:detect_stack_use_after_return=1
  export LSAN_OPTIONS=suppressions=$suppressions:print_suppressions=0
  export UBSAN_OPTIONS=print_stacktrace=1
  ctest --preset sanitize -j2 -LE "scenes|verification|style|plotting" "$@"
  ctest --preset sanitize -j2 -R "^(fuzz|verification_(small_scenes|early_ends))$" "$@"
}

check_memory() {
  cmake --preset release
  cmake --build --preset release --target signorini
  "$python" -B tools/memory.py build/release/signorini build/memory "$@"
}

check_siconos() {
  ./dev build
  "$python" -c "import siconos.numerics, h5py" || {
    echo "./dev: as root: apt-get install --no-install-recommends python3-siconos python3-h5py" >&2
    return 1
  }
  ctest --preset release -R '^verification_siconos$' "$@"
}

check_clang() {
  cmake -S . -B build/check-clang -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER=clang++ -DSIGNORINI_WARNINGS_AS_ERRORS=ON
  cmake --build build/check-clang
}

check_format() {
  local version
  version=$(clang-format --version | grep -oE 'version [0-9]+')
  if [[ $version != "version 14" ]]; then
    echo "./dev: this is clang-format $version, which breaks lines at other places: not checked"
    return
  fi
  git ls-files -z '*.h' '*.cc' | xargs -0 -r clang-format --dry-run -Werror
}

kind=${1:-}
[[ $# -eq 0 ]] || shift
case $kind in
  --debian | --package | --perturb | --no-native | --no-fma | --debug | --sanitize | --memory | \
    --siconos | --clang | --format)
    function=check_${kind#--}
    "${function//-/_}" "$@"
    ;;
  *)
    usage >&2
    exit 2
    ;;
esac
