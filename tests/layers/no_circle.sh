#!/usr/bin/env bash
# Fails if files include each other in a circle, a header and the .cc of its name counted as one.
#
#   no_circle.sh SOURCE_DIR
set -euo pipefail
cd "$1"
includes=$(for storey in src problems tools; do
  (cd $storey && grep -roE --include='*.h' --include='*.cc' '^#include "fathom/[^"]*\.h"' fathom)
done | sed -E 's/\.(h|cc):#include "/ /; s/\.h"$//' | awk '$1 != $2' | sort -u)
if (("$(wc -l <<<"$includes")" < 1000)); then
  echo "Hardly a file in $PWD includes another." >&2
  exit 1
fi
# It names the files of a circle.
tsort <<<"$includes" >/dev/null
