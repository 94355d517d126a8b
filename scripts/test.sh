#!/usr/bin/env bash
# Builds Druse and runs all its tests. `scripts/test.sh --sanitize` runs them under address and undefined-behaviour sanitizers, with
# a check of the whole mesh after every command: slower, and for before a release.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

preset=release
[[ ${1:-} == --sanitize ]] && preset=asan
build "$preset"
# Tests of widgets need a display, also those that show nothing.
tests/ui/on_display.sh ctest --preset "$preset" -j "$(nproc)" --output-on-failure
