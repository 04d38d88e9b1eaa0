#!/usr/bin/env bash
# The source distribution for Python, which carries the workspace and the explorer.
. "$(dirname "$0")/lib.sh"
page_for_python
tool "maturin>=1.16,<2" twine
"$tools/bin/maturin" sdist --manifest-path python/Cargo.toml --out "$OUT"
"$tools/bin/twine" check --strict "$OUT/bifdiag-$version.tar.gz"
