export { curveIndex, permutation } from "./src/curve.mjs";
export { EXTMeshOpacityMicromap, KHRMeshOpacityMicromap } from "./src/extension.mjs";
export { Micromap, MicromapLink } from "./src/properties.mjs";
export { withMicromaps } from "./src/transform.mjs";
export { write, writeBinary } from "./src/write.mjs";
