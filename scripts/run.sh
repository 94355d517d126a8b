#!/usr/bin/env bash
# Builds Druse and opens its window on a model; without a display, plays a demo session into out/.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
build release druse
druse=build/druse

demo() {
    mkdir -p out
    "$druse" apply scripts/demo.druse -o out/demo.druse -o out/demo.stl -o out/demo_4.obj \
        -c document.undo -o out/demo_3.obj -c document.undo -o out/demo_2.obj -c document.undo -o out/demo_1.obj \
        -c document.undo -o out/demo_0.obj
    local k
    for k in 0 1 2 3 4; do
        "$druse" render "out/demo_$k.obj" -o "out/demo_$k.png" --edges --groups --view 35,20
    done
    "$druse" info out/demo.stl
    echo "The session is in out/: its script (demo.druse), a model for printing (demo.stl), and every state as .obj and .png."
}

if [[ -z ${DISPLAY:-} ]]; then
    echo "There is no display to open a window on; a demo session instead."
    demo
    exit
fi
status=0
"$druse" "${@:-models/colored_cube.obj}" || status=$?
if [[ $status -eq 3 ]]; then # what a window needs is not there
    echo "The window could not be opened; a demo session instead."
    demo
    exit
fi
exit $status
