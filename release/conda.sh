#!/usr/bin/env bash
# Conda packages of the wheels for Linux, by python/conda/recipe.yaml, and that the one for this machine answers.
. "$(dirname "$0")/lib.sh"
need zstd
shopt -s nullglob
wheels=("$OUT"/*.whl)
[ ${#wheels[@]} -gt 0 ] || lacking "no wheel has been made (release/build.sh wheel)"
tool py-rattler-build "numpy>=1.23"
"$tools/bin/python" release/conda.py "${wheels[@]}" "$OUT/conda"
package="$(echo "$OUT"/conda/linux-64/*.conda)"
place="$(mktemp -d)"
trap 'rm -rf "$place"' EXIT
python3 -m zipfile --extract "$package" "$place"
tar --zstd -xf "$place"/pkg-*.tar.zst -C "$place"
PYTHONPATH="$place/site-packages" "$tools/bin/python" -m bifdiag classify --body paper --h 3.8 --l 3.25
