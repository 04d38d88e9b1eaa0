#!/bin/bash
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
# One shard for each task: sbatch array.sh; then: bifdiag scan merge shard-*.parquet --out general.parquet
set -euo pipefail
python - <<PYTHON
import bifdiag

shard = ($SLURM_ARRAY_TASK_ID, $SLURM_ARRAY_TASK_COUNT)
bifdiag.scan(family="general", samples=${SAMPLES:-1000000}, shard=shard, out=f"shard-{shard[0]}.parquet")
PYTHON
