#!/usr/bin/env bash
# A Debian package of the static program, with manual pages and completions.
. "$(dirname "$0")/lib.sh"
need dpkg-deb
program="bifdiag-$version-x86_64-unknown-linux-musl"
[ -f "$OUT/$program.tar.gz" ] || lacking "the static program has not been made (release/build.sh program)"
place="$(mktemp -d)"
trap 'rm -rf "$place"' EXIT
tar -xzf "$OUT/$program.tar.gz" -C "$place"
from="$place/$program" to="$place/package"
mkdir -p "$to"/{DEBIAN,usr/bin,usr/share/{man/man1,bash-completion/completions,doc/bifdiag}}
# `bifdiag explore` looks for the page beside the program: both lie in one folder, and a link leads to it.
mkdir -p "$to/usr/lib/bifdiag"
cp -r "$from/bifdiag" "$from/page" "$to/usr/lib/bifdiag/"
ln -s ../lib/bifdiag/bifdiag "$to/usr/bin/bifdiag"
"$from/bifdiag" man --out "$to/usr/share/man/man1"
gzip -9n "$to"/usr/share/man/man1/*
"$from/bifdiag" completions bash > "$to/usr/share/bash-completion/completions/bifdiag"
cat LICENSE-MIT LICENSE-APACHE > "$to/usr/share/doc/bifdiag/copyright"
cat > "$to/DEBIAN/control" << END
Package: bifdiag
Version: $version
Architecture: amd64
Maintainer: The bifdiag developers <nobody@invalid>
Section: science
Priority: optional
Description: bifurcation diagrams and Poincaré sections of any heavy rigid body
 Finds every region of the (h, l) plane of a heavy rigid body with its topology, all steady rotations with their
 stability, and motions with proved bounds.
END
dpkg-deb --root-owner-group --build "$to" "$OUT/bifdiag_${version}_amd64.deb"
