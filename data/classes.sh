#!/bin/sh
# Writes classes.json, the copy of it inside the program, the catalogue in docs/classes, and the numbers of docs/survey.md:
# random walks through the bodies that exist until no new class is met, witnesses far from all borders, measures from the scans
# of docs/survey.md; then walks among special bodies. What walks have met (rounds, every border with a body
# on it) is kept in survey/graph.json and special.json, and each step goes on from there.
#
#   data/classes.sh [WALLS]       (20000: so many walls without a new class; hours of a core)
set -eu
cd "$(dirname "$0")/.."
program="cargo run --release --example classes --"
state=data/survey/graph.json
general=data/survey/general.summary.json
positive=data/survey/positive.summary.json
$program grow $state existing 1 2 "${1:-20000}" $general
$program deepen $state 1
$program write $state $general $positive data/classes.json crates/documents/data/classes.json
$program special data/survey/special.json 1 60
$program pages data/classes.json docs/classes
$program report .
