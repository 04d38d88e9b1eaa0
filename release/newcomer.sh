#!/usr/bin/env bash
# What a newcomer meets: a bare Debian without a compiler, in a folder; the static program, the Debian package and the wheel answer the
# first command of the README in it. Needs root and debootstrap; SUITE names another Debian.
. "$(dirname "$0")/lib.sh"
need debootstrap chroot
[ "$(id -u)" = 0 ] || lacking "root is needed for a chroot"
first=(bifdiag --A 2,1.1,1 --r 0.94868,0,0.61623)
bare="$CARGO_TARGET_DIR/newcomer"
[ -x "$bare/usr/bin/python3" ] || {
    rm -rf "$bare"
    debootstrap --variant=minbase --include=python3,python3-venv,ca-certificates "${SUITE:-bookworm}" "$bare" > /dev/null
}
! chroot "$bare" sh -c 'command -v cc || command -v rustc' || { echo "the bare system has a compiler" >&2; exit 1; }
rm -rf "$bare/try"
mkdir "$bare/try"
cp /etc/resolv.conf "$bare/etc/"
cp /etc/ssl/certs/ca-certificates.crt "$bare/etc/ssl/certs/"

# NAME, FILE, and how it is installed, in the folder of the file, so that `bifdiag` is found.
try() {
    local name="$1" file="$2" install="$3" begin
    [ -f "$file" ] || { printf '%-16s not made\n' "$name"; return; }
    cp "$file" "$bare/try/"
    begin=$(date +%s%N)
    chroot "$bare" sh -ec "cd /try && FILE='$(basename "$file")' && $install && ${first[*]}" > "$bare/try/$name.out"
    grep -q '^9 regions, 5 events' "$bare/try/$name.out"
    printf '%-16s %7d kB, answers %d ms after the download\n' "$name" $(($(stat -c %s "$file") / 1000)) \
        $((($(date +%s%N) - begin) / 1000000))
}
static="$OUT/bifdiag-$version-x86_64-unknown-linux-musl.tar.gz"
try "static program" "$static" 'tar -xzf "$FILE" && PATH="/try/${FILE%.tar.gz}:$PATH"'
try "Debian package" "$OUT/bifdiag_${version}_amd64.deb" 'dpkg -i "$FILE" > /dev/null 2>&1'
wheel="$(find "$OUT" -name "*x86_64.whl" | head -1)"
try "wheel" "${wheel:-none}" 'python3 -m venv wheel && wheel/bin/pip install -q "$FILE" && PATH="/try/wheel/bin:$PATH"'
