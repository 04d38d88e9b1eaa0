"""Bill of materials and licences of what is bundled: `cargo metadata | python3 bill.py TREE FOLDER`.

TREE has a line "name vVERSION" for each crate that is linked. Packages of the page come from web/package-lock.json.
"""
import base64
import json
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# How files with terms are named, in capitals.
TERMS = ("LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE")


def crates(metadata, tree):
    """The linked crates of others, by name and version."""
    linked = {tuple(line.split()[:2]) for line in tree.read_text(encoding="utf-8").splitlines() if line.strip()}
    lock = tomllib.loads((ROOT / "Cargo.lock").read_text(encoding="utf-8"))
    checksums = {(package["name"], package["version"]): package.get("checksum") for package in lock["package"]}
    for package in sorted(metadata["packages"], key=lambda package: (package["name"], package["version"])):
        name, version = package["name"], package["version"]
        if package["source"] and (name, f"v{version}") in linked:
            folder = Path(package["manifest_path"]).parent
            yield f"pkg:cargo/{name}@{version}", name, version, package["license"], folder, ("SHA-256", checksums[name, version])


def modules():
    """What the page carries from npm."""
    wanted = json.loads((ROOT / "web/package.json").read_text(encoding="utf-8"))["dependencies"]
    lock = json.loads((ROOT / "web/package-lock.json").read_text(encoding="utf-8"))["packages"]
    for name in sorted(wanted):
        package = lock[f"node_modules/{name}"]
        digest = base64.b64decode(package["integrity"].removeprefix("sha512-")).hex()
        folder = ROOT / "web/node_modules" / name
        yield f"pkg:npm/{name}@{package['version']}", name, package["version"], package["license"], folder, ("SHA-512", digest)


def terms(folder):
    files = [file for file in sorted(folder.iterdir()) if file.is_file() and file.name.upper().startswith(TERMS)]
    return [file.read_text(encoding="utf-8", errors="replace").strip() for file in files] if folder.is_dir() else []


def spdx(licence):
    """Old crates write a stroke for OR."""
    return licence.replace(" / ", " OR ").replace("/", " OR ")


def main():
    tree, out = map(Path, sys.argv[1:])
    parts = [*crates(json.load(sys.stdin), tree), *modules()]
    version = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    components = [
        {
            "type": "library",
            "bom-ref": address,
            "name": name,
            "version": release,
            "purl": address,
            "hashes": [{"alg": algorithm, "content": digest}],
            "licenses": [{"expression": spdx(licence)}],
        }
        for address, name, release, licence, _, (algorithm, digest) in parts
    ]
    whole = {"type": "application", "bom-ref": "bifdiag", "name": "bifdiag", "version": version}
    bill = {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "metadata": {"component": whole}, "components": components}
    (out / f"bifdiag-{version}.cdx.json").write_text(json.dumps(bill, indent=1) + "\n", encoding="utf-8")

    users = {}
    without = []
    for _, name, release, licence, folder, _ in parts:
        texts = terms(folder)
        if not texts:
            without.append(f"{name} {release}: {licence}")
        for text in texts:
            users.setdefault(text, []).append(f"{name} {release} ({licence})")
    for name, font in ("DejaVu Sans", "DejaVuSans"), ("Bifdiag Math, from STIX Math", "Math"):
        text = (ROOT / f"crates/page/fonts/{font}-LICENSE.txt").read_text(encoding="utf-8").strip()
        users.setdefault(text, []).append(name)
    pages = ["\n".join(sorted(names)) + "\n\n" + text for text, names in sorted(users.items(), key=lambda item: item[1])]
    if without:
        pages.append("Without a text of their own, under the terms that their packages name:\n\n" + "\n".join(without))
    rule = "\n\n" + "=" * 100 + "\n\n"
    (out / "THIRD-PARTY-LICENSES.txt").write_text(rule.join(pages) + "\n", encoding="utf-8")
    print(f"{len(parts)} packages, {len(users)} texts of licences, {len(without)} packages without one")


if __name__ == "__main__":
    main()
