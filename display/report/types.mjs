// Makes the types of src/data.ts of docs/result.schema.json and of what `mmverify schema bench` prints, which a build has
// in build/release/docs: node types.mjs FOLDER writes FOLDER/result.ts and FOLDER/bench.ts, a type for each of "$defs" by
// its name: scene_dag is SceneDag.
// Of a schema's conditions only "if this topic, then that schema" becomes a type; the others restrict values.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const files = { result: "docs/result.schema.json", bench: "build/release/docs/bench.schema.json" };
const out = resolve(process.argv[2] ?? ".");

const capital = (word) => word[0].toUpperCase() + word.slice(1);
const nameOf = (key) => key.split("_").map(capital).join("");
const simple = { string: "string", integer: "number", number: "number", boolean: "boolean", null: "null" };

function typesOf(document) {
  const defs = document.$defs;
  const referred = (ref) => {
    const key = ref.replace("#/$defs/", "");
    if (!(key in defs)) throw new Error(`${document.title}: no ${ref}`);
    return nameOf(key);
  };
  const several = (types, between) => (types.length > 1 ? `(${types.join(between)})` : types[0]);

  function members(schema) {
    const required = new Set(schema.required ?? []);
    const lines = Object.entries(schema.properties ?? {})
      .filter(([, of]) => of !== false)
      .flatMap(([key, of]) => [
        ...(of.description ? [`/** ${of.description} */`] : []),
        `${JSON.stringify(key)}${required.has(key) ? "" : "?"}: ${type(of)};`,
      ]);
    return `{\n${lines.join("\n")}\n}`;
  }

  function own(name, schema) {
    if (name === "array") return `${type(schema.items)}[]`;
    if (name !== "object") {
      if (!(name in simple)) throw new Error(`${document.title}: no type ${name}`);
      return simple[name];
    }
    const others = schema.additionalProperties;
    return others ? `Record<string, ${type(others)}>` : members(schema);
  }

  function type(schema) {
    const chosen = (schema.allOf ?? []).filter((one) => one.then?.$ref);
    if (chosen.length > 0) return several(chosen.map((one) => referred(one.then.$ref)), " | ");
    const all = [];
    if (schema.$ref) all.push(referred(schema.$ref));
    if (schema.const !== undefined) all.push(JSON.stringify(schema.const));
    else if (schema.enum) all.push(several(schema.enum.map((one) => JSON.stringify(one)), " | "));
    else if (schema.oneOf) all.push(several(schema.oneOf.map(type), " | "));
    else if (schema.type) all.push(several([schema.type].flat().map((name) => own(name, schema)), " | "));
    else if (schema.properties) all.push(members(schema));
    if (all.length === 0) throw new Error(`${document.title}: no type in ${JSON.stringify(schema)}`);
    return several(all, " & ");
  }

  const exported = (name, schema) =>
    `${schema.description ? `/** ${schema.description} */\n` : ""}export type ${name} = ${type(schema)};\n`;
  const types = Object.entries(defs).map(([key, schema]) => exported(nameOf(key), schema));
  if (document.type === "object") types.push(exported("File", document));
  return types.join("\n");
}

mkdirSync(out, { recursive: true });
for (const [name, file] of Object.entries(files)) {
  const document = JSON.parse(readFileSync(join(root, file), "utf8"));
  writeFileSync(join(out, `${name}.ts`), typesOf(document));
}
