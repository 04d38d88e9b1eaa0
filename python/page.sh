#!/usr/bin/env bash
# Puts the built page where the package carries it: each file that is packed in place of the plain one.
set -euo pipefail
cd "$(dirname "$0")"
rm -rf package/bifdiag/page
cp -r ../web/dist package/bifdiag/page
rm package/bifdiag/page/index.html.br
find package/bifdiag/page -name '*.br' | while read -r packed; do rm "${packed%.br}"; done
