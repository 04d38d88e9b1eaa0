"""A registry in a folder, as cargo reads one: `python3 registry.py CRATES REGISTRY`.

The index is a git repository with a line of JSON for each crate; the files lie beside it.
"""
import hashlib
import json
import shutil
import subprocess
import sys
import tarfile
import tomllib
from pathlib import Path


def place(name):
    """Where the index has a crate."""
    return {1: f"1/{name}", 2: f"2/{name}", 3: f"3/{name[0]}/{name}"}.get(len(name), f"{name[:2]}/{name[2:4]}/{name}")


def manifest(crate):
    with tarfile.open(crate) as files:
        return tomllib.loads(files.extractfile(f"{crate.stem}/Cargo.toml").read().decode())


def needs(table, kind, target=None, own=frozenset()):
    for name, need in table.items():
        need = {"version": need} if isinstance(need, str) else need
        crate = need.get("package", name)
        yield {
            "name": name,
            "req": need.get("version", "*"),
            "features": need.get("features", []),
            "optional": need.get("optional", False),
            "default_features": need.get("default-features", True),
            "target": target,
            "kind": kind,
            "registry": None if crate in own else "https://github.com/rust-lang/crates.io-index",
            **({"package": crate} if crate != name else {}),
        }


def entry(crate, own):
    read = manifest(crate)
    kinds = (("dependencies", "normal"), ("build-dependencies", "build"))
    found = [need for table, kind in kinds for need in needs(read.get(table, {}), kind, None, own)]
    for target, tables in read.get("target", {}).items():
        found += [need for table, kind in kinds for need in needs(tables.get(table, {}), kind, target, own)]
    package = read["package"]
    return {
        "name": package["name"],
        "vers": package["version"],
        "deps": found,
        "features": read.get("features", {}),
        "cksum": hashlib.sha256(crate.read_bytes()).hexdigest(),
        "yanked": False,
    }


def main():
    crates, registry = (Path(argument).resolve() for argument in sys.argv[1:])
    shutil.rmtree(registry, ignore_errors=True)
    index, files = registry / "index", registry / "files"
    files.mkdir(parents=True)
    index.mkdir()
    (index / "config.json").write_text(json.dumps({"dl": f"file://{files}/{{crate}}-{{version}}.crate"}))
    archives = sorted(crates.glob("*.crate"))
    own = {manifest(crate)["package"]["name"] for crate in archives}
    for crate in archives:
        line = entry(crate, own)
        file = index / place(line["name"])
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(line) + "\n")
        shutil.copy(crate, files)
    git = ["git", "-C", str(index), "-c", "user.name=release", "-c", "user.email=release@invalid"]
    for words in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "crates"]):
        subprocess.run([*git, *words], check=True)


if __name__ == "__main__":
    main()
