#!/usr/bin/env bash
# The packages under the command line pass their tests as WebAssembly too, under Node (`rustup target add wasm32-wasip1`).
# Little optimisation: the build is what takes long. The metamorphic suite is too slow there.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TARGET_WASM32_WASIP1_RUNNER="node --no-warnings $PWD/tests/wasi.mjs"
export CARGO_PROFILE_RELEASE_OPT_LEVEL=1 PROPTEST_CASES="${PROPTEST_CASES:-2}"

cargo test --release --target wasm32-wasip1 \
    -p bifdiag-numbers -p bifdiag-schema -p bifdiag-verify -p bifdiag-diagram \
    --lib --test intervals --test arrangement --test classify --test class
