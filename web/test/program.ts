/** The command line, and bodies to compare it with. */
import { execFileSync } from "node:child_process";
import path from "node:path";
import { fileURLToPath } from "node:url";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const target = process.env.CARGO_TARGET_DIR ?? path.join(root, "target");

/** What `bifdiag` prints. */
export const bifdiag = (...options: string[]): string =>
  execFileSync(process.env.BIFDIAG ?? path.join(target, "release/bifdiag"), options, { encoding: "utf8", maxBuffer: 1 << 27, stdio: ["ignore", "pipe", "ignore"] });

export interface Body {
  A: string;
  r: string;
}

export const hashOf = ({ A, r }: Body): string => `A=${A}&r=${r}`;
export const optionsOf = ({ A, r }: Body): string[] => [`--A=${A}`, `--r=${r}`];

const SPECIAL: Body[] = [
  { A: "2,1.1,1", r: "0.94868,0,0.61623" },
  { A: "2,2,1", r: "1,0,0" },
  { A: "2,1,1", r: "1,0,0" },
  { A: "2,1.5,1", r: "0,0,0" },
  { A: "1,1,1", r: "1,0,0" },
  { A: "11/10,1,3/2", r: "0.5,1/3,-1e-3" },
  { A: "3,2,1", r: "0,0.8,0.6" },
  { A: "1,0.7,0.5", r: "1,0,0" },
  { A: "0.57847392,0.53739099,1", r: "0.00595273,0.00176367,-0.99998073" },
  { A: "200,110,100", r: "94.868,0,61.623" },
];

/** Special bodies, then bodies whose decimals a fixed sequence draws; all of them exist. */
export function bodies(count: number): Body[] {
  const list = SPECIAL.slice(0, count);
  let seed = 7;
  const next = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  while (list.length < count) {
    const [x, y, z] = [next() + 0.05, next() + 0.05, next() + 0.05];
    // Moments of three pairs of masses on the axes: y² + z² and so on.
    const A = [y + z, z + x, x + y].map((a) => a.toFixed(4));
    const r = [next(), next(), next()].map((value) => (2 * value - 1).toFixed(4));
    list.push({ A: A.join(","), r: r.join(",") });
  }
  return list;
}
