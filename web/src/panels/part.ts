/** A real part as the body: a mesh or an inertial block that is dropped or chosen, or a tensor as CAD prints it. */
import type { PartBlock } from "../bindings/documents";
import { button, make } from "../draw/dom";
import { shown } from "../state/numbers";
import type { Session } from "../state/session";
import type { Guide } from "../texts";

const input = (name: string, placeholder: string, hint: string): HTMLInputElement =>
  make("input", { type: "text", placeholder, title: hint, spellcheck: false, autocomplete: "off", attributes: { "aria-label": hint }, data: { testid: `part-${name}` } });

const choice = (name: string, ...options: [value: string, label: string][]): HTMLSelectElement => {
  const select = make("select", { attributes: { "aria-label": name }, data: { testid: `part-${name}` } });
  for (const [value, label] of options) select.append(make("option", { value }, label));
  return select;
};

const value = (field: HTMLInputElement): string => field.value.trim();

/** Fills a form; `zone`: where files may be dropped. */
export function partForm(session: Session, words: Guide["part"], form: HTMLDetailsElement, zone: HTMLElement): void {
  const units = choice("units", ...["kg,m,s", "kg,mm,s", "g,mm,s", "g,cm,s"].map((name): [string, string] => [name, name.replace(/,/g, " ")]));
  const density = input("density", words.density, words.densityHelp);
  const mass = input("mass", words.mass, words.massHelp);
  const point = input("point", words.point, words.pointHelp);
  const file = make("input", { type: "file", accept: ".stl,.obj,.ply,.urdf,.xml", attributes: { "aria-label": words.file }, data: { testid: "part-file" } });
  const tensor = input("tensor", "Ixx, Iyy, Izz, Ixy, Ixz, Iyz", words.tensorHelp);
  const about = choice("about", ["com", words.com], ["point", words.fixed]);
  const products = choice("products", ["", words.sign], ["tensor", "Ixy = −∫ xy dm"], ["integral", "Ixy = +∫ xy dm"]);
  const told = make("p", { className: "note", data: { testid: "part-note" } });

  const take = async (part: Promise<PartBlock>): Promise<void> => {
    try {
      const found = await part;
      const moments = found.principal_com.moments.map((moment) => shown(moment)).join(", ");
      told.textContent = `${words.found(moments, shown(Number(found.mass)), found.units.replace(/,/g, " "), String(found.g))}${found.exact ? "" : words.rounded}.`;
      session.fail("");
      session.adopt(found.A, found.r);
    } catch (error) {
      session.fail(error instanceof Error ? error.message : String(error));
    }
  };
  const read = async (chosen: File): Promise<void> => {
    form.open = true;
    const bytes = new Uint8Array(await chosen.arrayBuffer());
    // An inertial block has its own mass and units.
    const block = /\.(urdf|xml)$/i.test(chosen.name);
    await take(session.partOfFile(chosen.name, bytes, block ? "" : value(density), block ? "" : value(mass), units.value, value(point)));
  };
  file.addEventListener("change", () => file.files?.[0] && void read(file.files[0]).then(() => (file.value = "")));
  zone.addEventListener("drop", (event) => {
    event.preventDefault();
    const dropped = event.dataTransfer?.files[0];
    if (dropped) void read(dropped);
  });
  const ofTensor = (): void => {
    const entries = value(tensor).split(/[\s,;]+/).slice(3);
    if (entries.some((entry) => Number(entry) !== 0) && !products.value) return session.fail(words.products);
    void take(session.partOfTensor(value(tensor), products.value === "integral", about.value === "com", value(point), value(mass), units.value));
  };
  form.append(
    make("div", { className: "row" }, units, density, mass, point),
    make("div", { className: "row" }, file),
    make("div", { className: "row" }, tensor, about, products, button("take", words.take, ofTensor, { testid: "part-take" })),
    told,
  );
}
