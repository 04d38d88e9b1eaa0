// Formulas as MathML that browsers show as they are meant: MathML Core has no `mathvariant` but in letters of their own, and
// does not know that a sign after a relation is no operation.
import katex from "katex";

/** First capital and small letter of an alphabet, and letters that stand elsewhere. */
const ALPHABETS = {
  bold: [0x1d400, 0x1d41a, {}],
  script: [0x1d49c, 0x1d4b6, { B: "ℬ", E: "ℰ", F: "ℱ", H: "ℋ", I: "ℐ", L: "ℒ", M: "ℳ", R: "ℛ", e: "ℯ", g: "ℊ", o: "ℴ" }],
  "double-struck": [0x1d538, 0x1d552, { C: "ℂ", H: "ℍ", N: "ℕ", P: "ℙ", Q: "ℚ", R: "ℝ", Z: "ℤ" }],
};

function lettered(variant, letter) {
  const [capital, small, elsewhere] = ALPHABETS[variant];
  const code = letter.codePointAt(0);
  if (elsewhere[letter]) return elsewhere[letter];
  if (/[A-Z]/.test(letter)) return String.fromCodePoint(capital + code - 65);
  if (/[a-z]/.test(letter)) return String.fromCodePoint(small + code - 97);
  throw new Error(`no ${variant} ${letter}`);
}

export function formula(tex, display) {
  const html = katex.renderToString(tex, { output: "mathml", displayMode: display, throwOnError: true, strict: "ignore" });
  const shown = html
    .replace(/<(mi|mn|mtext) mathvariant="(bold|script|double-struck)">([^<]*)</g, (_, tag, variant, text) => `<${tag} mathvariant="normal">${[...text].map((letter) => lettered(variant, letter)).join("")}<`)
    .replace(/(<mo[^>]*>(?:=|≤|≥|&lt;|&gt;|→|≠|∈|,|:)<\/mo>)<mo>([+−±∓])<\/mo>/g, '$1<mo form="prefix">$2</mo>');
  const variant = /mathvariant="(?!normal)[^"]*"/.exec(shown);
  if (variant) throw new Error(`${tex}: ${variant[0]} would be lost`);
  return shown;
}
