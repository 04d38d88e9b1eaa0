#!/usr/bin/env bash
# The explorer, as an archive of static files.
. "$(dirname "$0")/lib.sh"
need npm rustup
rustup target add wasm32-unknown-unknown
(cd web && npm ci && npm run build)
tar -czf "$OUT/bifdiag-explorer-$version.tar.gz" -C web/dist .
