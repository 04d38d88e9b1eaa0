"""Conda packages of wheels: `python3 conda.py WHEEL… OUT`. Needs py-rattler-build, and no channel."""
import os
import shutil
import sys
import tempfile
import zipfile
from pathlib import Path

from rattler_build import PlatformConfig, RenderConfig, Stage0Recipe, VariantConfig

RECIPE = Path(__file__).resolve().parent.parent / "python/conda/recipe.yaml"
# How the names of wheels for Linux end.
PLATFORMS = {"x86_64": "linux-64", "aarch64": "linux-aarch64"}


def build(wheel, out):
    (platform,) = (platform for ending, platform in PLATFORMS.items() if wheel.stem.endswith(ending))
    with tempfile.TemporaryDirectory() as place:
        unpacked = os.environ["WHEEL"] = f"{place}/wheel"
        with zipfile.ZipFile(wheel) as files:
            files.extractall(unpacked)
        (variant,) = Stage0Recipe.from_file(RECIPE).render(VariantConfig(), RenderConfig(PlatformConfig(target_platform=platform)))
        (package,) = variant.run_build(output_dir=f"{place}/out", channels=[], no_include_recipe=True).packages
        (out / platform).mkdir(parents=True, exist_ok=True)
        shutil.copyfile(package, out / platform / Path(package).name)


def main():
    *wheels, out = map(Path, sys.argv[1:])
    for wheel in wheels:
        build(wheel, out)


if __name__ == "__main__":
    main()
