/**
 * A class of the platform by its name, as the project's type libraries describe it. If a project
 * has neither `DOM` nor the types of Node, the part that this package uses replaces it, so that the
 * package's types need neither.
 */
type Platform<Name extends string, Used> = typeof globalThis extends {
  [name in Name]: { prototype: infer Known };
}
  ? Known
  : Used;

export type AddressObject = Platform<'URL', { readonly href: string }>;

export type FetchedResponse = Platform<
  'Response',
  { readonly ok: boolean; readonly status: number; arrayBuffer(): Promise<ArrayBuffer> }
>;

export type StopSignal = Platform<
  'AbortSignal',
  {
    readonly aborted: boolean;
    readonly reason: unknown;
    addEventListener(type: 'abort', listener: () => void): void;
    removeEventListener(type: 'abort', listener: () => void): void;
  }
>;

/** A compiled module of WebAssembly; its class has no members. */
export type CompiledModule = typeof globalThis extends {
  WebAssembly: { Module: { prototype: infer Known } };
}
  ? Known
  : object;
