"""Do two bifdiag programs give the same answers?

    python3 tests/compare/versions.py OLD NEW [--bodies N] [--seed K] [--jobs J] [--figures]

Both are asked the same questions about bodies and points of all strata (README.md); what may differ stands in the table
below and nowhere else. Prints a summary by stratum and the first differences, each with a command that shows it. Exit
status 1 if anything differs. The standard library suffices.
"""

import argparse
import collections
import dataclasses
import glob
import multiprocessing
import os
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import dialects  # noqa: E402
import documents  # noqa: E402
import tasks  # noqa: E402

# What may differ. Paths are those of JSON documents, `[]` for the entries of a list; the end of a path suffices:
# "regions[].h_width" is that field in whatever document.
ALLOWED = documents.Allowed(
    ignored={
        "schema_version": "of the format, not of the answer",
        "version": "of the program",
        "command": "told by the program since schema 2",
        "program": "name and version of the program",
    },
    tolerances={
        "regions[].h_width": (1e-9, "the root of the difference of two slopes, no longer a search"),
    },
    words=[
        (r"bifdiag \d+\.\d+\.\d+\S*", "bifdiag", "name and version of the program"),
    ],
    additions=True,
)

# Of two versions of the documents.
ALLOWED_OF_TWO = dataclasses.replace(ALLOWED, common=dialects.common)

TIME_LIMIT = 60  # seconds for one command
TOLD = 3  # differences that are told of one case


def run(program, command, stdin, folder):
    """(exit status, stdout, stderr) in `folder`; the status is None when the time was up."""
    try:
        done = subprocess.run([program, *command], input=stdin, capture_output=True, cwd=folder, timeout=TIME_LIMIT, check=False)
    except subprocess.TimeoutExpired:
        return None, b"", b""
    return done.returncode, done.stdout, done.stderr


def answer(program, task):
    """What a program makes of a task: its last command's status, stdout and stderr, and the files."""
    with tempfile.TemporaryDirectory() as folder:
        for command in task.before:
            run(program, one_thread(command), b"", folder)
        stdin = "".join(line + "\n" for line in task.lines).encode()
        status, stdout, stderr = run(program, one_thread(task.command), stdin, folder)
        files = {}
        for pattern in task.files:
            for path in glob.glob(pattern, root_dir=folder) or [pattern]:
                file = Path(folder, path)
                files[path] = file.read_bytes() if file.exists() else None
    return status, stdout, stderr, files


def one_thread(command):
    """The jobs are what runs in parallel."""
    pages = ("--help", "schema", "completions", "man", "bodies")
    plain = not command or "--threads" in command or any(word in command for word in pages)
    return command if plain else [*command, "--threads", "1"]


def compare(job):
    """(number of cases, cases without an answer in time, [(command, path, old, new)])."""
    old, new, two_versions, task = job
    allowed = ALLOWED_OF_TWO if two_versions else ALLOWED
    prose = two_versions and (task.kind in dialects.PROSE or (task.kind == "scan border" and "--json" not in task.command))
    if two_versions:
        task = dataclasses.replace(task, command=dialects.command(task.command))
    first, second = answer(old, task), answer(new, task)
    shown = shlex.join(["PROGRAM", *task.command])
    if task.before:
        shown = " && ".join(shlex.join(["PROGRAM", *command]) for command in task.before) + " && " + shown
    cases = max(1, len(task.lines))
    if first[0] is None and second[0] is None:
        return cases, cases, []
    found = []
    if task.lines:
        found += compare_lines(task, first[1].splitlines(), second[1].splitlines(), allowed)
        shown = f"printf '%s\\n' … | {shown}"
    elif not prose:
        found += [(shown, *d) for d in documents.answer_differences(first[1], second[1], allowed, "stdout")]
    if first[0] != second[0]:
        found.append((shown, "exit status", first[0], second[0]))
    if not two_versions:
        found += [(shown, *d) for d in documents.text_differences(first[2], second[2], allowed, "stderr")]
    for name in {**first[3], **second[3]}:
        pair = first[3].get(name), second[3].get(name)
        found += [(shown, f"{name}: {path}", a, b) for path, a, b in documents.file_differences(name, *pair, allowed)]
    return cases, 0, found


def compare_lines(task, first, second, allowed):
    """The lines of a batch's answer; each belongs to the line of the same number."""
    found = []
    if len(first) != len(second):
        found.append((shlex.join(["PROGRAM", *task.command]), "lines", len(first), len(second)))
    for line, a, b in zip(task.lines, first, second):
        shown = f"printf '%s\\n' {shlex.quote(line)} | {shlex.join(['PROGRAM', *task.command])}"
        found += [(shown, *d) for d in documents.answer_differences(a, b, allowed, "stdout")]
    return found


def summary(counts):
    width = max(len(name) for name in counts)
    print(f"{'stratum':<{width}}  {'cases':>7}  {'equal':>7}  {'different':>9}  {'too slow':>8}")
    total = collections.Counter()
    for name, count in counts.items():
        total.update(count)
        print_row(name, count, width)
    print_row("all", total, width)


def print_row(name, count, width):
    equal = count["cases"] - count["different"] - count["slow"]
    print(f"{name:<{width}}  {count['cases']:>7}  {equal:>7}  {count['different']:>9}  {count['slow']:>8}")


def tell(found, limit):
    """The first differences, and how often each field differs."""
    fields = collections.Counter(path for _, _, path, _, _ in found)
    print("\ndifferences by field")
    for path, number in fields.most_common(30):
        print(f"  {number:>6}  {path}")
    print("\nthe first differences")
    told, per_field, per_command = 0, collections.Counter(), collections.Counter()
    for kind, command, path, old, new in found:
        # A few of each field, so that one that differs everywhere does not hide the others.
        if per_field[path] >= TOLD or per_command[command] >= TOLD or told >= limit:
            continue
        per_field[path] += 1
        per_command[command] += 1
        told += 1
        print(f"- {kind}: {path}\n    old {documents.short(old)}\n    new {documents.short(new)}\n    {command}")


def named_bifdiag(program, folder):
    """A link under the name `bifdiag`, since messages carry the name under which a program was started."""
    path = os.path.join(folder, "bifdiag")
    os.symlink(os.path.abspath(program), path)
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", help="program whose answers are taken as right")
    parser.add_argument("new", help="program to be compared")
    parser.add_argument("--bodies", type=int, default=10_000, metavar="N", help="bodies, each with two points [10000]")
    parser.add_argument("--seed", type=int, default=0, metavar="K", help="number from which everything is drawn [0]")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="J", help="processes [one for each core]")
    parser.add_argument("--figures", action="store_true", help="compare the bytes of pictures instead")
    parser.add_argument("--show", type=int, default=40, metavar="M", help="differences that are told [40]")
    arguments = parser.parse_args()
    for program in (arguments.old, arguments.new):
        if not os.access(program, os.X_OK):
            parser.error(f"{program} is not a program")
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(f"{folder}/old")
        os.mkdir(f"{folder}/new")
        old, new = named_bifdiag(arguments.old, f"{folder}/old"), named_bifdiag(arguments.new, f"{folder}/new")
        work = list(tasks.pictures()) if arguments.figures else tasks.all_tasks(old, arguments.seed, arguments.bodies)
        two_versions = dialects.version(old) != dialects.version(new)
        counts, found = collections.defaultdict(collections.Counter), []
        with multiprocessing.Pool(arguments.jobs) as pool:
            jobs = ((old, new, two_versions, task) for task in work)
            for task, (cases, slow, differences) in zip(work, pool.imap(compare, jobs)):
                different = len({command for command, *_ in differences})
                counts[task.stratum].update(cases=cases, slow=slow, different=min(different, cases))
                found += [(f"{task.stratum}, {task.kind}", *difference) for difference in differences]
    summary(counts)
    if found:
        tell(found, arguments.show)
    print(f"{time.monotonic() - start:.0f} s", file=sys.stderr)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
