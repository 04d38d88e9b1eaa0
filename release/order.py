"""The packages that are published, each after those that it needs: `cargo metadata --no-deps | python3 order.py`."""
import json
import sys
from graphlib import TopologicalSorter


def main():
    packages = {package["name"]: package for package in json.load(sys.stdin)["packages"]}
    published = {name for name, package in packages.items() if package["publish"] != []}
    needs = {
        name: {need["name"] for need in packages[name]["dependencies"] if need["kind"] != "dev"} & published
        for name in sorted(published)
    }
    print("\n".join(TopologicalSorter(needs).static_order()))


if __name__ == "__main__":
    main()
