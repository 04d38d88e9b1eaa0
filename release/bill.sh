#!/usr/bin/env bash
# What is bundled: a bill of materials (CycloneDX) and the texts of all licences, of the program and of the page.
. "$(dirname "$0")/lib.sh"
tree="$(mktemp)"
trap 'rm -f "$tree"' EXIT
for package in bifdiag bifdiag-python bifdiag-web bifdiag-web-parts; do
    features=()
    case $package in bifdiag | bifdiag-python) features=(--features pdf) ;; esac
    cargo tree --locked --offline --package "$package" "${features[@]}" --edges normal --prefix none --format '{p}'
done > "$tree"
cargo metadata --format-version 1 --locked --offline --all-features | python3 release/bill.py "$tree" "$OUT"
