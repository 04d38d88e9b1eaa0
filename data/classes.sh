#!/bin/sh
# Writes classes.json, the copy of it inside the program, and the numbers of docs/survey.md
# and docs/types.md: random walks through the bodies that exist, witnesses far from all borders, measures from the scans of
# docs/survey.md, walks among all A > 0, walks among special bodies. What walks have met (rounds, every border with a body on
# it) is kept in survey/graph.json, graph_all.json and special.json, and each step goes on from there: walks begin at the
# witnesses as they stand, so the same rounds from other witnesses meet other walls.
#
#   data/classes.sh              (what follows from the states: measures, reports; minutes)
#   data/classes.sh WALLS        (first goes on until WALLS walls in a row led to no new class; hours of a core)
#
# The rounds in graph.json are those of
#
#   for steps in 1 1 2 2 2 2 2 2 2 2 1 1 1 1 1 1 1 1 1 1 1 1; do
#       $program round $state existing 1 $steps $general
#   done
#
# with `$program deepen $state 24` whenever there were classes whose witness had not been made deeper (the last ten rounds:
# once, at their end), and the one of graph_all.json
# that of
#
#   cp $state $all && $program round $all all 1 1 $general $positive
set -eu
cd "$(dirname "$0")/.."
program="cargo run --release --example classes --"
state=data/survey/graph.json
all=data/survey/graph_all.json
general=data/survey/general.summary.json
positive=data/survey/positive.summary.json
if [ $# -gt 0 ]; then
    $program grow $state existing 1 1 "$1" $general
    $program deepen $state 24
    $program grow $all all 1 1 "$1" $general $positive
    $program special data/survey/special.json 1 60
fi
$program write $state $all data/survey/special.json $general $positive data/classes.json crates/documents/data/classes.json
$program report .
