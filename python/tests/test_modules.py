"""The package's modules: each of a size that can be read, and each importing only what stands before it."""

import ast
import re
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import bifdiag

FOLDER = Path(bifdiag.__file__).parent
MODULES = {
    path.relative_to(FOLDER.parent).with_suffix(""): ast.parse(path.read_text("utf-8")) for path in FOLDER.rglob("*.py")
}
# Written by a program from the schemas.
WRITTEN = "records"


def _running(tree):
    """What a module runs, its functions too, but not what only type checkers read."""
    for node in ast.iter_child_nodes(tree):
        if not (isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"):
            yield node
            yield from _running(node)


def _imported(path, tree):
    """The modules of the package that a module imports."""
    for node in _running(tree):
        if isinstance(node, ast.ImportFrom) and node.level:
            parent = Path(*path.parts[: len(path.parts) - node.level], *(node.module or "").split("."))
            inside = {parent / name.name for name in node.names} | {parent / name.name / "__init__" for name in node.names}
            itself = {parent, parent / "__init__"} if node.module else set()
            yield from inside & set(MODULES) or itself & set(MODULES)


def test_imports_have_no_circle():
    graph = {path: set(_imported(path, tree)) for path, tree in MODULES.items()}
    order = [str(path.relative_to("bifdiag")) for path in TopologicalSorter(graph).static_order()]
    assert order.index("given") < order.index("atlas") < order.index("body") < order.index("__init__")


@pytest.mark.parametrize("path", [path for path in MODULES if path.name != WRITTEN], ids=str)
def test_a_module_is_short(path):
    assert len((FOLDER.parent / path).with_suffix(".py").read_text("utf-8").splitlines()) <= 300


def test_the_texts_say_how_long_a_source_build_takes():
    texts = [(Path(__file__).parents[1] / name).read_text("utf-8") for name in ("README.md", "docs/guide.rst")]
    told = [
        re.search(r"pip install ./python`.{,200}?(\w+)\s+minutes of CPU time.{,60}`-v`", text, re.DOTALL) for text in texts
    ]
    assert told[0][1] == told[1][1]
