#!/usr/bin/env bash
# Installs what Fathom needs on Debian 12: the packages of apt-packages.txt, then the JavaScript of a
# test. Where all of it is there already, it does nothing and needs no network.
#
#   scripts/install_dependencies.sh              to build, and to run every test
#   scripts/install_dependencies.sh packaging    to build packages: no tests, no npm
set -euo pipefail
cd "$(dirname "$0")/.."

for_packaging=false
if [ "${1:-}" = packaging ]; then for_packaging=true; fi

# What the tests need is the last part of apt-packages.txt.
wanted() {
  if $for_packaging; then
    sed '/^# Tests and benchmarks/,$d' scripts/apt-packages.txt
    cat scripts/apt-packages-packaging.txt
  else
    cat scripts/apt-packages.txt
  fi | sed 's/#.*//' | grep -o '[^[:space:]]\+'
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

is_installed() {
  # An npm that is not Debian's serves as well, and Debian's would clash with its Node.js.
  if [ "$1" = npm ] && command -v npm > /dev/null; then return 0; fi
  dpkg-query -W -f '${db:Status-Status} ' "$1" 2> /dev/null | grep -qw installed
}

missing=()
while read -r package; do
  is_installed "$package" || missing+=("$package")
done < <(wanted)

if [ ${#missing[@]} -gt 0 ]; then
  echo "Installing ${missing[*]}" >&2
  as_root apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
fi

if $for_packaging; then exit; fi
folder=tests/src/import/writers
# npm notes in node_modules what it installed.
if ! [ "$folder/node_modules/.package-lock.json" -nt "$folder/package-lock.json" ]; then
  (cd "$folder" && npm ci --ignore-scripts --no-audit --no-fund)
fi
