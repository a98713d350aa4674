/** A library under test as a script: functions named as the entry points of mmverify_subject.h that take numbers. */
export interface Subject {
  /** What --subject names. */
  path: string;
  name?: string;
  /** The highest level that it knows; 12 where it says nothing. */
  maxLevel?: number;
  /** The verdict's words about the numbers that it computes in; where there are none, binary64, as JavaScript has it. */
  arithmetic?: string;
  index_f32?(level: number, u: Float32Array, v: Float32Array, index: Uint32Array): void;
  index_f64?(level: number, u: Float64Array, v: Float64Array, index: Uint32Array): void;
  /** Six numbers for each index: u and v of three corners. */
  corners?(level: number, index: Uint32Array, corners: Float32Array): void;
  traverse_decide?(api: number, candidate: Uint32Array, geometry: Uint32Array, ray: Uint32Array, decision: Uint8Array): void;
  /** Others as the header has them: level, format where there is one, arrays of numbers, the array to answer in. */
  [entry: string]: unknown;
}

export interface RunOptions {
  /** Files that the program finds, by their absolute names. */
  files?: Record<string, Uint8Array | string>;
  /** Files whose contents are wanted when it has ended. */
  wanted?: string[];
  stdin?: string;
  /** A byte of standard input at a time, null at its end; in the place of `stdin`. */
  readStdin?: () => number | null;
  onStdout?: (bytes: Uint8Array) => void;
  onStderr?: (bytes: Uint8Array) => void;
  subject?: Subject;
  /** The compiled program, where it is not that of `compile()`. */
  module?: WebAssembly.Module | Promise<WebAssembly.Module>;
  /** Given emscripten's module before the program begins, for mounts. */
  mount?: (program: any) => void;
}

export interface Ended {
  /** 0 fine, 1 refuted, 2 usage, 3 incomplete, 4 environment. */
  code: number;
  stdout: string;
  stderr: string;
  files: Record<string, Uint8Array>;
}

export interface Answered<Result = any> {
  code: number;
  text: string;
  result: Result;
}

export function compile(source?: BufferSource | Promise<BufferSource>): Promise<WebAssembly.Module>;
export function run(args: readonly string[], options?: RunOptions): Promise<Ended>;
export function prove(what?: readonly string[], options?: RunOptions & { levels?: string; mutants?: boolean }): Promise<Answered>;
export function validate(bytes: Uint8Array, name?: string, options?: RunOptions): Promise<Answered>;
export function scene(bytes: Uint8Array, name?: string, options?: RunOptions & { arguments?: string[] }): Promise<Answered>;
