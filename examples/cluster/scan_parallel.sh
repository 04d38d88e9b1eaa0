#!/bin/sh
# Runs the shards of a scan with GNU parallel and joins them.
#
#   ./scan_parallel.sh 16 general.parquet --family general --samples 100000
#
# BIFDIAG names the program (default: bifdiag in PATH). Options of GNU parallel, such as the hosts of --sshlogin, come
# from PARALLEL. What was stopped goes on where it was when the same line is given again.
set -eu
program=${BIFDIAG:-bifdiag}
shards=$1
out=$2
shift 2
stem=${out%.*}
ending=${out##*.}
seq "$shards" | parallel --will-cite --halt soon,fail=1 \
    "$program" scan "$@" --shard "{}/$shards" --out "$stem.shard-{}-of-$shards.$ending" --threads 1 --quiet '>' /dev/null
"$program" scan merge "$stem".shard-*-of-"$shards.$ending" --out "$out"
rm -- "$stem".shard-*-of-"$shards.$ending" "$stem".shard-*-of-"$shards.$ending".summary.json
