#!/usr/bin/env bash
# The wheel of this platform; on Linux also those for aarch64, linked by zig.
. "$(dirname "$0")/lib.sh"
page_for_python
tool "maturin>=1.16,<2" twine abi3audit ziglang cargo-zigbuild
options=(--release --compression-level 9 --manifest-path python/Cargo.toml --out "$OUT")
PATH="$tools/bin:$PATH" maturin build "${options[@]}" --zig --compatibility manylinux_2_17
if rustup target add aarch64-unknown-linux-gnu; then
    PATH="$tools/bin:$PATH" maturin build "${options[@]}" --zig --target aarch64-unknown-linux-gnu
fi
"$tools/bin/twine" check --strict "$OUT"/*.whl
"$tools/bin/abi3audit" --strict --summary "$OUT"/*.whl
