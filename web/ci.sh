#!/usr/bin/env bash
# Builds the module and its glue, and compares its answers with the command line's under Node.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/../target}"

(cd .. && cargo build --release)
cargo build --profile wasm -p bifdiag-web --target wasm32-unknown-unknown
cargo run --quiet -p bifdiag-web-glue -- \
    "$CARGO_TARGET_DIR/wasm32-unknown-unknown/wasm/bifdiag_web.wasm" nodejs "$CARGO_TARGET_DIR/web"
node --test test/*.test.mjs
