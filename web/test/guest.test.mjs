// The guest gives what the command line gives, to the byte.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import path from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const target = process.env.CARGO_TARGET_DIR ?? path.join(root, "target");
const guest = createRequire(import.meta.url)(path.join(target, "web/bifdiag_web.js"));
const program = (...options) => execFileSync(path.join(target, "release/bifdiag"), options, { encoding: "utf8" });

const bodies = [
  { text: "body=paper", options: ["--body", "paper"] },
  { text: "body=katok:6", options: ["--body", "katok:6"] },
  { text: "A=2,1.5,1.2&r=0.5,1/3,-1e-3", options: ["--A=2,1.5,1.2", "--r=0.5,1/3,-1e-3"] },
];

for (const { text, options } of bodies) {
  test(`${text} is the command line's`, () => {
    assert.equal(guest.atlas(text), program(...options, "--json"));
    assert.equal(guest.classify(text, "3.8", "3.25"), program("classify", ...options, "--h", "3.8", "--l", "3.25", "--json"));
    assert.equal(guest.critical(text, "13/4"), program("critical", ...options, "--l", "13/4", "--json"));
  });
}

test("what is wrong is told", () => {
  assert.throws(() => guest.atlas("A=2,1,1"), /r is missing/);
  assert.throws(() => guest.atlas("A=2,-1,1&r=1,0,0"), /A2 = -1 is not positive/);
  assert.throws(() => guest.classify("body=paper", "x", "1"), /h: `x` is not a number/);
  assert.throws(() => guest.atlas("body=nothing"), /no body `nothing`/);
});
