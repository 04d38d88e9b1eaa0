#!/usr/bin/env bash
# The conda package, from python/conda/recipe.yaml.
. "$(dirname "$0")/lib.sh"
need rattler-build
rattler-build build --recipe python/conda/recipe.yaml --output-dir "$OUT/conda"
