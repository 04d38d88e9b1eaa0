#!/bin/sh
# Writes witnesses.json: for each entry of the paper's Table 1, for more boundary circles than it lists, and for each
# signature of several components, a body and a point that show it well, as `bifdiag find` gives them. What is not found
# is told on stderr and left out.
#
#   data/witnesses.sh S2+S2 S2+T2 T2+T2 M2+S2 M2+T2 S2+S2+T2 S2+T2+T2 > data/witnesses.json
#
# The signatures are those that the scans of docs/survey.md met. BIFDIAG names the program; jq is needed.
set -eu
program=${BIFDIAG:-bifdiag}
one() {
    answer=$("$program" find "$@" --samples 40000 --quiet --json)
    if [ "$(printf '%s' "$answer" | jq .found)" = true ]; then
        printf '%s' "$answer" | jq -c '{type, A, r, h, l, components, margin}'
    else
        echo "not found: $*" >&2
    fi
}
{
    for type in k1n0 k2n0 k3n0 k1n1 k2n1 k3n1 k0n2 k1n2 k2n2 k3n2; do
        one --type $type --physical
    done
    for type in k4n0 k4n1 k4n2; do
        one --type $type
    done
    for signature in "$@"; do
        # Of bodies that exist, if one is found.
        found=$(one --signature "$signature" --physical)
        if [ -n "$found" ]; then echo "$found"; else one --signature "$signature"; fi
    done
} | jq -s 'map(.)' | sed 's/^  {/{/'
