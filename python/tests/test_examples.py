"""The notebooks and the examples for clusters run as they stand."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import bifdiag

EXAMPLES = Path(__file__).parents[1] / "examples"


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.ipynb")), ids=lambda path: path.stem)
@pytest.mark.filterwarnings("ignore")
def test_notebooks_run_and_show_pictures(path, tmp_path):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    notebook = nbformat.read(path, as_version=4)
    nbclient.NotebookClient(notebook, timeout=100, resources={"metadata": {"path": tmp_path}}).execute()
    shown = [
        output for cell in notebook.cells for output in cell.get("outputs", ()) if "image/png" in output.get("data", {})
    ]
    assert shown
    assert all(len(cell.source.splitlines()) < 25 for cell in notebook.cells)


def whole(directory, samples):
    bifdiag.scan(family="general", samples=samples, out=directory / "whole.parquet")
    return (directory / "whole.parquet").read_bytes()


def test_a_job_array_gives_the_bytes_of_one_run(tmp_path):
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    for task in (1, 2, 3):
        told = {"PATH": path, "SLURM_ARRAY_TASK_ID": str(task), "SLURM_ARRAY_TASK_COUNT": "3", "SAMPLES": "100"}
        subprocess.run(["bash", EXAMPLES / "array.sh"], cwd=tmp_path, env=os.environ | told, check=True)
    bifdiag.merge(tmp_path.glob("shard-*.parquet"), out=tmp_path / "general.parquet")
    assert (tmp_path / "general.parquet").read_bytes() == whole(tmp_path, 100)


def test_dask_gives_the_bytes_of_one_run(tmp_path):
    pytest.importorskip("distributed")
    subprocess.run([sys.executable, EXAMPLES / "scan_dask.py", tmp_path, "100", "3"], check=True, timeout=100)
    assert (tmp_path / "general.parquet").read_bytes() == whole(tmp_path, 100)
