#!/usr/bin/env bash
# The crates of the workspace, in the order in which they are published (crates.txt), and that they stand on each other.
#
# With INSTALL=1 the program is installed from them as a stranger would, with `cargo install bifdiag` in an empty folder: minutes.
. "$(dirname "$0")/lib.sh"
crates_of_others
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

# crates.io as it will be: those of others, and ours beside them.
registry="$CARGO_TARGET_DIR/registry"
cargo vendor --quiet --locked --versioned-dirs "$registry" > /dev/null
for crate in "$OUT"/crates/*.crate; do
    tar -xzf "$crate" -C "$registry"
    printf '{"files":{},"package":"%s"}' "$(sha256sum "$crate" | cut -d ' ' -f 1)" \
        > "$registry/$(basename "$crate" .crate)/.cargo-checksum.json"
done
home="$(mktemp -d)"
trap 'rm -rf "$home"' EXIT
mkdir "$home/src"
cat > "$home/config.toml" << END
[source.crates-io]
replace-with = "folder"
[source.folder]
directory = "$registry"
END
# A stranger's package, which asks for the library only.
cat > "$home/Cargo.toml" << END
[package]
name = "stranger"
edition = "2024"
[dependencies]
bifdiag = "=$version"
END
touch "$home/src/lib.rs"
cd "$home"
cargo tree --quiet --offline --config config.toml --prefix none > tree
sed -n 's/^\(bifdiag[a-z-]*\) v.*/\1/p' tree | sort -u | diff - <(sort "$OUT/crates/crates.txt")
echo "a stranger's cargo finds all $(grep -c '' "$OUT/crates/crates.txt") crates"
[ "${INSTALL:-}" ] || exit 0
CARGO_TARGET_DIR="$home/target" cargo install --locked --offline --config config.toml --root "$home" bifdiag
"$home/bin/bifdiag" classify --body paper --h 3.8 --l 3.25
