// The four states: their tints, which people tell apart who do not see all colours, and their words.
export const tints = [
  { word: "#a9b7c6", sign: "T", words: "transparent" },
  { word: "#0072b2", sign: "O", words: "opaque" },
  { word: "#f0e442", sign: "UT", words: "unknown-transparent" },
  { word: "#d55e00", sign: "UO", words: "unknown-opaque" },
] as const;
