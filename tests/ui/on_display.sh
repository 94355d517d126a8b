#!/usr/bin/env bash
# on_display.sh COMMAND…: runs it on a virtual display of its own. What is missing is an error, never a reason to skip.
set -euo pipefail
missing=()
for tool in xvfb-run xdotool xwd convert; do
    command -v "$tool" > /dev/null || missing+=("$tool")
done
if [[ ${#missing[@]} -gt 0 ]]; then
    echo "cannot test the window without: ${missing[*]} (Debian packages xvfb, xauth, xdotool, x11-apps, imagemagick)" >&2
    exit 1
fi
unset DISPLAY
exec xvfb-run -a -s "-screen 0 1280x800x24 -nolisten tcp" "$@"
