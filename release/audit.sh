#!/usr/bin/env bash
# Licences, sources and duplicate versions of everything that is bundled (deny.toml); known weaknesses where their list can be had.
. "$(dirname "$0")/lib.sh"
cargo deny --version > /dev/null 2>&1 || lacking "cargo-deny is not installed (cargo install cargo-deny)"
crates_of_others
cargo deny --offline check licenses bans sources
if cargo deny fetch db 2> /dev/null; then
    cargo deny check advisories
else
    echo "the list of known weaknesses cannot be fetched here: not checked" >&2
fi
