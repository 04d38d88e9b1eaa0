/** Numbers as texts: exact where the user wrote them, short where a hand drew them. */

/** The shortest decimal within half a `step` of a number: what a hand that moves by such steps meant. */
export function rounded(value: number, step: number): string {
  if (value === 0 || !Number.isFinite(value)) return "0";
  const digits = Math.max(0, Math.min(20, Math.ceil(-Math.log10(step))));
  const text = value.toFixed(digits).replace(/\.?0+$/, "");
  return text === "-0" || text === "" ? "0" : text;
}

/** The nearest double of a decimal or a quotient such as 11/10. */
export function valueOf(text: string): number {
  const [numerator, denominator, ...rest] = text.split("/");
  if (rest.length > 0 || !numerator?.trim() || denominator?.trim() === "") return NaN;
  return denominator === undefined ? Number(numerator) : Number(numerator) / Number(denominator);
}

/** A number as people type it, as it is read: a decimal comma and the typographic minus are taken, blanks are dropped. */
export function typed(text: string): string {
  const plain = text.replace(/[−–]/g, "-").replace(/\s/g, "");
  return /^[^.,]*,[^.,]*$/.test(plain) ? plain.replace(",", ".") : plain;
}

/** Whether a text is a decimal or a quotient of two. */
export const isNumber = (text: string): boolean => text.split("/").length <= 2 && text.split("/").every((part) => /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(part));

/** A few significant digits for reading. */
export function shown(value: number, digits = 4): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e-4 && size < 1e6 ? String(Number(value.toPrecision(digits))) : value.toExponential(digits - 1);
}

const SUPERSCRIPTS: Record<string, string> = { "0": "⁰", "1": "¹", "2": "²", "3": "³", "4": "⁴" };

/** S2+T2 as S²+T², M3 as M²₃ (genus 3), S2-2D2 as S²∖2D². */
export function surface(name: string): string {
  return name
    .replace(/M(\d+)/g, (_, genus: string) => `M²${String.fromCodePoint(0x2080 + Number(genus))}`)
    .replace(/(RP|[SDT])(\d)/g, (_, letter: string, digit: string) => letter + (SUPERSCRIPTS[digit] ?? digit))
    .replace(/-/g, "∖")
    .replace(/x/g, "×");
}
