#!/bin/sh
# SPDX-License-Identifier: MIT
# Does `pantin verify` see a change? In a copy of the sources one constant at a time is changed, the program is built, and verify must
# fail and name the stage. Usage, after `make`: tools/check_verify.sh [STAGE...] (all
# unless named); docs/determinism.md has the result.
set -eu
cd "$(dirname "$0")/.."
work=build/changed
only=" $* "
rm -rf "$work"
mkdir -p "$work/build"
cp -a Makefile src include tools testdata weights references "$work"
cp -a build/release "$work/build/release"
cd "$work"
status=0

# changed STAGE FILE FROM TO: the first FROM of FILE becomes TO
changed() {
    stage=$1 file=$2 from=$3 to=$4
    case $only in "  " | *" $stage "*) ;; *) return ;; esac
    cp -p "$file" "$file.before"
    awk -v from="$from" -v to="$to" '!done && (at = index($0, from)) { $0 = substr($0, 1, at - 1) to substr($0, at + length(from)); done = 1 } { print }' \
        "$file.before" >"$file"
    if cmp -s "$file" "$file.before"; then
        echo "NOT FOUND in $file: $from"
        status=1
        return
    fi
    make -s build/release/pantin >/dev/null
    said=$(build/release/pantin verify --quiet 2>&1) && said="all agree"
    case $said in
    *"stage $stage differs"*) echo "seen: $file: $from -> $to: ${said#pantin: }" ;;
    *)
        echo "NOT SEEN in $stage: $file: $from -> $to: $said"
        status=1
        ;;
    esac
    mv "$file.before" "$file"
    touch "$file"
}

changed find src/network/regions.cpp '+ 0.5f) * bin' '+ 0.6f) * bin'
changed detect src/detection/detect.cpp '255 * darkness' '254 * darkness'
changed segment src/segmentation/views.cpp 'ink_level = 0.25f' 'ink_level = 0.3f'
changed contour src/geometry/borders.cpp '{p.x - 1, p.y - 1}' '{p.x - 2, p.y - 1}'
changed voronoi src/skeletonization/voronoi_skeleton.cpp 'std::sqrt(2.0)' '1.5'
changed thin src/skeletonization/thinning.cpp 'b <= 6' 'b <= 5'
changed reduce src/skeletonization/neighbourhood.hpp 'neighbour_count(neighbourhood) == 2' 'neighbour_count(neighbourhood) == 3'
changed graph src/skeletonization/graph_edit.cpp 'std::sqrt(2.0)' '1.5'
changed h1 src/skeletonization/heuristics.cpp 'degree[edge.v] != 1' 'degree[edge.v] != 3'
changed h2 src/skeletonization/heuristics.cpp 'graph.vertices[j].x) / 2' 'graph.vertices[j].x) / 3'
changed identify src/identification/evidence.cpp 'graph_weight = 3.110' 'graph_weight = 3.111'
changed map src/rigging/end_places.cpp 'frame_reach = 0.75' 'frame_reach = 0.25'
changed mesh src/rigging/marching_squares.cpp '0.012 * std::max' '0.013 * std::max'
changed bones src/rigging/bones.cpp 'stubby = 1.6' 'stubby = 4'
changed weights src/rigging/skin_weights.cpp '0.6 * limb.width' '0.7 * limb.width'
changed animate src/animation/footing.cpp '0.12; // cycles before' '0.13; // cycles before'
changed skin src/animation/skinning.cpp 'animation.times[i]) / step' 'animation.times[i]) / (1.01 * step)'
changed render src/animation/texture.cpp 'full_ink = 0.55f' 'full_ink = 0.6f'
changed export src/export/joints.cpp '(1 + cosine) / 2' '(1 + cosine) / 3'
changed strokes src/modeling/region_strokes.cpp 'smoothing = 2' 'smoothing = 3'
changed model src/modeling/sub_skeleton.cpp 'slices_a_diagonal = 100' 'slices_a_diagonal = 90'
changed inflate src/modeling/inflation.cpp 'load = 2' 'load = 2.1'
changed unite src/modeling/tetrahedra.cpp 'long_reach = 0.21' 'long_reach = 0.22'
changed 'bone heat' src/modeling/bone_heat.cpp 'heat = 2' 'heat = 2.1'
exit $status
