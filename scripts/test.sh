#!/usr/bin/env bash
# Builds Druse and runs all its tests: with sanitizers and full checks first, then the release build.
# `scripts/test.sh --release` leaves the sanitizers out.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
jobs=$(nproc)

# Tests of widgets need a display, also those that show nothing.
with_display() { xvfb-run -a -s "-screen 0 1280x800x24 -nolisten tcp" "$@"; }

if [[ ${1:-} != --release ]]; then
    build asan
    with_display ctest --preset asan -j "$jobs" --output-on-failure
fi
build release
with_display ctest --preset release -j "$jobs" --output-on-failure
