/** Written by `tools/presets.ts` when the page is built. */
declare module "virtual:presets" {
  const presets: import("./body").Preset[];
  export default presets;
}
