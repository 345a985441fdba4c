# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# What ./run and ./test have in common; sourced by them in the root of the tree.

build_dir=build/release

# Ends the script with one sentence.
fail() {
  echo "$1" >&2
  exit 1
}

require_debian_12() {
  local system
  system=$(. /etc/os-release 2>/dev/null && echo "${ID:-} ${VERSION_ID:-}") || true
  if [ "$system" != "debian 12" ]; then
    fail "relievo builds on Debian 12; this system is '${system:-unknown}', which is not supported."
  fi
}

# Prints the packages of .ci/packages.txt that are not installed; for_run: but for what only pages and
# tests need.
missing_packages() {
  local wanted left_out='^$'
  if [ "${1:-}" = for_run ]; then left_out='# not for ./run'; fi
  wanted=$(grep -v -e "$left_out" .ci/packages.txt | sed -e 's/#.*//' | xargs)
  # shellcheck disable=SC2086  # one word per package
  comm -23 <(printf '%s\n' $wanted | sort -u) \
    <(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' $wanted 2>/dev/null |
      sed -n 's/^ii  *//p' | sort -u) | xargs
}

# apt as root directly, for anybody else through sudo.
install_packages() {
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "Missing packages: $*. Install them as root, or install sudo, and start again."
    as_root=(sudo)
  fi
  echo "These Debian packages are missing and will be installed, with what they depend on:"
  echo "$*" | fold -s -w 78 | sed 's/^/  /'
  local failed="The packages could not be installed; apt's messages above say why."
  "${as_root[@]}" apt-get -q update || fail "$failed"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y --no-install-recommends install "$@" || fail "$failed"
}

install_what_is_missing() {
  local missing
  missing=$(missing_packages "$@")
  # shellcheck disable=SC2086  # one word per package
  if [ -n "$missing" ]; then install_packages $missing; fi
}

# Compile jobs: one per core, but 1.5 GB of free memory for each.
compile_jobs() {
  local cores memory_mb limit jobs
  cores=$(nproc)
  memory_mb=$(awk '/^MemAvailable/ {print int($2 / 1024)}' /proc/meminfo)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)
  if [ "$limit" != max ] && [ $((limit / 1048576)) -lt "$memory_mb" ]; then
    memory_mb=$((limit / 1048576))
  fi
  jobs=$((memory_mb / 1536))
  if [ "$jobs" -gt "$cores" ]; then jobs=$cores; fi
  if [ "$jobs" -lt 1 ]; then jobs=1; fi
  echo "$jobs"
}

# Configures once (later changes are noticed by the build itself) and builds the named targets.
build() {
  # So that precompiled headers and their dates do not keep ccache from its work.
  export CCACHE_SLOPPINESS=pch_defines,time_macros
  if [ ! -e "$build_dir/build.ninja" ]; then
    cmake --preset release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache || fail "Configuring failed."
  fi
  cmake --build --preset release --parallel "$(compile_jobs)" --target "$@" ||
    fail "Building failed."
}
