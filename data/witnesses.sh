#!/bin/sh
# Writes witnesses.json: for each entry of the paper's Table 1 that occurs, for four boundary circles, and for each
# signature of several components, a body and a point that show it well, as `bifdiag find --search` gives them (without
# that option it would answer from the file that this script writes). What is not found is reported on stderr and left out.
# Three boundary circles without a pole, and four, are not sought: docs/mathematics.md.
#
#   data/witnesses.sh S2+S2 S2+T2 T2+T2 S2+M2 T2+M2 S2+S2+T2 S2+T2+T2 > data/witnesses.json
#
# The signatures are those that the scans of docs/survey.md met. Bodies that exist and show four boundary circles are too
# rare for a search by chance (r1 must be tiny, and the room in h is about 1e-4 |r| at best): the two here come from the
# analysis behind the theorem on components (docs/mathematics.md), and this script confirms them.
# BIFDIAG names the program; jq is needed.
set -eu
program=${BIFDIAG:-bifdiag}
one() {
    answer=$("$program" find "$@" --search --samples 40000 --quiet --json)
    if [ "$(printf '%s' "$answer" | jq .found)" = true ]; then
        printf '%s' "$answer" | jq -c '{type, A, r, h, l, components, margin}'
    else
        echo "not found: $*" >&2
    fi
}
# A known body and point: TYPE CIRCLES POLES A r h l. It must exist.
given() {
    type=$1 circles=$2 poles=$3
    point="--A $4 --r $5 --h $6 --l $7 --json"
    # shellcheck disable=SC2086
    "$program" classify $point | jq -ce --arg type "$type" \
        --argjson circles "$circles" --argjson poles "$poles" '
        def moments: .A | map(tonumber) | sort;
        if .status == "regular" and any(.components[]; .boundary_circles == $circles and (.poles | length) == $poles)
            and (moments | .[0] + .[1] > .[2]) and .margin.h > 1e6 * .margin.error_bound
        then {type: $type, A, r, h, l, components, margin}
        else error("\($type): not confirmed") end'
}
witnesses=$(
    for type in k1n0 k2n0 k1n1 k2n1 k3n1 k0n2 k1n2 k2n2 k3n2; do
        one --type $type --physical
    done
    given k4n1 4 1 1,1.05,2.02 0.0001,0.0665,1 1.79332 1.7862
    given k4n2 4 2 1,1.08,2.06 0.0002,0.101,1 1.79921 1.7902
    # With more room, of moments that no body has.
    for type in k4n1 k4n2; do
        one --type $type
    done
    for signature in "$@"; do
        # Of bodies that exist, if one is found.
        found=$(one --signature "$signature" --physical)
        if [ -n "$found" ]; then echo "$found"; else one --signature "$signature"; fi
    done
)
# One witness a line.
echo '['
printf '%s\n' "$witnesses" | sed '$!s/$/,/'
echo ']'
