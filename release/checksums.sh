#!/usr/bin/env bash
# SHA-256 of all files that are uploaded.
. "$(dirname "$0")/lib.sh"
cd "$OUT"
find . -type f ! -name SHA256SUMS -printf '%P\0' | sort -z | xargs -0 -r sha256sum > SHA256SUMS
wc -l < SHA256SUMS
