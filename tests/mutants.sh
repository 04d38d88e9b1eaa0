#!/usr/bin/env bash
# Mutation tests: every mutant of the topology, or of the verifier, that no test notices is listed (`cargo install
# cargo-mutants`). A part such as 3/40 takes every fortieth mutant; further arguments go to cargo-mutants. Samples and
# their results: data/mutants.txt.
#
#   tests/mutants.sh topology            all of them, hours
#   tests/mutants.sh verify 3/40         a sample
#   tests/mutants.sh topology 0/1 --re Partition
set -euo pipefail
cd "$(dirname "$0")/.."
subject="${1:?topology or verify}"
shard="${2:-0/1}"
shift "$(($# < 2 ? $# : 2))"
case "$subject" in
topology) chosen=(--file 'crates/diagram/src/topology/**' --file 'crates/diagram/src/class/**' --test-package bifdiag-diagram) ;;
verify) chosen=(--file 'crates/verify/src/**' --test-package bifdiag --cargo-test-arg=--test=verify) ;;
*) echo "mutants.sh: $subject is neither topology nor verify" >&2; exit 2 ;;
esac

out="${CARGO_TARGET_DIR:-$PWD/target}/mutants/$subject"
mkdir -p "$out"
status=0
cargo mutants --workspace "${chosen[@]}" --shard "$shard" --sharding round-robin --no-shuffle --baseline skip \
    --timeout 600 --minimum-test-timeout 600 --jobs 1 --profile mutants --output "$out" "$@" || status=$?
# 2: some were missed, 3: some ran out of time; both are results.
case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac
cat "$out/mutants.out/missed.txt"
