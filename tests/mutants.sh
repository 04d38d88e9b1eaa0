#!/usr/bin/env bash
# Mutation tests: every mutant of the topology and of the verifier that no test notices is listed. One argument takes a
# part, such as 1/8; others go to cargo-mutants (`cargo install cargo-mutants`).
#
#   tests/mutants.sh                     all of them, hours
#   tests/mutants.sh 3/40                a sample
#   tests/mutants.sh 0/1 --file crates/top/src/topology/component.rs
set -euo pipefail
cd "$(dirname "$0")/.."
shard="${1:-0/1}"
shift || true
files=(--file 'crates/top/src/topology/**' --file 'crates/top/src/class/**' --file 'crates/verify/src/**')
case " $* " in *" --file "*) files=() ;; esac

out="${CARGO_TARGET_DIR:-$PWD/target}/mutants"
mkdir -p "$out"
status=0
cargo mutants "${files[@]}" --shard "$shard" --baseline skip --timeout 120 --minimum-test-timeout 120 --jobs 1 \
    --no-shuffle --profile mutants --output "$out" "$@" || status=$?
# 2: some were missed, 3: some ran out of time; both are results.
case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac
cat "$out/mutants.out/missed.txt"
