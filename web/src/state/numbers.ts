/** Numbers as texts: exact where the user wrote them, short where a hand drew them. */

/** The shortest decimal, with an exponent if it is tiny, within half a `step` of a number: what a hand that moves by such steps meant. */
export function rounded(value: number, step: number): string {
  if (value === 0 || !Number.isFinite(value)) return "0";
  const digits = Math.max(0, Math.min(20, Math.ceil(-Math.log10(step))));
  const text = value.toFixed(digits).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
  if (text === "-0" || text === "") return "0";
  return Math.abs(value) < 1e-4 && Number(text) !== 0 ? Number(text).toExponential() : text;
}

/** The step of a hand on numbers of a size: a power of ten, so many digits finer. */
export const stepOf = (size: number, digits: number): number => 10 ** (Math.round(Math.log10(Math.abs(size) || 1)) - digits);

/** A number some steps of its last digit further, of the second decimal at least; numbers that are no plain decimals have three digits then. */
export function stepped(text: string, steps: number): string {
  const value = valueOf(text);
  const step = /^[+-]?[\d.]*$/.test(text) ? 10 ** -Math.max(2, text.split(".")[1]?.length ?? 0) : stepOf(value, 2);
  return rounded((value || 0) + steps * step, step);
}

/** The nearest double of a decimal or a quotient such as 11/10. */
export function valueOf(text: string): number {
  const [numerator, denominator, ...rest] = text.split("/");
  if (rest.length > 0 || !numerator?.trim() || denominator?.trim() === "") return NaN;
  return denominator === undefined ? Number(numerator) : Number(numerator) / Number(denominator);
}

/** A number as people type it, in a field or in an address, as it is read: a decimal comma and the typographic minus are taken, blanks are dropped. */
export function typed(text: string): string {
  const plain = text.replace(/[−–]/g, "-").replace(/\s/g, "");
  return /^[^.,]*,[^.,]*$/.test(plain) ? plain.replace(",", ".") : plain;
}

/** Whether a text is a decimal or a quotient of two. */
export const isNumber = (text: string): boolean => text.split("/").length <= 2 && text.split("/").every((part) => /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(part));

/** A few significant digits for reading, with the minus of the axes. */
export function shown(value: number, digits = 4): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e-4 && size < 1e6 ? String(Number(size.toPrecision(digits))) : size.toExponential(digits - 1);
  return value < 0 ? `−${text}` : text;
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
