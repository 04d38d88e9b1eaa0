"""What the tests share."""

import subprocess
import sys

import pytest

import bifdiag


@pytest.fixture(scope="session")
def paper():
    return bifdiag.Body(A=[2, "11/10", 1], r=[0.94868, 0, 0.61623])


@pytest.fixture(scope="session")
def atlas(paper):
    return paper.atlas()


@pytest.fixture(scope="session")
def section(paper):
    return paper.section(3.8, 3.25, orbits=6, crossings=40)


@pytest.fixture(scope="session")
def command():
    """The command line of the package, in a process of its own: what it prints."""

    def run(*arguments, status=0, cwd=None):
        line = [sys.executable, "-m", "bifdiag", *map(str, arguments)]
        done = subprocess.run(line, capture_output=True, text=True, encoding="utf-8", cwd=cwd, check=False)
        assert done.returncode == status, done.stderr
        return done.stdout if status == 0 else done.stderr

    return run
