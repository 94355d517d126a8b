#!/usr/bin/env bash
# on_display.sh COMMAND…: runs it on a virtual display of its own and ends as it ends. What is missing is an error, never a reason to
# skip. The server names its own free number, so any number of these may start at once, and leaves nothing behind that must be cleaned up.
set -euo pipefail
missing=()
for tool in Xvfb xdotool xwd convert; do
    command -v "$tool" > /dev/null || missing+=("$tool")
done
if [[ ${#missing[@]} -gt 0 ]]; then
    echo "cannot test the window without: ${missing[*]} (Debian packages xvfb, xdotool, x11-apps, imagemagick)" >&2
    exit 1
fi
coproc SERVER { exec Xvfb -displayfd 1 -screen 0 1280x800x24 -nolisten tcp -noreset 2> /dev/null; }
server=$SERVER_PID
trap 'kill "$server" 2> /dev/null || true; wait "$server" || true' EXIT
read -r number <&"${SERVER[0]}" || { echo "the virtual display did not start" >&2; exit 1; }
DISPLAY=":$number" "$@"
