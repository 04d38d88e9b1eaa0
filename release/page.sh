#!/usr/bin/env bash
# The explorer, as an archive of static files, with the licences of all that it and whatever carries it bundle.
. "$(dirname "$0")/lib.sh"
need npm rustup
[ -f "$OUT/THIRD-PARTY-LICENSES.txt" ] || lacking "the licences have not been collected (release/build.sh bill)"
rustup target add wasm32-unknown-unknown
(cd web && npm ci && npm run build)
cp "$OUT/THIRD-PARTY-LICENSES.txt" web/dist/
tar -czf "$OUT/bifdiag-explorer-$version.tar.gz" -C web/dist .
