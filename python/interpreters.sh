#!/usr/bin/env bash
# Runs the tests of a wheel with the newer interpreters of Debian's unstable distribution: interpreters.sh WHEEL [VERSION ...]
# They are unpacked into a folder of their own together with their C library, and touch nothing of the system. Needs apt and pip.
set -euo pipefail
wheel="$(realpath "$1")"
versions=("${@:2}")
[ ${#versions[@]} -gt 0 ] || versions=(3.13 3.14 3.15)
cd "$(dirname "$0")"
place="$(mktemp -d)"
trap 'rm -rf "$place"' EXIT

mkdir -p "$place"/{lists/partial,archives/partial,root}
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian sid main" > "$place/sources.list"
apt=(-qq -o "Dir::Etc::sourcelist=$place/sources.list" -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$place/lists"
    -o "Dir::Cache=$place" -o APT::Sandbox::User=root)
apt-get "${apt[@]}" update
packages=(libc6 libssl3t64 libffi8 libsqlite3-0 libexpat1 zlib1g libbz2-1.0 liblzma5 libzstd1 libuuid1 libgcc-s1 libstdc++6 libcrypt1)
for version in "${versions[@]}"; do
    packages+=("python$version-minimal" "libpython$version-stdlib" "libpython$version-minimal")
done
(cd "$place/archives" && apt-get "${apt[@]}" download "${packages[@]}")
for package in "$place"/archives/*.deb; do dpkg -x "$package" "$place/root"; done

libraries="$place/root/usr/lib/x86_64-linux-gnu"
failed=0
for version in "${versions[@]}"; do
    site="$place/site-$version"
    abi="cp${version/./}"
    # The pip at hand asks the registry for another interpreter; what a package says of the pip's own interpreter does not count.
    python3 -m pip install --quiet --disable-pip-version-check --ignore-requires-python --no-deps --only-binary=:all: \
        --target "$site" --python-version "$version" --implementation cp --abi "$abi" --abi abi3 --abi abi3t --abi none \
        --platform manylinux_2_28_x86_64 --platform manylinux_2_27_x86_64 --platform manylinux_2_17_x86_64 \
        --platform manylinux2014_x86_64 numpy pytest pytest-timeout pluggy iniconfig packaging pygments hypothesis sortedcontainers
    python3 -m zipfile -e "$wheel" "$site"
    # A program that starts itself again, as the tests of the command do.
    program="$place/python$version"
    cat > "$program" << END
#!/bin/sh
export PYTHONHOME="$place/root/usr" PYTHONPATH="$site"
exec "$libraries/ld-linux-x86-64.so.2" --library-path "$libraries" "$place/root/usr/bin/python$version" "\$@"
END
    chmod +x "$program"
    echo "== python $version"
    "$program" -c "
import sys
sys.executable = '$program'
import numpy, pytest
print(sys.version, 'numpy', numpy.__version__)
tests = ['atlas', 'body', 'critical', 'explorer', 'limits', 'part', 'section']
sys.exit(pytest.main(['-p', 'no:cacheprovider', *(f'tests/test_{name}.py' for name in tests)]))" || failed=1
done
exit "$failed"
