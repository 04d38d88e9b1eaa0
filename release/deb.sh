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
mkdir -p "$to"/{DEBIAN,usr/bin,usr/share/{man/man1,doc/bifdiag}}
mkdir -p "$to"/usr/share/{bash-completion/completions,zsh/vendor-completions,fish/vendor_completions.d}
# `bifdiag explore` looks for the page beside the program: both lie in one folder, and a link leads to it.
mkdir -p "$to/usr/lib/bifdiag"
cp -r "$from/bifdiag" "$from/page" "$to/usr/lib/bifdiag/"
ln -s ../lib/bifdiag/bifdiag "$to/usr/bin/bifdiag"
"$from/bifdiag" man --out "$to/usr/share/man/man1" > /dev/null
gzip -9n "$to"/usr/share/man/man1/*
"$from/bifdiag" completions bash > "$to/usr/share/bash-completion/completions/bifdiag"
"$from/bifdiag" completions zsh > "$to/usr/share/zsh/vendor-completions/_bifdiag"
"$from/bifdiag" completions fish > "$to/usr/share/fish/vendor_completions.d/bifdiag.fish"
cat "$from"/{LICENSE-MIT,LICENSE-APACHE,THIRD-PARTY-LICENSES.txt} > "$to/usr/share/doc/bifdiag/copyright"
cat > "$to/DEBIAN/control" << END
Package: bifdiag
Version: $version
Architecture: amd64
Installed-Size: $(du -sk "$to/usr" | cut -f1)
Maintainer: The bifdiag developers <nobody@invalid>
Section: science
Priority: optional
Description: bifurcation diagrams and Poincaré sections of any heavy rigid body
 Finds every region of the (h, l) plane of a heavy rigid body with its
 topology, all steady rotations with their stability, and motions with proved
 bounds.
END
dpkg-deb --root-owner-group --build "$to" "$OUT/bifdiag_${version}_amd64.deb"
