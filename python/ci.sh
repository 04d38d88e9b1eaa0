#!/usr/bin/env bash
# Builds the wheel, installs it into a clean environment and runs its tests against the command line's answers.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/../target}"

(cd .. && cargo build --release)
environment="$CARGO_TARGET_DIR/python"
rm -rf "$environment"
python3 -m venv "$environment"
"$environment/bin/pip" install --quiet --disable-pip-version-check "maturin>=1.16,<2" pytest
"$environment/bin/maturin" build --quiet --release --out "$environment/wheels"
"$environment/bin/pip" install --quiet --disable-pip-version-check --no-index "$environment"/wheels/*.whl
"$environment/bin/pytest" -q tests
