"""A scan on Dask: each future computes a shard into a file on the shared disk; the merged file has the bytes of one run.

python scan_dask.py DIRECTORY SAMPLES SHARDS
"""

import sys
from pathlib import Path

from distributed import Client, LocalCluster, as_completed

import bifdiag


def shard(directory: Path, samples: int, part: int, of: int) -> Path:
    """One part of the scan."""
    out = directory / f"shard-{part}.parquet"
    bifdiag.scan(family="general", samples=samples, shard=(part, of), out=out)
    return out


def main(directory: Path, samples: int, shards: int) -> None:
    """On a cluster of this machine; `Client("scheduler:8786")` takes another one."""
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        parts = range(1, shards + 1)
        futures = client.map(lambda part: shard(directory, samples, part, shards), parts, pure=False)
        files = []
        for future in as_completed(futures):
            files.append(future.result())
            print(f"{len(files)} of {shards} shards")
    bifdiag.merge(sorted(files), out=directory / "general.parquet")


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
