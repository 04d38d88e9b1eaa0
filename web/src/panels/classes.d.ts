/** Written by `tools/classes.ts` when the page is built. */
declare module "virtual:classes" {
  const catalogue: import("./catalogue").Catalogue;
  export default catalogue;
}
