#!/usr/bin/env bash
# The program for Linux on x86-64, without any library of the system, with the explorer beside it.
. "$(dirname "$0")/lib.sh"
target=x86_64-unknown-linux-musl
need rustup strip
rustup target add "$target" || lacking "rustup has no $target"
need_page
cargo build --release --locked --features pdf --bin bifdiag --target "$target"
place="$(mktemp -d)"
trap 'rm -rf "$place"' EXIT
name="bifdiag-$version-$target"
mkdir "$place/$name"
cp "$CARGO_TARGET_DIR/$target/release/bifdiag" LICENSE-APACHE LICENSE-MIT README.md "$place/$name/"
strip "$place/$name/bifdiag"
cp -r web/dist "$place/$name/page"
mv "$place/$name/page/THIRD-PARTY-LICENSES.txt" "$place/$name/"
! ldd "$place/$name/bifdiag" 2> /dev/null | grep '=>' || { echo "the program is not static" >&2; exit 1; }
"$place/$name/bifdiag" classify --body paper --h 3.8 --l 3.25
tar -czf "$OUT/$name.tar.gz" -C "$place" "$name"
