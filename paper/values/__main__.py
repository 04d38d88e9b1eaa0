"""Holds every number of joss.md and of the manuscript equal to what is recorded in data/ and what the program answers.

    python3 paper/values          exit status 1 if a number differs
    python3 paper/values --write  write those of the manuscript anew, to paper/generated

The program is target/release/bifdiag, or the one that BIFDIAG names.
"""
import sys
from pathlib import Path

PAPER = Path(__file__).resolve().parent.parent
GENERATED = PAPER / "generated"


def generated():
    """The files of the manuscript that hold its numbers: name and text."""
    from macros import macros
    from tables import TABLES

    yield "numbers.tex", "".join(f"\\newcommand{{\\{name}}}{{{value}}}\n" for name, value in macros())
    for name, make in TABLES.items():
        yield f"{name}.tex", make()


def missing():
    """What joss.md words otherwise."""
    from summary import facts

    text = " ".join((PAPER / "joss.md").read_text(encoding="utf-8").split())
    return [f"not in joss.md: {fact}" for fact in facts() if fact not in text]


def main():
    faults = missing()
    for name, text in generated():
        path = GENERATED / name
        if "--write" in sys.argv[1:]:
            GENERATED.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            faults.append(f"generated/{name} is not what the program and data/ give: python3 paper/values --write")
    print("\n".join(faults), end="\n" if faults else "")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
