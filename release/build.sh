#!/usr/bin/env bash
# Makes everything that is uploaded, as far as this machine can: `release/build.sh [PART…]`, all parts without one.
#
# Each part is a script beside this one. It ends with status 3 if the machine lacks what it needs, and says what; that is no failure
# of the release, as the workflows make those files on machines that have it. Files go to target/upload (OUT).
set -uo pipefail
cd "$(dirname "$0")/.."
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}"
export OUT="${OUT:-$CARGO_TARGET_DIR/upload}"
mkdir -p "$OUT"

# In the order in which one needs another: the page carries the licences, the wheel the page, the package the program.
all=(audit crates bill page program deb sdist wheel conda manuscript site checksums)
parts=("$@")
[ $# -gt 0 ] || parts=("${all[@]}")

failed=0
table=""
for part in "${parts[@]}"; do
    echo "== $part"
    begin=$SECONDS
    release/"$part".sh
    status=$?
    case $status in
        0) word="made" ;;
        3) word="not possible here" ;;
        *) word="FAILED" failed=1 ;;
    esac
    table+="$(printf '%6d s  %-11s %s' $((SECONDS - begin)) "$part" "$word")"$'\n'
done
printf '== %s\n%s' "$OUT" "$table"
exit $failed
