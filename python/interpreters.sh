#!/usr/bin/env bash
# Runs the tests of a wheel with other interpreters: interpreters.sh WHEEL [INTERPRETER ...]
# An interpreter is a program, such as python3.10 or a path, which gets an environment of its own; or a version, such as 3.14,
# which is unpacked from Debian's unstable distribution into a folder of its own together with its C library, and touches
# nothing of the system (this needs apt and pip). By default every version from 3.10 on that runs here beside
# python3 itself, pyenv's among them.
set -euo pipefail
wheel="$(realpath "$1")"
wanted=("${@:2}")
if [ ${#wanted[@]} -eq 0 ]; then
    version_of() { "$1" -c 'import sys; print(sys.version)' 2> /dev/null; }
    declare -A found=(["$(version_of python3)"]=yes)
    for name in $(compgen -c python3. | sort -u) "${PYENV_ROOT:-$HOME/.pyenv}"/versions/*/bin/python3.*; do
        [[ "$name" =~ python3\.[1-9][0-9]$ ]] || continue
        version="$(version_of "$name")" || continue
        [ -n "${found[$version]-}" ] || wanted+=("$name")
        found[$version]=yes
    done
fi
cd "$(dirname "$0")"
place="$(mktemp -d)"
trap 'rm -rf "$place"' EXIT
failed=()

needs=(numpy pytest pytest-timeout hypothesis)
tests="
import sys
if len(sys.argv) > 1: sys.executable = sys.argv[1]
import numpy, pytest
print(sys.version, 'numpy', numpy.__version__)
tests = ['atlas', 'body', 'critical', 'explorer', 'limits', 'part', 'section']
sys.exit(pytest.main(['-p', 'no:cacheprovider', *(f'tests/test_{name}.py' for name in tests)]))"

of_this_machine() {
    local environment python
    environment="$(mktemp -d "$place/environment-XXXX")"
    "$1" -m venv "$environment"
    python="$environment/bin/python"
    "$python" -m pip install --quiet --disable-pip-version-check --only-binary=:all: "${needs[@]}" "$wheel"
    "$python" -c "$tests"
}

fetch_from_debian() {
    mkdir -p "$place"/{lists/partial,archives/partial,root}
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian sid main" > "$place/sources.list"
    local apt=(-qq -o "Dir::Etc::sourcelist=$place/sources.list" -o Dir::Etc::sourceparts=/dev/null
        -o "Dir::State::lists=$place/lists" -o "Dir::Cache=$place" -o APT::Sandbox::User=root)
    apt-get "${apt[@]}" update
    local packages=(libc6 libssl3t64 libffi8 libsqlite3-0 libexpat1 zlib1g libbz2-1.0 liblzma5 libzstd1 libuuid1 libgcc-s1
        libstdc++6 libcrypt1)
    for version in "$@"; do
        packages+=("python$version-minimal" "libpython$version-stdlib" "libpython$version-minimal")
    done
    (cd "$place/archives" && apt-get "${apt[@]}" download "${packages[@]}")
    for package in "$place"/archives/*.deb; do dpkg -x "$package" "$place/root"; done
}

of_debian() {
    local version="$1" site="$place/site-$1" abi="cp${1/./}" machine interpreter libraries loader program
    machine="$(uname -m)"
    interpreter="$(find "$place/root" -name "python$version" -type f -perm -u+x)"
    libraries="$(dirname "$(find "$place/root" -name libc.so.6)")"
    loader=("$libraries"/ld-linux*.so.*)
    # The pip at hand asks the registry for another interpreter; what a package says of the pip's own interpreter does not count.
    python3 -m pip install --quiet --disable-pip-version-check --ignore-requires-python --no-deps --only-binary=:all: \
        --target "$site" --python-version "$version" --implementation cp --abi "$abi" --abi abi3 --abi abi3t --abi none \
        --platform "manylinux_2_28_$machine" --platform "manylinux_2_27_$machine" --platform "manylinux_2_17_$machine" \
        --platform "manylinux2014_$machine" "${needs[@]}" pluggy iniconfig packaging pygments sortedcontainers
    python3 -m zipfile -e "$wheel" "$site"
    # A program that starts itself again, as the tests of the command do.
    program="$place/python$version"
    cat > "$program" << END
#!/bin/sh
export PYTHONHOME="$(dirname "$(dirname "$interpreter")")" PYTHONPATH="$site"
exec "${loader[0]}" --library-path "$libraries" "$interpreter" "\$@"
END
    chmod +x "$program"
    "$program" -c "$tests" "$program"
}

versions=()
for interpreter in "${wanted[@]}"; do
    case "$interpreter" in
        3.*) versions+=("$interpreter") ;;
        *)
            echo "== $interpreter"
            of_this_machine "$interpreter" || failed+=("$interpreter")
            ;;
    esac
done
[ ${#versions[@]} -eq 0 ] || fetch_from_debian "${versions[@]}"
for version in "${versions[@]}"; do
    echo "== Debian's $version"
    of_debian "$version" || failed+=("$version")
done
[ ${#failed[@]} -eq 0 ] || { echo "failed: ${failed[*]}"; exit 1; }
