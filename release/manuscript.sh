#!/usr/bin/env bash
# The manuscript as PDF.
. "$(dirname "$0")/lib.sh"
need latexmk rsvg-convert make
cargo build --release
BIFDIAG="$CARGO_TARGET_DIR/release/bifdiag" make -C paper
cp paper/manuscript.pdf "$OUT/bifdiag-manuscript.pdf"
