# What the parts share; each sources this first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
: "${CARGO_TARGET_DIR:=$PWD/target}" "${OUT:=$CARGO_TARGET_DIR/upload}"
export CARGO_TARGET_DIR OUT
mkdir -p "$OUT"
version="$(sed -n '/^\[workspace.package\]/,/^$/s/^version = "\(.*\)"/\1/p' Cargo.toml)"

# A part that cannot be made here says why and ends.
lacking() {
    echo "not possible here: $*" >&2
    exit 3
}

need() {
    local program
    for program in "$@"; do command -v "$program" > /dev/null || lacking "$program is not installed"; done
}

# All that Cargo.lock names, also for other machines: what reads the whole tree needs it.
crates_of_others() {
    cargo fetch --quiet --locked || lacking "the crates of Cargo.lock cannot be fetched"
}

# The page is there, with the licences.
need_page() {
    [ -f web/dist/index.html ] && [ -f web/dist/THIRD-PARTY-LICENSES.txt ] || lacking "the page has not been built (release/build.sh bill page)"
}

# Puts the page where the Python package carries it.
page_for_python() {
    need_page
    python/page.sh
}

# An environment for Python's programs, made once and again if the folder has been moved: `tool NAME…` installs, `$tools/bin` has them.
tools="$CARGO_TARGET_DIR/release-tools"
tool() {
    "$tools/bin/pip" --version > /dev/null 2>&1 || python3 -m venv --clear "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check "$@" || lacking "pip cannot install $*"
}
