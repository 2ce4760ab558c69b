/**
 * The type of a platform class's objects, as the project's type libraries declare it. Without `DOM`
 * and the types of Node, it is `Used`: only the members that this package uses. So the package's
 * types need neither library.
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
