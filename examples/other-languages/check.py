#!/usr/bin/env python3
"""Checks docs/other-languages.md: check.py [PROGRAM], with PROGRAM the bifdiag to ask (default: bifdiag).

The page must show the scripts of this folder whole. Each script whose interpreter is installed is run, and must print what
the page says and draw its picture. JULIA, OCTAVE and MATHICS name other interpreters than julia, octave-cli and mathics3.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PAGE = (HERE / "../../docs/other-languages.md").read_text()
LANGUAGES = [
    ("julia", "bifdiag.jl", [os.environ.get("JULIA", "julia")], "julia.svg"),
    ("octave", "bifdiag.m", [os.environ.get("OCTAVE", "octave-cli"), "--norc"], "octave.svg"),
    ("wolfram", "bifdiag.wl", [os.environ.get("MATHICS", "mathics3"), "-q", "-f"], "wolfram.svg"),
]

program = sys.argv[1] if len(sys.argv) > 1 else "bifdiag"
blocks = re.findall(r"^```(\w+)\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
printed = [body for language, body in blocks if language == "console"]
right, failed, skipped = 0, 0, 0
with tempfile.TemporaryDirectory() as folder:
    for line in next(body for language, body in blocks if language == "sh").splitlines():
        command, _, target = line.partition(" > ")
        words = [program, *shlex.split(command)[1:]]
        answer = subprocess.run(words, cwd=folder, check=True, stdout=subprocess.PIPE).stdout
        if target:
            (Path(folder) / target).write_bytes(answer)
    for (language, script, command, picture), expected in zip(LANGUAGES, printed, strict=True):
        shown = "\n".join(body for found, body in blocks if found == language)
        if shown != (HERE / script).read_text():
            print(f"{script}: the page shows another text")
            failed += 1
        elif not shutil.which(command[0]):
            print(f"{script}: {command[0]} is not installed")
            skipped += 1
        else:
            words = [*command, HERE / script]
            run = subprocess.run(words, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True)
            if run.stdout.strip() == expected.strip() and (Path(folder) / picture).exists():
                right += 1
            else:
                print(f"{script}: printed\n{run.stdout}{run.stderr}instead of\n{expected}")
                failed += 1
print(f"{right} passed, {failed} failed, {skipped} skipped")
sys.exit(failed > 0)
