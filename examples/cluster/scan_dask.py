#!/usr/bin/env python3
"""Runs the shards of a scan on a Dask cluster and joins them.

    python3 scan_dask.py --shards 16 --out general.parquet -- --family general --samples 100000

Without --scheduler a cluster is started on this machine (pip install "distributed"); with the address of a running
scheduler the shards run there, on workers that share the folder of --out. A worker that dies costs nothing: its shard
is given to another one, which goes on where the first one stopped.
"""

import argparse
import os
import subprocess
import sys


def shard_name(out, number, count):
    stem, ending = os.path.splitext(out)
    return f"{stem}.shard-{number}-of-{count}{ending}"


def run_shard(program, scan, out, number, count):
    """One shard; returns its file. Called on a worker."""
    name = shard_name(out, number, count)
    command = [program, "scan", *scan, "--shard", f"{number}/{count}", "--out", name, "--threads", "1", "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {done.stderr.strip()}")
    return name


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bifdiag", default="bifdiag", help="the program (default: found in PATH)")
    parser.add_argument("--scheduler", help="address of a running scheduler, such as tcp://10.0.0.1:8786")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="workers of the local cluster")
    parser.add_argument("--shards", type=int, default=16)
    parser.add_argument("--out", required=True, help="the joined file (.parquet, .csv, .jsonl)")
    parser.add_argument("scan", nargs="+", help="options of `bifdiag scan`, after --")
    options = parser.parse_args()

    from dask.distributed import Client, LocalCluster, as_completed

    out = os.path.abspath(options.out)
    cluster = None
    if options.scheduler is None:
        cluster = LocalCluster(n_workers=options.workers, threads_per_worker=1, dashboard_address=None)
    with Client(cluster or options.scheduler) as client:
        tasks = [
            client.submit(run_shard, options.bifdiag, options.scan, out, number, options.shards, pure=False, retries=2)
            for number in range(1, options.shards + 1)
        ]
        for finished, task in enumerate(as_completed(tasks), start=1):
            task.result()
            print(f"{finished} of {options.shards} shards", file=sys.stderr)
        shards = client.gather(tasks)
    if cluster is not None:
        cluster.close()

    subprocess.run([options.bifdiag, "scan", "merge", *shards, "--out", out], check=True)
    for shard in shards:
        os.remove(shard)
        os.remove(shard + ".summary.json")


if __name__ == "__main__":
    main()
