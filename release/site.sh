#!/usr/bin/env bash
# The site, as an archive of static files.
. "$(dirname "$0")/lib.sh"
need npm
[ -f web/dist/index.html ] || lacking "the page has not been built (release/build.sh page)"
(cd web && npm run site)
tar -czf "$OUT/bifdiag-site-$version.tar.gz" -C web/dist-site .
