#!/bin/sh
# SPDX-License-Identifier: MIT
# Draws testdata/ again, bit for bit: tools/make_testdata.sh [FOLDER] (default testdata). Needs `make doodle`;
# DOODLE names another build of it. Golden digests of the tests follow from these pictures.
set -eu
cd "$(dirname "$0")/.."
out=${1:-testdata}
doodle=${DOODLE:-build/release/doodle}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

# draw NAME KIND SEED INDEX OPTION...: picture or label map number INDEX of a series becomes OUT/NAME
draw() {
    name=$1 kind=$2 seed=$3 index=$4
    shift 4
    "$doodle" "$work/page" --seed "$seed" --first "$index" --count 1 "$@"
    mv "$work/page/$kind/"* "$out/$name"
    rm -rf "$work/page"
}

zoo="humanoid:person,quadruped:dog,flying:gull,quadruped:giraffe"
draw demo.png image 8 33 --types $zoo --size 840 --height 600 --photo 0 --paper 1 --colour 1 --gaps 0.1 --fill 0.88 \
    --tilt 0.5 --pen 3.5
draw lined.png image 8 17 --types $zoo --size 720 --height 512 --photo 0 --paper 1 --colour 1 --gaps 0.1 --fill 0.88 \
    --tilt 0.5 --pen 3

ink="--size 640 --height 480 --photo 0 --paper 0 --colour 0 --pen 4 --fill 0.9"
draw humanoid.png image 21 6 --types humanoid $ink
draw quadruped.png image 22 11 --types quadruped $ink
draw flying.png image 23 5 --types flying $ink
draw photo.jpg image 24 10 --type mixed --format jpg --size 640 --height 480 --photo 1 --fill 0.85
# one good character beside a head alone, a scribble and a blob
draw rejects.png image 25 4 --types quadruped:cat,head,scribble,blob --size 640 --height 480 --photo 0 --paper 0 \
    --colour 0 --pen 3 --gaps 0.2

small="--size 320 --photo 0 --paper 0 --colour 0 --pen 3 --fill 0.95"
draw labels_humanoid.png label 21 6 --types humanoid $small
draw labels_quadruped.png label 22 8 --types quadruped $small
draw labels_flying.png label 23 5 --types flying $small

# the drawings of `pantin verify`
tiny="--size 200 --photo 0 --paper 0 --colour 0 --pen 2.5 --fill 0.9"
mkdir -p "$out/vectors/humanoid" "$out/vectors/quadruped" "$out/vectors/flyer"
draw vectors/humanoid/page.png image 21 17 --types humanoid $tiny
draw vectors/quadruped/page.png image 22 55 --types quadruped $tiny
draw vectors/flyer/page.png image 23 52 --types flying $tiny
# and those of the preset `thesis`: the network leaves a hole in the silhouette of the first one
mkdir -p "$out/vectors/thesis/hole"
draw vectors/thesis/hole/page.png image 77 110 --type mixed --size 150 --photo 0 --paper 0 --colour 0 --pen 2 --fill 0.9
tools/make_thesis_pages.py "$out/vectors/thesis"

# a motion for people to follow
tools/make_dance.py > "$out/dance.bvh"

# closed outlines, for the figures of docs/figures
clear="--photo 0 --paper 0 --colour 0 --pen 3.5 --fill 0.92 --gaps 0 --tilt 0.3"
draw dog.png image 31 3 --type quadruped --size 480 --height 360 $clear
draw person.png image 32 4 --type humanoid --size 360 --height 480 $clear
