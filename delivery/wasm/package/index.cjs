// mmverify for CommonJS: require("mmverify").  Each function loads the module at its first call; all give promises, as there.
"use strict";

for (const name of ["compile", "run", "prove", "validate", "scene"])
  exports[name] = async (...args) => (await import("./index.mjs"))[name](...args);
