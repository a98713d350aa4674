// Modules that build.mjs puts in their place.
declare module "worker-text" {
  const text: string;
  export default text;
}
declare module "mmverify-package" {
  export const run: typeof import("../../../../delivery/wasm/package/index").run;
}
