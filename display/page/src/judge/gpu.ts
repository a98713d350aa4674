// An index function in WGSL, asked on WebGPU.
import type { Answered, Points } from "../program/messages";

// Of WebGPU's types only what is used: TypeScript's library of the DOM has none.
interface Buffer {
  mapAsync(mode: number): Promise<void>;
  getMappedRange(): ArrayBuffer;
  destroy(): void;
}
interface Device {
  createShaderModule(of: { code: string }): { getCompilationInfo(): Promise<{ messages: { type: string; lineNum: number; message: string }[] }> };
  createComputePipelineAsync(of: object): Promise<{ getBindGroupLayout(k: number): object }>;
  createBuffer(of: { size: number; usage: number }): Buffer;
  createBindGroup(of: object): object;
  createCommandEncoder(): {
    beginComputePass(): { setPipeline(p: object): void; setBindGroup(k: number, group: object): void; dispatchWorkgroups(n: number): void; end(): void };
    copyBufferToBuffer(from: Buffer, at: number, to: Buffer, toAt: number, size: number): void;
    finish(): object;
  };
  queue: { writeBuffer(to: Buffer, at: number, data: ArrayBufferView): void; submit(all: object[]): void };
  lost: Promise<{ message: string }>;
  destroy(): void;
}
interface Gpu {
  requestAdapter(): Promise<{ requestDevice(): Promise<Device> } | null>;
}

const usage = { mapRead: 1, copySrc: 4, copyDst: 8, uniform: 64, storage: 128 };

/** Null, or why WGSL cannot be run here. */
export async function noGpu(): Promise<string | null> {
  const gpu = (navigator as { gpu?: Gpu }).gpu;
  if (!gpu) return "This browser has no WebGPU";
  return (await gpu.requestAdapter()) ? null : "WebGPU finds no graphics device here";
}

const before = `struct Given { level: u32, count: u32 }
@group(0) @binding(0) var<uniform> given: Given;
@group(0) @binding(1) var<storage, read> points: array<vec2f>;
@group(0) @binding(2) var<storage, read_write> answers: array<u32>;
@compute @workgroup_size(64) fn ask_all(@builtin(global_invocation_id) id: vec3u) {
  if (id.x < given.count) { answers[id.x] = index(given.level, points[id.x].x, points[id.x].y); }
}
`;

/** Points a dispatch: 65,535 workgroups of 64 are WebGPU's limit. */
const most = 65535 * 64;

export class Shader {
  private constructor(
    private readonly device: Device,
    private readonly pipeline: { getBindGroupLayout(k: number): object },
  ) {}

  static async compile(code: string): Promise<Shader> {
    const adapter = await (navigator as { gpu?: Gpu }).gpu?.requestAdapter();
    if (!adapter) throw new Error("no graphics device that WebGPU finds");
    const device = await adapter.requestDevice();
    const module = device.createShaderModule({ code: before + code });
    const linesBefore = before.split("\n").length - 1;
    const bad = (await module.getCompilationInfo()).messages.find((m) => m.type === "error");
    if (bad) throw new Error(bad.lineNum > linesBefore ? `line ${bad.lineNum - linesBefore}: ${bad.message}` : `${bad.message} (wanted: fn index(level: u32, u: f32, v: f32) -> u32)`);
    return new Shader(device, await device.createComputePipelineAsync({ layout: "auto", compute: { module, entryPoint: "ask_all" } }));
  }

  async ask({ level, u, v }: Points): Promise<Answered> {
    if (u.length > most) throw new Error(`${u.length} points at once: more than WebGPU takes`);
    const { device } = this;
    const size = 4 * u.length;
    const pairs = new Float32Array(2 * u.length);
    for (let k = 0; k < u.length; ++k) pairs.set([u[k]!, v[k]!], 2 * k);
    const given = device.createBuffer({ size: 8, usage: usage.uniform | usage.copyDst });
    const points = device.createBuffer({ size: 2 * size, usage: usage.storage | usage.copyDst });
    const answers = device.createBuffer({ size, usage: usage.storage | usage.copySrc });
    const read = device.createBuffer({ size, usage: usage.mapRead | usage.copyDst });
    device.queue.writeBuffer(given, 0, Uint32Array.of(level, u.length));
    device.queue.writeBuffer(points, 0, pairs);
    const commands = device.createCommandEncoder();
    const pass = commands.beginComputePass();
    pass.setPipeline(this.pipeline);
    const entries = [given, points, answers].map((buffer, binding) => ({ binding, resource: { buffer } }));
    pass.setBindGroup(0, device.createBindGroup({ layout: this.pipeline.getBindGroupLayout(0), entries }));
    pass.dispatchWorkgroups(Math.ceil(u.length / 64));
    pass.end();
    commands.copyBufferToBuffer(answers, 0, read, 0, size);
    device.queue.submit([commands.finish()]);
    const lost = device.lost.then(({ message }) => Promise.reject(new Error(`the graphics device was lost: ${message}`)));
    await Promise.race([read.mapAsync(1), lost]);
    const index = new Uint32Array(read.getMappedRange().slice(0));
    for (const buffer of [given, points, answers, read]) buffer.destroy();
    return { level, u, v, index };
  }

  end(): void {
    this.device.destroy();
  }
}
