/** The texts of the page in the reader's language: one language is loaded, before the page is put together. */
type Page = typeof import("./en/page").default;
type Guide = typeof import("./en/guide").default;

/** What a language has: whatever English has, so that a missing text does not compile. */
export type { Page, Guide };

export const LANGUAGES = { en: "English", de: "Deutsch", fr: "Français" } as const;
export type Language = keyof typeof LANGUAGES;

const PAGES: Record<Language, () => Promise<{ default: Page }>> = { en: () => import("./en/page"), de: () => import("./de/page"), fr: () => import("./fr/page") };
const GUIDES: Record<Language, () => Promise<{ default: Guide }>> = { en: () => import("./en/guide"), de: () => import("./de/guide"), fr: () => import("./fr/guide") };

export let language: Language = "en";
export let texts: Page;

const known = (name: string | null | undefined): Language | undefined => (name && name.slice(0, 2) in LANGUAGES ? (name.slice(0, 2) as Language) : undefined);

/** The language of `?lang=`, or else the first of the browser's that is here. */
export const wanted = (search: string, browser: readonly string[]): Language => known(new URLSearchParams(search).get("lang")) ?? browser.map(known).find((name) => name !== undefined) ?? "en";

export async function speak(chosen: Language): Promise<void> {
  texts = (await PAGES[chosen]()).default;
  language = chosen;
}

/** Texts that few read, loaded when they are asked for. */
export const guideTexts = async (): Promise<Guide> => (await GUIDES[language]()).default;

/** The present address in a language, with what follows. */
export const addressIn = (chosen: Language, hash: string): string => `${location.origin}${location.pathname}?lang=${chosen}${hash}`;
