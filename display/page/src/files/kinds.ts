// A dropped file's name decides its section.

export type Kind = "scene" | "function" | "result";

const endings: Record<Kind, RegExp> = {
  result: /\.json$/i,
  function: /\.(js|mjs|cjs|wgsl|glsl|comp|hlsl|slang|c|cc|cpp|h|hpp|rs|py)$/i,
  scene: /\.(glb|gltf|bin|png|jpe?g|webp|ktx2|dds|avif|exr)$/i,
};

/** A scene comes with other files, so one file of it decides for all; null where no name is known. */
export function kindOf(names: readonly string[]): Kind | null {
  if (names.some((name) => /\.(glb|gltf)$/i.test(name))) return "scene";
  return (Object.keys(endings) as Kind[]).find((kind) => names.some((name) => endings[kind].test(name))) ?? null;
}
