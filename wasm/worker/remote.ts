/// <reference lib="esnext.disposable" preserve="true" />
import { frozenInfo, namesOf } from '../check.js';
import type { Curve } from '../curve.js';
import { KarcherError } from '../errors.js';
import type { FileInfo, FileOptions } from '../formats/index.js';
import type { Karcher } from '../karcher.js';
import type { Mesh } from '../mesh.js';
import { checkLongWork } from '../options.js';
import type { LongWorkOptions, MeshInfo, PolylineOptions } from '../types.js';
import type { ClassNames } from './protocol.js';

/** A sender of calls to the worker. A call runs a method of an object there, or of the engine. */
interface Caller {
  call(
    name: string,
    args: readonly unknown[],
    of?: object,
    work?: LongWorkOptions,
  ): Promise<unknown>;
}

/**
 * The type of a value on this side. Meshes and curves stay in the worker, and their types here
 * have remote methods.
 */
type Remote<Value> = Value extends Mesh
  ? RemoteMesh
  : Value extends Curve
    ? RemoteCurve
    : Value extends Curve[]
      ? RemoteCurve[]
      : Value;

type RemoteArgs<Args extends unknown[]> = { [Index in keyof Args]: Remote<Args[Index]> };

/** The methods of a class as promises. Each takes a signal and progress after its last argument. */
type Remotely<Class, Name extends keyof Class> = {
  [Method in Name]: Class[Method] extends (...args: infer Args) => infer Result
    ? (...args: [...RemoteArgs<Args>, work?: LongWorkOptions]) => Promise<Remote<Awaited<Result>>>
    : never;
};

type MethodsOf<Class> = {
  [Name in keyof Class]: Class[Name] extends (...args: never[]) => unknown ? Name : never;
}[keyof Class & string];

/** The properties of a class, as promises. */
type RemoteFacts<Class, Name extends keyof Class> = {
  readonly [Fact in Name]: Promise<Class[Fact]>;
};

interface Polyline {
  polyline(options?: { bits?: 32 }): Promise<Float32Array>;
  polyline(options: { bits: 64 }): Promise<Float64Array>;
  polyline(options?: PolylineOptions): Promise<Float32Array | Float64Array>;
}

type CurveMethod = Exclude<MethodsOf<Curve>, 'edits'>;
type CurveFact = Exclude<keyof Curve & string, MethodsOf<Curve>>;

/** A curve in a worker: the methods of `Curve`, and its properties as promises. */
export type RemoteCurve = Remotely<Curve, Exclude<CurveMethod, 'polyline'>> &
  RemoteFacts<Curve, CurveFact> &
  Polyline &
  Disposable;

/** A mesh in a worker: the methods of `Mesh`. */
export type RemoteMesh = Remotely<Mesh, MethodsOf<Mesh>> &
  Disposable & { readonly info: Readonly<MeshInfo> };

/** An engine in a worker, without the client that calls it. */
export type RemoteEngine = Remotely<Karcher, MethodsOf<Karcher>> &
  Disposable & {
    /** `meshFromFile` of `karcher/formats`, executed in the worker, with progress and a signal. */
    meshFromFile(
      bytes: Uint8Array,
      options?: FileOptions,
    ): Promise<{ mesh: RemoteMesh; file: FileInfo }>;
    dispose(): void;
  };

const karcherMethods = namesOf<Record<MethodsOf<Karcher> | 'meshFromFile', true>>({
  meshFromFile: true,
  meshFromObj: true,
  meshFromArrays: true,
  meshFromPolygons: true,
  shape: true,
  allocatedBytes: true,
});

type Call = (...args: unknown[]) => Promise<unknown>;

/** Methods that take progress and a signal themselves, and report more progress. */
const longMethods: readonly string[] = ['prepare', 'meshFromFile', 'cut'];
const workNames = namesOf<LongWorkOptions>({ progress: true, signal: true });

/** Whether an argument has only progress and a signal. */
function isWork(value: unknown): value is LongWorkOptions {
  if (typeof value !== 'object' || value === null) return false;
  const names = Object.keys(value);
  return names.length > 0 && names.every((name) => workNames.includes(name));
}

/** An object whose methods call those of `object` in the worker, or those of the engine there. */
function calling(client: Caller, names: readonly string[], object?: object) {
  const callOf = (name: string): Call => {
    if (longMethods.includes(name)) return (...args) => client.call(name, args, object);
    return async (...args) => {
      const work = args.at(-1);
      if (!isWork(work)) return client.call(name, args, object);
      checkLongWork(work);
      return client.call(name, args.slice(0, -1), object, work);
    };
  };
  return Object.fromEntries(names.map((name): [string, Call] => [name, callOf(name)]));
}

/** A call that rejects if its first argument, the value of a curve, has a basis. */
const withoutBasis =
  (call: Call): Call =>
  (...args) => {
    const { basis } = (args[0] ?? {}) as { basis?: unknown };
    if (basis === undefined) return call(...args);
    const sentence = 'a basis is a function, which cannot be sent to a worker';
    return Promise.reject(new KarcherError('badArgument', sentence));
  };

/** Gives an object the method for `using`, if the language supports it. */
function withDispose<Item extends { dispose(): void | Promise<void> }>(item: Item): Item {
  if (typeof Symbol.dispose !== 'symbol') return item;
  const value = () => {
    // A worker that has ended has no memory to free.
    Promise.resolve(item.dispose()).catch(() => {});
  };
  return Object.defineProperty(item, Symbol.dispose, { value });
}

export function remoteCurve(client: Caller, { methods, facts }: ClassNames): RemoteCurve {
  const curve = {};
  const calls = calling(client, methods, curve);
  const set = withoutBasis(calls.set!);
  // The properties are not enumerable, so that a copy or a print of a curve makes no call.
  for (const name of facts) {
    Object.defineProperty(curve, name, { get: () => client.call(name, [], curve) });
  }
  return withDispose(Object.assign(curve, calls, { set }) as unknown as RemoteCurve);
}

export function remoteMesh(
  client: Caller,
  { methods }: ClassNames,
  info: Readonly<MeshInfo>,
): RemoteMesh {
  const mesh = { info: frozenInfo(info) };
  const calls = calling(client, methods, mesh);
  const curve = withoutBasis(calls.curve!);
  return withDispose(Object.assign(mesh, calls, { curve }) as unknown as RemoteMesh);
}

export function remoteKarcher<Client extends Caller & { dispose(): void }>(
  client: Client,
): RemoteEngine & { readonly client: Client } {
  const own = { client, dispose: () => client.dispose() };
  const calls = calling(client, karcherMethods) as unknown as RemoteEngine;
  return withDispose({ ...calls, ...own });
}
