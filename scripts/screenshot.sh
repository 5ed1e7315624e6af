#!/usr/bin/env bash
# scripts/screenshot.sh PAGE.html[#zoom=20,40] PICTURE.png [WIDTH HEIGHT]
#
# Pictures a report with headless Chromium. Chromium exits 0 even when it has drawn nothing, so the
# picture is removed first and looked for afterwards.
set -euo pipefail
if [[ $# -ne 2 && $# -ne 4 ]]; then
  sed -n '2p' "$0" >&2
  exit 1
fi
page=$1 picture=$2 width=${3:-1280} height=${4:-2400}
file=${page%%#*}
hash=${page:${#file}}
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  echo "$0: chromium is not installed: apt-get install chromium" >&2
  exit 1
}
[[ -f $file ]] || { echo "$0: there is no file $file" >&2; exit 1; }

profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT
rm -f "$picture"
timeout 120 "$chromium" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
  --disable-background-networking --disable-component-update --disable-sync --hide-scrollbars \
  --user-data-dir="$profile" --window-size="$width,$height" --virtual-time-budget=3000 \
  --screenshot="$(realpath -m "$picture")" "file://$(realpath "$file")$hash" >"$profile/log" 2>&1 || true
[[ -s $picture ]] || { echo "$0: no picture; chromium said:" >&2; cat "$profile/log" >&2; exit 1; }
