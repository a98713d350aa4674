// Pictures in KTX2 with the texels that other decoders make of them: the files of tests/scene/files, the digests of
// tests/scene/ktx2_test.cpp, and what that test compares when MMVERIFY_KTX2_PICTURES names a folder.
// usage: node scripts/ktx2/pictures.mjs PACKAGES FOLDER
//   PACKAGES  the folder whose node_modules has ktx2-encoder
//   FOLDER    gets NAME.ktx2 and NAME.rgba; each line of the output is NAME and the CRC-32 of NAME.rgba
// Texels are those of Basis Universal's decoder.  Those of UASTC as sRGB are those of astcenc, where it is
// installed, of the ASTC blocks that Basis Universal makes: its own decoder knows no sRGB.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [packages, folder] = process.argv.slice(2);
const encoder = path.join(packages, "node_modules/ktx2-encoder/dist/basis/basis_encoder.js");
const output = console.log;
console.log = () => {}; // the encoder is talkative
const basis = await (await import(pathToFileURL(path.resolve(encoder)).href)).default({ print: () => {} });
basis.initializeBasis();
const RGBA = 13, ASTC = 10; // of basist::transcoder_texture_format

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let k = 0; k < 8; ++k) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (~crc >>> 0).toString(16).padStart(8, "0");
}

function decoded(ktx2, format) {
  const file = new basis.KTX2File(ktx2);
  if (!file.isValid() || !file.startTranscoding()) throw new Error("Basis Universal does not read it");
  const texels = new Uint8Array(file.getImageTranscodedSizeInBytes(0, 0, 0, format));
  if (!file.transcodeImage(texels, 0, 0, 0, format, 0, -1, -1)) throw new Error("Basis Universal does not decode it");
  file.close();
  file.delete();
  return texels;
}

function write(name, ktx2, rgba) {
  fs.writeFileSync(path.join(folder, name + ".ktx2"), ktx2);
  fs.writeFileSync(path.join(folder, name + ".rgba"), rgba);
  output(`${name} ${crc32(rgba)}`);
}

// ---- UASTC: random blocks of each mode ----

/// Code, its bits, and the number of patterns, as tests/scene/ktx2_test.cpp has them.
const modes = [
  [0x01, 4, 0], [0x35, 6, 0], [0x1d, 5, 30], [0x03, 5, 11], [0x13, 5, 30], [0x0b, 5, 0], [0x1b, 5, 0],
  [0x07, 5, 19], [0x17, 5, 0], [0x0f, 5, 30], [0x02, 3, 0], [0x00, 2, 0], [0x06, 3, 0], [0x1f, 5, 0],
  [0x0d, 5, 0], [0x05, 7, 0], [0x15, 6, 30], [0x25, 6, 0], [0x09, 4, 0],
];

let state = 1n;
function next() {
  state ^= state >> 12n;
  state ^= (state << 25n) & 0xffffffffffffffffn;
  state ^= state >> 27n;
  return (state * 0x2545f4914f6cdd1dn) & 0xffffffffffffffffn;
}

/// A valid block: the mode's code, a multiplier for ETC2 that is not 0, and pattern k.
function block(mode, k) {
  const [code, bits, patterns] = modes[mode];
  let value = next() | (next() << 64n);
  const put = (at, count, field) => {
    const mask = ((1n << BigInt(count)) - 1n) << BigInt(at);
    value = (value & ~mask) | (BigInt(field) << BigInt(at));
  };
  put(0, bits, code);
  const hints = bits + (mode >= 10 && mode <= 12 ? 9 : 15);
  const hasAlpha = mode >= 9 && mode <= 17;
  if (hasAlpha) put(hints + 4, 1, 1);
  if (patterns > 0) put(hints + (hasAlpha ? 8 : 0), mode === 3 ? 4 : 5, k % patterns);
  return Array.from({ length: 16 }, (_, byte) => Number((value >> BigInt(8 * byte)) & 0xffn));
}

function uastc(width, height, blocks, srgb) {
  const descriptor = 104, level = 160;
  const file = new Uint8Array(level + blocks.length), words = new DataView(file.buffer);
  file.set([0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a]);
  const header = { 16: 1, 20: width, 24: height, 36: 1, 40: 1, 48: descriptor, 52: 44 };
  const index = { 80: level, 88: blocks.length, 96: blocks.length };
  const block = { [descriptor]: 44, [descriptor + 8]: 2 | (40 << 16) };
  for (const [at, word] of Object.entries({ ...header, ...index, ...block })) words.setUint32(Number(at), word, true);
  file.set([166, 1, srgb ? 2 : 1, 0, 3, 3, 0, 0, 16], descriptor + 12);
  file.set([0, 0, 127, 3], descriptor + 28);
  file.set([255, 255, 255, 255], descriptor + 40);
  file.set(blocks, level);
  return file;
}

function byAstcenc(ktx2, width, height) {
  const at = path.join(folder, "astc");
  const size = (n) => [n & 255, n >> 8, 0];
  const head = [0x13, 0xab, 0xa1, 0x5c, 4, 4, 1, ...size(width), ...size(height), ...size(1)];
  fs.writeFileSync(at + ".astc", Buffer.concat([Buffer.from(head), decoded(ktx2, ASTC)]));
  execFileSync("astcenc", ["-ds", at + ".astc", at + ".ktx"], { stdio: "ignore" });
  const ktx = fs.readFileSync(at + ".ktx"); // KTX 1: a header, key/value data, and a level after its size
  const texels = ktx.subarray(64 + ktx.readUInt32LE(60) + 4), count = width * height;
  // A block of luminance or without alpha may make a picture of fewer channels.
  const channels = { 0x1903: 1, 0x1909: 1, 0x8227: 2, 0x190a: 2, 0x1907: 3, 0x1908: 4 }[ktx.readUInt32LE(24)];
  const rgba = new Uint8Array(4 * count).fill(255);
  for (let k = 0; k < count; ++k)
    for (let channel = 0; channel < 4; ++channel) {
      const from = channels >= 3 ? channel : channel === 3 ? 1 : 0;
      if (from < channels) rgba[4 * k + channel] = texels[channels * k + from];
    }
  return rgba;
}

let hasAstcenc = true;
for (let mode = 0; mode < modes.length; ++mode) {
  const blocks = new Uint8Array(16 * 1024);
  for (let k = 0; k < 1024; ++k) blocks.set(block(mode, k), 16 * k);
  const linear = uastc(128, 128, blocks, false), srgb = uastc(128, 128, blocks, true);
  write(`uastc_${mode}`, linear, decoded(linear, RGBA));
  try {
    if (hasAstcenc) write(`uastc_srgb_${mode}`, srgb, byAstcenc(srgb, 128, 128));
  } catch (error) {
    if (error.code !== "ENOENT") throw error;
    hasAstcenc = false;
    output("no astcenc: no texels of UASTC as sRGB");
  }
}

// ---- Pictures that Basis Universal encodes ----

/// A leaf: round, transparent outside, with waves of colour.
function leaf(width, height, { grey = false, opaque = false, flat = false, noise = 0 }) {
  const rgba = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const at = 4 * (x + width * y), r = Math.hypot((x + 0.5) / width - 0.5, (y + 0.5) / height - 0.5);
      const random = () => noise * Number(next() >> 32n) * 2 ** -32;
      const wave = flat ? 120 : 100 + 80 * Math.sin(0.7 * x) * Math.cos(0.9 * y) + random();
      rgba[at] = grey ? wave : 0.4 * wave;
      rgba[at + 1] = wave;
      rgba[at + 2] = grey ? wave : flat ? 40 : 30 + (x % 20) + random();
      rgba[at + 3] = opaque ? 255 : Math.max(0, Math.min(255, (0.35 - r) * 2000 + random() / 2));
    }
  return rgba;
}

function encoded(rgba, width, height, isUastc, quality, srgb, mips = false) {
  const encoder = new basis.BasisEncoder();
  encoder.setCreateKTX2File(true);
  encoder.setUASTC(isUastc);
  encoder.setKTX2UASTCSupercompression(true);
  encoder.setKTX2AndBasisSRGBTransferFunc(srgb);
  encoder.setQualityLevel(quality);
  encoder.setMipGen(mips);
  encoder.setSliceSourceImage(0, rgba, width, height, 0);
  const bytes = new Uint8Array(rgba.length * 4 + 100000), size = encoder.encode(bytes);
  encoder.delete();
  if (size === 0) throw new Error("Basis Universal does not encode it");
  return bytes.slice(0, size);
}

const etc1s = (name, width, height, quality, kind, mips) => {
  const file = encoded(leaf(width, height, kind), width, height, false, quality, true, mips);
  write(name, file, decoded(file, RGBA));
};
etc1s("etc1s_leaf", 64, 64, 128, {}, true);
etc1s("etc1s_grey", 21, 10, 255, { grey: true });
etc1s("etc1s_wide", 300, 9, 1, {});
etc1s("etc1s_opaque", 37, 22, 255, { opaque: true });
etc1s("etc1s_flat", 160, 96, 64, { flat: true });
etc1s("etc1s_noise", 13, 7, 128, { noise: 60 });
const grey = { grey: true }, noise = { noise: 90 }, opaque = { opaque: true, noise: 9 };
for (const [width, height] of [[1, 1], [4, 4], [5, 3], [257, 3], [2, 131], [256, 256]])
  for (const quality of [1, 128, 255])
    for (const [name, kind] of Object.entries({ grey, noise, opaque }))
      etc1s(`more_etc1s_${width}x${height}_${quality}_${name}`, width, height, quality, kind, quality === 1);
for (const [width, height] of [[1, 1], [13, 7], [64, 64], [200, 120]])
  for (const [name, kind] of Object.entries({ leaf: {}, noise, opaque: { opaque: true } })) {
    const file = encoded(leaf(width, height, kind), width, height, true, 128, false);
    write(`more_uastc_${width}x${height}_${name}`, file, decoded(file, RGBA));
  }
