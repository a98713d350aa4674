// A stand-in of emscripten's program: asks a script's index_f32 at pairs of floats beside diagonals, where sums are rounded,
// and says on how many it is wrong. The package around it is what is tested, and needs no WebAssembly for that.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";

const { fround } = Math;
/** More digits than a number of JavaScript has. */
export const seed = "18446744073709551615";

/** Pairs at and beside the diagonals of a level, last bit 2^-40 or more: doubles have room for their sums. */
function pairs(level) {
  const [N, us, vs] = [2 ** level, [], []];
  for (let k = 0; k < 3000; ++k) {
    const i = k % N, j = (7 * k) % (N - i), f = fround((1 + ((k * 1399) % 2 ** 22)) / 2 ** 22);
    const [u, v] = [fround((i + f) / N), fround((j + 1 - f) / N - (k % 3) * 2 ** -26)];
    if (v > 2 ** -12 && u > 2 ** -12 && u + v <= 1) us.push(u), vs.push(v);
  }
  return [Float32Array.from(us), Float32Array.from(vs)];
}

/** Whether the point lies in the upper half of its square, on which scripts answer 1. */
const upper = (level, u, v) => {
  const [a, b] = [u * 2 ** level, v * 2 ** level];
  return a - Math.floor(a) + (b - Math.floor(b)) >= 1 ? 1 : 0;
};

export default async function createProgram(options) {
  const io = {};
  options.preRun[0]({ FS: { init: (input, out, errors) => Object.assign(io, { input, out, errors }) } });
  const tell = (text) => Buffer.from(text).forEach((byte) => io.out(byte));
  const text = (result) => JSON.stringify(result).replace(/}$/, `,"seed":${seed}}`);
  const written = (name, result) => (name === "-" ? tell(text(result)) : writeFileSync(name, text(result)));
  return {
    FS: {
      mkdirTree: (name) => mkdirSync(name, { recursive: true }),
      writeFile: writeFileSync,
      readFile: readFileSync,
      analyzePath: (name) => ({ exists: existsSync(name) }),
      mount() {},
      chdir() {},
    },
    callMain(args) {
      const after = (option) => (args.includes(option) ? args[args.indexOf(option) + 1] : undefined);
      if (args[0] === "merge") {
        written(after("-o"), { schema: "mmverify.result/1", results: [] });
        tell("merged\n");
        return 0;
      }
      let wrong = 0;
      for (let level = 1; level <= 5; ++level) {
        const [u, v] = pairs(level);
        const answers = new Uint32Array(u.length);
        options.subject.index_f32(level, u, v, answers);
        wrong += answers.filter((answer, k) => answer !== upper(level, u[k], v[k])).length;
      }
      const result = { schema: "mmverify.result/1", results: [{ wrong }] }; // and a seed, which JSON.parse would round
      if (after("--shard") !== undefined) result.shard = {};
      if (after("--json") !== "-") tell(`wrong: ${wrong}\n`);
      if (after("--json") !== undefined) written(after("--json"), result);
      return wrong > 0 ? 1 : 0;
    },
  };
}
