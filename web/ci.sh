#!/usr/bin/env bash
# Builds the explorer and tests it: units, the module against the command line, the page in Debian's Chromium.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/../target}"

rustup target add wasm32-unknown-unknown
if ! command -v "${CHROMIUM:-chromium}" >/dev/null; then
    apt-get update -qq
    apt-get install -y -qq chromium >/dev/null
fi
npm ci
(cd .. && cargo build --release)
npm run build
npm run site
npm test
