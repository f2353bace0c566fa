#!/bin/bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# ./dev demo and ./dev test, each from nothing, in fresh chroots of a Debian release.
#
# check_debian.sh 12|13 [FOLDER] [COMMAND...]
#   FOLDER   where the bare system, downloaded packages, the chroots and the logs are kept
#            (default: build/debian)
#   COMMAND  commands of ./dev, each in a chroot of its own (default: demo test); they share the
#            folder build/package
# The mirror is http://deb.debian.org/debian, or what MIRROR says.
set -euo pipefail

die() { echo "check_debian.sh: $*" >&2; exit 1; }

source=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
case ${1:-} in
  12) release=bookworm ;;
  13) release=trixie ;;
  *) die "which Debian? 12 or 13" ;;
esac
number=$1
cache=$(realpath -m "${2:-$source/build/debian}")
commands=("${@:3}")
[[ ${#commands[@]} -gt 0 ]] || commands=(demo test)
[[ $EUID -eq 0 ]] || die "chroot and mount are for root only"
command -v debootstrap >/dev/null || die "debootstrap is missing: apt-get install debootstrap"

# The system without anything that signorini needs, as debootstrap leaves it.
make_base() {
  local base=$cache/base$number
  [[ ! -f $base/complete ]] || return 0
  rm -rf "$base"
  mkdir -p "$base"
  echo "check_debian.sh: debootstrap $release"
  debootstrap --variant=minbase "$release" "$base/root" "${MIRROR:-http://deb.debian.org/debian}" \
    >"$base/log" || die "debootstrap failed, see $base/log"
  touch "$base/complete"
}

# What the host needs to reach the mirror. Without /etc/hosts an MPI program waits for the DNS.
connect() {
  cp /etc/resolv.conf /etc/hosts "$1/etc/"
  apt-config dump | grep -E '^Acquire::(http|https|Check-|Retries)' \
    >"$1/etc/apt/apt.conf.d/99host" || true
}

copy_checkout() {
  mkdir -p "$1"
  if git -C "$source" rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    git -C "$source" ls-files -z | tar -C "$source" --null -T - -cf - | tar -xf - -C "$1"
  else
    tar -C "$source" --exclude=./build --exclude=./output -cf - . | tar -xf - -C "$1"
  fi
}

# Runs a command of ./dev in a new chroot. All mounts are those of its own namespace and end with
# it, and so do its processes.
run() {
  local root=$cache/debian$number-$1 log=$cache/debian$number-$1.log start=$SECONDS status=0
  local environment=(PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8) name
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    [[ -z ${!name:-} ]] || environment+=("$name=${!name}")
  done
  rm -rf "$root"
  cp -a "$cache/base$number/root" "$root"
  connect "$root"
  copy_checkout "$root/srv/signorini"
  mkdir -p "$cache/packages$number" "$cache/products$number" "$root/srv/signorini/build/package"
  echo "check_debian.sh: ./dev $1 in a fresh Debian $number, log in $log"
  unshare --mount --pid --fork bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    mount --rbind /sys "$1/sys"
    mount --bind "$2" "$1/var/cache/apt/archives"
    mkdir -p "$2/partial"
    mount --bind "$4" "$1/srv/signorini/build/package"
    exec chroot "$1" env -i "${@:5}" bash -c "cd /srv/signorini && ./dev $3"
  ' bash "$root" "$cache/packages$number" "$1" "$cache/products$number" "${environment[@]}" \
    >"$log" 2>&1 || status=$?
  tail -n 15 "$log"
  echo "check_debian.sh: ./dev $1 in Debian $number: exit status $status, $((SECONDS - start)) s"
  [[ $status -ne 0 ]] || rm -rf "$root" # what has failed stays to be looked at
  return $status
}

make_base
failed=0
for command in "${commands[@]}"; do
  run "$command" || failed=1
done
exit $failed
