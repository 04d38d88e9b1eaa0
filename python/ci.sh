#!/usr/bin/env bash
# Builds the wheel, installs it into a clean environment, and runs everything that is said about it.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/../target}"
environment="$CARGO_TARGET_DIR/python"
bin="$environment/bin"

step() {
    local name="$1" begin=$SECONDS
    shift
    echo "== python: $name"
    "$@"
    echo "== python: $name: $((SECONDS - begin)) s"
}

install() {
    rm -rf "$environment"
    python3 -m venv "$environment"
    "$bin/pip" install --quiet --disable-pip-version-check -r requirements-ci.txt
}

# The explorer, which the wheel carries.
page() {
    rustup target add wasm32-unknown-unknown
    (cd ../web && npm ci && npm run build)
    ./page.sh
}

wheel() {
    "$bin/maturin" build --quiet --release --compression-level 9 --out "$environment/wheels"
    local size
    size=$(stat -c %s "$environment"/wheels/*.whl)
    echo "the wheel has $size bytes"
    # 12 MB, half a megabyte for chaos and periodic orbits, 0.6 for the page's modules of
    # the straightened plane and of chaos, 0.1 for manifolds of equilibria and periodic orbits compiled for speed, and 0.1 for
    # the page's texts in German and French. The page packed takes 0.35 less; what unpacks it takes 0.1, verify compiled for
    # speed 0.25, bodies and proofs of orbits compiled for speed 0.13, and a checker of normal forms in three precisions that
    # takes half the time 0.05, parts that are judged by their tensors 0.06.
    [ "$size" -le 13560000 ]
    "$bin/pip" install --quiet --disable-pip-version-check --no-index --no-deps "$environment"/wheels/*.whl
    "$bin/twine" check --strict "$environment"/wheels/*.whl
    "$bin/abi3audit" --strict --summary "$environment"/wheels/*.whl
}

# The source distribution carries the workspace: cargo finds every package that it needs, and every target that a manifest
# names without a path. (`cargo metadata` does not look for the latter.)
source_distribution() {
    "$bin/maturin" sdist --out "$environment/sdist"
    tar -xzf "$environment"/sdist/*.tar.gz -C "$environment/sdist"
    (cd "$environment"/sdist/*/ && cargo fetch --quiet --offline --target "$(rustc -vV | sed -n 's/host: //p')")
}

types() {
    "$bin/mypy"
    "$bin/stubtest" bifdiag._core --ignore-disjoint-bases
    "$bin/basedpyright" --pythonpath "$bin/python" --level error
}

style() {
    "$bin/ruff" format --check package tests examples docs measure.py
    "$bin/ruff" check package tests examples docs measure.py
}

# The oldest numpy that there is a wheel of for this interpreter.
oldest_numpy() {
    "$bin/pip" install --quiet --disable-pip-version-check --target "$environment/oldest" --no-deps "numpy==1.23.5"
    PYTHONPATH="$environment/oldest" "$bin/pytest" tests/test_atlas.py tests/test_body.py
}

# One wheel serves all interpreters: those that this machine has.
interpreters() {
    ./interpreters.sh "$environment"/wheels/*.whl
}

step "environment" install
step "style" style
step "page" page
step "wheel" wheel
step "source distribution" source_distribution
step "types" types
step "tests" "$bin/pytest"
step "doctests" "$bin/pytest" --doctest-modules --doctest-glob='*.rst' --pyargs bifdiag docs
step "oldest numpy" oldest_numpy
step "other interpreters" interpreters
step "reference" "$bin/sphinx-build" --quiet --fail-on-warning --builder html docs "$environment/docs"
