// The front page: the explorer at once, then what the program does.
import { escaped } from "./frame.mjs";

const PICTURE = "figures/bifurcation-nine-regions.svg";

/** `has`: optional parts of the site that were there to be copied. */
export function front(files, has) {
  const picture = files.copy(PICTURE);
  const items = [
    ["Tutorial", "tutorial.html", "The paper by Schmidt, Dullin and Richter, worked through with the program"],
    ["Gallery", "gallery.html", "Every figure, with the command that draws it"],
    ["Classes", "classes.html", "Known classes of diagrams, each with a body, a drawing and its neighbours"],
    ["Mathematics", "mathematics.html", "What is proved about heavy tops, on one page"],
    ["For engineers", "engineering.html", "Axes and spins of real parts: tensors, meshes, robot descriptions"],
    ["Heavy-top benchmark", "heavy-top-benchmark.html", "How far physics engines are from proved motions"],
    ["Python", "python.html", "Arrays in, tables and plots out"],
    ...(has.reference ? [["Python reference", "python/index.html", "Every class and function"]] : []),
    ...(has.manuscript ? [["Manuscript (PDF)", "manuscript.pdf", "All bifurcation diagrams of the heavy rigid body"]] : []),
    ["All pages", "pages.html", "The documentation by subject"],
  ];
  const list = items.map(([name, to, what]) => `<li><a href="${to}">${name}</a>: ${escaped(what)}.</li>`).join("\n");
  return `<h1>Bifurcation diagrams of any heavy rigid body, live</h1>
<p>Change the body or take a point of the diagram: regions, topology, the accessible region and the motion follow at once.
Everything is computed in your browser. <a href="explorer/index.html">Open the explorer in a window of its own</a>.</p>
<iframe class="live" loading="lazy" src="explorer/index.html" title="The explorer: diagram, sphere and section of a body"></iframe>
<p class="instead"><a href="explorer/index.html"><img src="${picture}" alt="Bifurcation diagram of a body with nine regions" width="922" height="1020"></a></p>
<h2 id="what">What it does</h2>
<p>A rigid body that turns about a fixed point under gravity conserves its energy and its vertical angular momentum. bifdiag
finds all regions of the plane of these two in which phase space has one shape, for every body, exactly and with a proof that
another program checks; all steady rotations with a verdict on their stability; and motions with proved bounds.</p>
<ul>
${list}
</ul>
<h2 id="start">Start</h2>
<p>In a clone of the repository, with a stable Rust toolchain:</p>
<pre><code>cargo run --release -- --A 2,1.1,1 --r 0.94868,0,0.61623</code></pre>
<p><img src="${picture}" alt="Its bifurcation diagram: curves of steady rotations, pole lines, nine labelled regions" width="922" height="1020" loading="lazy"></p>
`;
}
