#!/usr/bin/env bash
# Draws every picture of this folder anew: `docs/gallery/render.sh [DRUSE]`, where DRUSE is the program (build/druse if it is not given).
set -euo pipefail
druse=$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../../build/druse}")
cd "$(dirname "${BASH_SOURCE[0]}")"

# draw FIGURE [OPTION …]: how the model that FIGURE.druse makes is looked at.
draw() { "$druse" render "$1.druse" -o "$1.png" "${@:2}"; }

draw fig_03_any_polygon --size 640x400 --edges --view 20,30
for figure in fig_05_tetrahedral fig_06_cubical fig_07_octahedral fig_08_dodecahedral fig_11_icosahedral fig_14_cuboctahedral \
    fig_15_rhombicuboctahedral; do
    draw "$figure" --size 720x320 --edges --view 12,22 --parallel
done
draw fig_13_paired_vertices --size 720x320 --edges --view 12,22 --parallel
draw fig_16_tier_pairs --size 640x480 --edges --groups --view 25,25
draw fig_17_four_sides --size 640x400 --edges --view 30,35
draw fig_18_checkerboard --size 480x460 --edges --groups --view 35,25
draw fig_19_shared_vertex --size 640x480 --edges --groups --view 180,58.28 --parallel
draw fig_23_groups --size 560x520 --edges --groups --view 25,20
draw fig_24_cuboctahedral --size 720x400 --edges --view 20,14 --parallel
draw fig_24_rhombicuboctahedral --size 720x400 --edges --view 20,14 --parallel
draw fig_25_towers --size 720x400 --edges --view 20,14 --parallel
draw fig_26_menger --size 560x520 --view 35,25
draw fig_26_sierpinski --size 560x520 --view 120,-30
draw fig_26_cubes --size 560x520 --view 35,25
draw fig_27_cluster --size 560x520 --edges
draw fig_27_facets --size 560x520 --edges
draw fig_28_crown --size 520x480 --edges
draw fig_28_buds --size 560x520 --edges
draw fig_28_arms --size 560x520 --edges
draw fig_28_spikes --size 560x520 --edges
draw truncation_03_tetrahedron --size 720x280 --edges --groups --view 120,30 --parallel
for figure in truncation_04_cube truncation_04_dodecahedron truncation_05_octahedron truncation_05_icosahedron; do
    draw "$figure" --size 640x320 --edges --groups --view 20,25 --parallel
done
draw truncation_06_star --size 560x480 --edges --groups --view 30,35
draw truncation_06_notch --size 560x500 --edges --groups --view 112,32
draw truncation_08_wall --size 720x440 --groups --view 20,14
draw rind_01_elephant --size 600x460 --view 35,18
for figure in rind_02_balls rind_02_links rind_03_branching rind_05_hall; do draw "$figure" --size 480x460; done
draw strut_01_wombat --size 480x380 --view 35,18
draw strut_03_diamond --size 440x420 --view 22,18
draw strut_04_double_diamond --size 420x400 --groups --view 22,18
draw strut_05_triamond --size 480x460 --view 40,30
draw strut_06_double_triamond --size 480x460 --groups --view 40,30
for figure in strut_09_sand_dollar_a strut_09_sand_dollar_b strut_09_sand_dollar_c strut_09_sand_dollar_d; do draw "$figure" --size 440x420 --view 10,55; done
draw strut_10_polyp --size 560x400 --view 20,35
draw strut_11_spring --size 480x400 --view 20,25
for figure in strut_11_helix strut_11_helix_7; do draw "$figure" --size 480x460 --view 20,15; done
for figure in strut_12_swirl_5 strut_12_swirl_7; do draw "$figure" --size 480x420 --view 20,50; done
draw strut_13_knotted_kelp --size 560x500 --view 30,60
for figure in strut_15_icosa_lace strut_15_dodeca_lace; do draw "$figure" --size 420x400 --view 20,20; done
draw tile_bird --size 720x580 --groups --view 15,72
draw tile_bird_layers --size 760x560 --groups --view 4,48
draw tile_bird_bottom --size 640x460 --groups --view 0,-62
draw tile_fish --size 560x520 --groups --view 0,78
draw tile_fish_layers --size 720x520 --groups --view 20,42
draw tile_whale --size 560x520 --groups --view 0,78
draw tile_whale_layers --size 640x500 --groups --view 50,40
draw cell_carp --size 640x420 --groups --view 18,8
draw cell_carp_skewed --size 640x420 --groups --view 18,8
draw cell_carp_school --size 720x520 --groups --view 24,12
draw cell_turtle --size 560x420 --groups --view 40,16
draw cell_turtle_school --size 720x520 --groups --view 40,18
