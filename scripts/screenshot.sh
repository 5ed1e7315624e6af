#!/usr/bin/env bash
# scripts/screenshot.sh PAGE.html[#zoom=20,40] PICTURE.png [WIDTH HEIGHT [light|dark|print]]
#
# Pictures a report with headless Chromium. `print` shows on the screen what goes to paper. Chromium exits 0 even when it has drawn nothing, so the
# picture is removed first and looked for afterwards.
set -euo pipefail
if [[ $# -ne 2 && $# -ne 4 && $# -ne 5 ]]; then
  sed -n '2p' "$0" >&2
  exit 1
fi
page=$1 picture=$2 width=${3:-1280} height=${4:-2400} look=${5:-light}
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
scheme=1
case $look in
  light) ;;
  dark) scheme=0 ;;
  print)
    sed 's/@media print/@media all/; s#</body>#<script>addEventListener("load", () => dispatchEvent(new Event("beforeprint")));</script></body>#' \
      "$file" > "$profile/paper.html"
    file=$profile/paper.html
    ;;
  *) sed -n '2p' "$0" >&2; exit 1 ;;
esac
timeout 120 "$chromium" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
  --disable-background-networking --disable-component-update --disable-sync --hide-scrollbars \
  --user-data-dir="$profile" --window-size="$width,$height" \
  --blink-settings=preferredColorScheme=$scheme --virtual-time-budget=3000 \
  --screenshot="$(realpath -m "$picture")" "file://$(realpath "$file")$hash" >"$profile/log" 2>&1 || true
[[ -s $picture ]] || { echo "$0: no picture; chromium said:" >&2; cat "$profile/log" >&2; exit 1; }
