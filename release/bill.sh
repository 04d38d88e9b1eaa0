#!/usr/bin/env bash
# What is bundled: a bill of materials (CycloneDX) and the texts of all licences, of the program and of the page.
. "$(dirname "$0")/lib.sh"
need npm
crates_of_others
[ -d web/node_modules ] || (cd web && npm ci)
tree="$(mktemp)"
trap 'rm -f "$tree"' EXIT
linked() {
    cargo tree --locked --offline --package "$1" --target "$2" "${@:3}" --edges normal --prefix none --format '{p}'
}
# Wheels and programs are made for these; the page for the last one.
for package in bifdiag bifdiag-python; do
    for machine in {x86_64,aarch64}-{unknown-linux-gnu,unknown-linux-musl,apple-darwin} x86_64-pc-windows-msvc; do
        linked "$package" "$machine" --features pdf
    done
done > "$tree"
for package in bifdiag-web bifdiag-web-parts bifdiag-web-straight bifdiag-web-chaos; do linked "$package" wasm32-unknown-unknown; done >> "$tree"
cargo metadata --format-version 1 --locked --offline --all-features | python3 release/bill.py "$tree" "$OUT"
