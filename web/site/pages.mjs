// What the site consists of: each page with its source in the repository.

/** The documentation, in the order of the index; the name of a page is that of its source. */
export const GROUPS = [
  ["Start", ["README.md", "docs/tutorial.md", "docs/explorer.md", "docs/recipes.md", "docs/glossary.md"]],
  ["Diagrams", ["docs/types.md", "docs/survey.md", "docs/scans.md", "docs/stability.md", "docs/draw-it-yourself.md"]],
  ["Motion", ["docs/sections.md", "docs/periodic-orbits.md", "docs/proved-motion.md"]],
  ["Real parts", ["docs/engineering.md", "examples/heavy-top-benchmark/README.md", "examples/heavy-top-benchmark/league.md"]],
  ["Programs", ["python/README.md", "docs/library.md", "docs/other-languages.md", "docs/formats.md", "examples/cluster/README.md", "web/README.md"]],
  ["Mathematics", ["docs/mathematics.md", "docs/algorithms.md", "docs/errata.md", "docs/tenth-type.md"]],
  ["Trust", ["docs/accuracy.md", "docs/certified.md", "docs/benchmarks.md", "data/oracles/README.md", "data/accuracy/README.md", "data/cases/README.md"]],
  ["Project", ["docs/design.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"]],
];

/** Pages whose dollar signs are formulas. */
export const MATHEMATICAL = new Set(["docs/mathematics.md", "docs/algorithms.md"]);

export const GALLERY = "figures/README.md";

/** Sources whose name says nothing. */
const NAMES = {
  "README.md": "overview",
  "ARCHITECTURE.md": "architecture",
  "CONTRIBUTING.md": "contributing",
  "CHANGELOG.md": "changelog",
  "python/README.md": "python",
  "web/README.md": "page",
  "examples/cluster/README.md": "clusters",
  "examples/heavy-top-benchmark/README.md": "heavy-top-benchmark",
  "data/oracles/README.md": "oracles",
  "data/accuracy/README.md": "accuracy-data",
  "data/cases/README.md": "cases",
  [GALLERY]: "gallery",
};

const nameOf = (source) => NAMES[source] ?? source.split("/").at(-1).replace(/\.md$/, "");

/** Source to file of the site. */
export const FILES = new Map([...GROUPS.flatMap(([, sources]) => sources), GALLERY].map((source) => [source, `${nameOf(source)}.html`]));

/** The head of every page: name and file. */
export const NAVIGATION = [
  ["Explorer", "explorer/index.html"],
  ["Gallery", "gallery.html"],
  ["Tutorial", "tutorial.html"],
  ["Classes", "classes.html"],
  ["Mathematics", "mathematics.html"],
  ["Python", "python.html"],
  ["All pages", "pages.html"],
];
