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

# An environment for Python's programs, made once: `tool NAME…` installs, `$tools/bin` has them.
tools="$CARGO_TARGET_DIR/release-tools"
tool() {
    [ -d "$tools" ] || python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check "$@" || lacking "pip cannot install $*"
}
