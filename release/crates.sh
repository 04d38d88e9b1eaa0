#!/usr/bin/env bash
# The crates of the workspace, in the order in which they are published (crates.txt), and that they stand on each other.
#
# With INSTALL=1 the program is installed from them as a stranger would, from a registry in a folder: minutes.
. "$(dirname "$0")/lib.sh"
rm -rf "$CARGO_TARGET_DIR/package" "$OUT/crates"
mkdir -p "$OUT/crates"
cargo package --quiet --workspace --no-verify --allow-dirty \
    --exclude support --exclude bifdiag-python --exclude bifdiag-web --exclude bifdiag-web-glue --exclude bifdiag-web-parts --exclude bifdiag-web-straight --exclude bifdiag-web-chaos
cp "$CARGO_TARGET_DIR"/package/*.crate "$OUT/crates/"
cargo metadata --format-version 1 --no-deps --offline | python3 release/order.py > "$OUT/crates/crates.txt"
diff <(sort "$OUT/crates/crates.txt") <(cd "$OUT/crates" && ls ./*.crate | sed 's#^\./##; s#-[0-9][0-9.]*\.crate$##' | sort)
for crate in "$OUT"/crates/*.crate; do
    [ "$(tar -tzf "$crate" | grep -c '/LICENSE-\(MIT\|APACHE\)$')" = 2 ] || { echo "$crate lacks the licences" >&2; exit 1; }
done
python3 release/registry.py "$OUT/crates" "$CARGO_TARGET_DIR/registry"
home="$(mktemp -d)"
trap 'rm -rf "$home"' EXIT
cat > "$home/config.toml" << END
[registries.local]
index = "file://$CARGO_TARGET_DIR/registry/index"
END
# A stranger's package, which finds the library and all below it in the registry only.
mkdir "$home/src"
touch "$home/src/lib.rs"
cat > "$home/Cargo.toml" << END
[package]
name = "stranger"
edition = "2024"
[dependencies]
bifdiag = { version = "=$version", registry = "local" }
END
cp Cargo.lock "$home/"
cargo tree --quiet --config "$home/config.toml" --manifest-path "$home/Cargo.toml" --prefix none > "$home/tree"
sed -n 's/^\(bifdiag[a-z-]*\) .*registry `local`.*/\1/p' "$home/tree" | sort -u | diff - <(sort "$OUT/crates/crates.txt")
echo "a stranger's cargo finds all $(grep -c '' "$OUT/crates/crates.txt") crates"
[ "${INSTALL:-}" ] || exit 0
CARGO_TARGET_DIR="$home/target" cargo install --locked --config "$home/config.toml" --registry local --root "$home" bifdiag
"$home/bin/bifdiag" classify --body paper --h 3.8 --l 3.25
