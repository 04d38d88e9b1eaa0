#!/usr/bin/env bash
# Counts the instructions of each hot path per call with valgrind and compares them with the recorded counts.
#
#   benches/instructions.sh           print counts beside benches/instructions.txt; exit 1 if one rose by more than 2 %
#   benches/instructions.sh --record  print counts and record them
#
# Counts do not depend on the load of the machine. A call's count is (a run of N calls − a run of none)/N, so that
# preparing the workload does not count. They differ between processors (the mathematics library chooses its code)
# and compilers; the record says where it was made.
# Needs valgrind and bash.
set -euo pipefail
cd "$(dirname "$0")/.."

record=benches/instructions.txt
cargo build --quiet --release --example hot_paths
program="${CARGO_TARGET_DIR:-target}/release/examples/hot_paths"

instructions() { # NAME COUNT
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$1" "$2" 2>&1 >/dev/null |
        sed -n 's/.*Collected : *\([0-9]*\).*/\1/p'
}

counts=$(mktemp)
trap 'rm -f "$counts"' EXIT
echo "# instructions per call; $(rustc --version), $(uname -m)" >"$counts"
status=0
for path in $("$program" list); do
    # Every body of the workload once (64 of them), polylines for a quarter of them.
    calls=64
    [ "$path" = polylines ] && calls=16
    count=$((($(instructions "$path" "$calls") - $(instructions "$path" 0)) / calls))
    echo "$path $count" >>"$counts"
    before=$(awk -v path="$path" '$1 == path { print $2 }' "$record" 2>/dev/null || true)
    if [ -n "$before" ]; then
        printf '%-20s %12d  recorded %12d  %+.2f %%\n' "$path" "$count" "$before" \
            "$(awk -v now="$count" -v before="$before" 'BEGIN { print 100 * (now - before) / before }')"
        [ $((count * 100)) -le $((before * 102)) ] || status=1
    else
        printf '%-20s %12d  not recorded\n' "$path" "$count"
    fi
done
if [ "${1:-}" = --record ]; then
    cp "$counts" "$record"
    status=0
fi
exit "$status"
