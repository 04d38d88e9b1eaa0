/** A real part as the body: a mesh or an inertial block that is dropped or chosen, or a tensor as CAD prints it. */
import type { PartBlock } from "../bindings/documents";
import { button, make } from "../draw/dom";
import { shown } from "../state/numbers";
import type { Session } from "../state/session";

const input = (name: string, placeholder: string, hint: string): HTMLInputElement =>
  make("input", { type: "text", placeholder, title: hint, spellcheck: false, autocomplete: "off", attributes: { "aria-label": name }, data: { testid: `part-${name}` } });

const choice = (name: string, ...options: [value: string, label: string][]): HTMLSelectElement => {
  const select = make("select", { attributes: { "aria-label": name }, data: { testid: `part-${name}` } });
  for (const [value, label] of options) select.append(make("option", { value }, label));
  return select;
};

const value = (field: HTMLInputElement): string => field.value.trim();

/** Fills a form; `zone`: where files may be dropped. */
export function partForm(session: Session, form: HTMLDetailsElement, zone: HTMLElement): void {
  const units = choice("units", ...["kg,m,s", "kg,mm,s", "g,mm,s", "g,cm,s"].map((name): [string, string] => [name, name.replace(/,/g, " ")]));
  const density = input("density", "density", "Density of a mesh, in the units of mass and length");
  const mass = input("mass", "or mass", "Mass, for a mesh or a tensor");
  const point = input("point", "fixed point / centre of mass: 0, 0, 0", "A file: the fixed point in its frame. A tensor: the centre of mass, from the fixed point");
  const file = make("input", { type: "file", accept: ".stl,.obj,.ply,.urdf,.xml", attributes: { "aria-label": "file of a part" }, data: { testid: "part-file" } });
  const tensor = input("tensor", "Ixx, Iyy, Izz, Ixy, Ixz, Iyz", "The tensor of inertia in the units of mass and length²");
  const about = choice("about", ["com", "about the centre of mass"], ["point", "about the fixed point"]);
  const products = choice("products", ["", "sign of the products?"], ["tensor", "Ixy = −∫ xy dm"], ["integral", "Ixy = +∫ xy dm"]);
  const told = make("p", { className: "note", data: { testid: "part-note" } });

  const take = async (part: Promise<PartBlock>): Promise<void> => {
    try {
      const found = await part;
      const moments = found.principal_com.moments.map((moment) => shown(moment)).join(", ");
      told.textContent = `Principal moments about the centre of mass: ${moments}; mass ${shown(Number(found.mass))} (${found.units.replace(/,/g, " ")}, g = ${found.g} m/s²). h, l and r are in these units${found.exact ? "" : "; A and r are rounded to 130 digits; symmetries are exact"}.`;
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
    if (entries.some((entry) => Number(entry) !== 0) && !products.value) return session.fail("Products of inertia are not 0, and programs differ in their sign: choose which one yours prints");
    void take(session.partOfTensor(value(tensor), products.value === "integral", about.value === "com", value(point), value(mass), units.value));
  };
  form.append(
    make("div", { className: "row" }, units, density, mass, point),
    make("div", { className: "row" }, file),
    make("div", { className: "row" }, tensor, about, products, button("take", "Use this tensor as the body", ofTensor, { testid: "part-take" })),
    told,
  );
}
