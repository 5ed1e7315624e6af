#!/usr/bin/env bash
# Installs what is missing, builds the packages for Debian 12 and has lintian look at them:
#
#   build/package/packages/{fathom-uuv,libfathom-uuv-dev,python3-fathom}_*.deb
#
# It needs neither npm nor, once everything is installed, a network. DEBFULLNAME and DEBEMAIL name
# who answers for the packages. scripts/check_packages.sh tries them in a clean Debian.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh packaging
# The dates inside are those of the commit.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2> /dev/null || date +%s)}
export SOURCE_DATE_EPOCH
cmake --preset package
cmake --build --preset package --parallel "$(nproc)"
rm -rf build/package/packages
(cd build/package && cpack)
# Nothing is uploaded to Debian: no bug to close, and its name for a release that is not unstable.
lintian --fail-on error --suppress-tags initial-upload-closes-no-bugs build/package/packages/*.deb
ls -l build/package/packages/*.deb
