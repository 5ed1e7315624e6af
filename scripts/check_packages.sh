#!/usr/bin/env bash
# Tries the packages that scripts/package.sh built in a clean Debian 12, as root:
#
#   scripts/check_packages.sh [packages]    without an argument those of build/package/packages
#
# debootstrap makes the Debian in build/package/debian; apt installs the packages there and finds what
# they depend on. A user without rights then goes through the main job of README.md, imports the
# Python module, and builds and runs tests/consumer/project. What was downloaded is kept in
# build/package/downloads for the next time. MIRROR names another mirror of Debian.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=$(realpath "${1:-build/package/packages}")
root=$PWD/build/package/debian
downloads=$PWD/build/package/downloads
mirror=${MIRROR:-http://deb.debian.org/debian}

if [ "$(id -u)" -ne 0 ]; then
  echo 'check_packages.sh: is run by a user without rights, expected root: debootstrap and chroot need it.' >&2
  exit 1
fi
scripts/install_dependencies.sh packaging
programs=$(ls "$packages"/fathom-uuv_*.deb)
library=$(ls "$packages"/libfathom-uuv-dev_*.deb)
python=$(ls "$packages"/python3-fathom_*.deb)

mkdir -p "$downloads/partial"
rm -rf --one-file-system "$root"
debootstrap --variant=minbase --cache-dir="$downloads" bookworm "$root" "$mirror"
cp "$programs" "$library" "$python" "$root/root"
cp -r tests/consumer/project "$root/opt/consumer"

# The mounts are gone with their name space.
inside() {
  unshare --mount --pid --fork sh -ec '
    root=$1; shift
    mount -t proc proc "$root/proc"
    mount --rbind /dev "$root/dev"
    mount --bind "$0" "$root/var/cache/apt/archives"
    exec chroot "$@"' "$downloads" "$root" "$@"
}
as_root() {
  inside "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"
}
as_user() {
  inside --userspec=tester "$root" /usr/bin/env -i PATH=/usr/bin:/bin HOME=/home/tester LC_ALL=C.UTF-8 \
    sh -exc "cd /home/tester; $1"
}
install() {
  as_root apt-get install -qq -y --no-install-recommends "$@"
}
title() { printf '\n== %s\n' "$*"; }

as_root useradd --create-home tester

title 'Programs'
install "/root/${programs##*/}"
as_user '
  ln -s /usr/share/fathom data
  fathom --version
  fathom_synthesize --vehicle=data/vehicles/flatfish.yaml --experiment=data/experiments/steps.yaml --seed=1 \
    --out=surge_steps
  fathom check --log=surge_steps --report=check.html
  fathom identify --log=surge_steps --dof=surge --model=surge.json
  fathom simulate --model=surge.json --log=surge_steps --out=prediction.csv
  fathom diagnose --log=surge_steps --dof=surge --verdict=verdict.json --report=diagnosis.html
  fathom compare --log=data/flatfish --dofs=surge,heave,yaw --report=flatfish.html
  fathom_import --from=data/recordings/pool.csv --map=data/recordings/pool_map.yaml --out=pool
  fathom_import --from=data/recordings/pool.csv --suggest > map.yaml
  grep -q uPlot diagnosis.html
  ls -l check.html diagnosis.html flatfish.html surge.json verdict.json pool'

title 'Man pages and completion'
files=$(dpkg-deb --fsys-tarfile "$programs" | tar -t)
for program in $(sed -n 's|^\./usr/bin/\(.\)|\1|p' <<< "$files"); do
  for file in "man/man1/$program.1.gz" "bash-completion/completions/$program"; do
    grep -qx "./usr/share/$file" <<< "$files" || {
      echo "$programs: lacks /usr/share/$file." >&2
      exit 1
    }
  done
done

title 'Python module'
install "/root/${python##*/}"
as_user '
  python3 -c "import fathom; print(fathom.__file__); print(fathom.identify(\"data/flatfish\", dof=\"surge\"))"'

# Every command of the tour, as the installed README.md has it, but for pip, in whose place there is
# python3-fathom. dive.csv is not followed on.
title 'The tour of README.md'
as_user '
  mkdir tour
  cd tour
  ln -s /usr/share/fathom data
  # A minute under way: 900 kg, 300 kg/m, pushed ahead and astern.
  awk "BEGIN {
    print \"t,tau,v\"
    for (i = v = 0; i < 600; ++i) {
      force = int(i / 80) % 2 ? -60 : 90
      print 0.1 * i \",\" force \",\" v
      v += 0.1 * (force - 300 * v * (v < 0 ? -v : v)) / 900
    }
  }" > dive.csv
  sed -n "/^## A tour/,/^## /s/^    //p" /usr/share/doc/fathom-uuv/README.md |
    sed "s/^tail -n +1 -F /cat /; /^pip install /d" > ../tour.sh
  grep -c ^fathom_ ../tour.sh
  sh -ex ../tour.sh
  ls -l *.json *.html flatfish.h plan prediction.csv heave_tracked/pose.csv'

title 'Library'
install "/root/${library##*/}" cmake g++ make
as_user '
  cmake -S /opt/consumer -B consumer -DCMAKE_BUILD_TYPE=Release
  cmake --build consumer
  consumer/consumer
  # All that the library depends on is there.
  mkdir everything
  echo "cmake_minimum_required(VERSION 3.22)
  project(everything LANGUAGES CXX)
  find_package(Fathom REQUIRED)" > everything/CMakeLists.txt
  cmake -S everything -B everything/build'

title 'Removed without a trace'
as_root apt-get purge -qq -y fathom-uuv libfathom-uuv-dev python3-fathom
left=$(find "$root/usr" -iname '*fathom*')
if [ -n "$left" ]; then
  printf 'Removing the packages left\n%s\n' "$left" >&2
  exit 1
fi
rm -rf --one-file-system "$root"
echo 'The packages work in a clean Debian 12.'
