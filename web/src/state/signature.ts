import type { Component } from "../bindings/documents";

/** The sections' names joined by +; empty where there is none. */
export const signatureOf = (components: Component[] | null): string =>
  components?.every((component) => component.section !== null) ? components.map((component) => component.section).join("+") : "";
