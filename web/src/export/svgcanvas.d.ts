declare module "svgcanvas" {
  /** A canvas context that writes SVG. */
  export class Context {
    constructor(options: { width: number; height: number });
    getSerializedSvg(namedEntities?: boolean): string;
  }
}
