/**
 * Karcher with React and react-three-fiber: hooks that create surfaces and curves and free them.
 */
import { useThree } from '@react-three/fiber';
import { useEffect, useRef, useState } from 'react';
import type { BufferGeometry } from 'three';
import { CurveDrag } from '../three/curve_drag.js';
import { type AnyMesh, type Surface, surfaceFromGeometry } from '../three/surface.js';
import { SurfaceCurve } from '../three/surface_curve.js';
import type { CurveOptions, MeshOptions } from '../types.js';
import { releaseEngine, takeEngine } from './engines.js';
import { isSameValue } from './same_value.js';
import type {
  AnyKarcher,
  CurveHookOptions,
  DragHookOptions,
  EngineHookOptions,
  FailureOptions,
  SurfaceHookOptions,
} from './types.js';

export { KarcherError } from '../errors.js';
export type * from './types.js';

/** The newest value, for effects that must not run again when it changes. */
function useNewest<Value>(value: Value): { readonly current: Value } {
  const newest = useRef(value);
  useEffect(() => {
    newest.current = value;
  });
  return newest;
}

/** Passes errors to `onError`, or throws them while the component renders. */
function useFailure(onError: FailureOptions['onError']): (error: unknown) => void {
  const [failure, setFailure] = useState<{ error: unknown } | undefined>();
  const told = useNewest(onError);
  const [fail] = useState(() => (error: unknown) => {
    if (told.current) told.current(error);
    else setFailure({ error });
  });
  if (failure) throw failure.error;
  return fail;
}

/**
 * The engine; undefined until it is loaded. All components share one engine in the page and one in
 * a worker. An engine ends when the last component that uses it unmounts.
 */
export function useKarcher({
  worker = false,
  onError,
}: EngineHookOptions & FailureOptions = {}): AnyKarcher | undefined {
  const [loaded, setLoaded] = useState<{ engine: AnyKarcher; worker: boolean } | undefined>();
  const fail = useFailure(onError);
  useEffect(() => {
    let isMounted = true;
    const shared = takeEngine(worker);
    shared.engine.then(
      (engine) => isMounted && setLoaded({ engine, worker }),
      (error) => isMounted && fail(error),
    );
    return () => {
      isMounted = false;
      setLoaded(undefined);
      releaseEngine(shared);
    };
  }, [worker, fail]);
  return loaded?.worker === worker ? loaded.engine : undefined;
}

/**
 * The surface of a geometry, as `surfaceFromGeometry` returns it; undefined until it exists, and
 * without a geometry. Another geometry gets another surface. When the component unmounts, the hook
 * frees the memory of the mesh.
 */
export function useSurface(
  geometry: BufferGeometry | undefined,
  { worker, onError, repair, weld }: SurfaceHookOptions = {},
): Surface<AnyMesh> | undefined {
  const karcher = useKarcher({ worker, onError });
  const fail = useFailure(onError);
  const [made, setMade] = useState<{ surface: Surface<AnyMesh>; of: BufferGeometry } | undefined>();
  useEffect(() => {
    if (!karcher || !geometry) return;
    let isMounted = true;
    let surface: Surface<AnyMesh> | undefined;
    const make = async () => {
      const options: MeshOptions = { repair, weld };
      // An engine in the page returns the surface itself, one in a worker a promise.
      surface = await surfaceFromGeometry(karcher as never, geometry, options);
      if (isMounted) setMade({ surface, of: geometry });
      else release(surface);
    };
    make().catch((error) => isMounted && fail(error));
    return () => {
      isMounted = false;
      setMade(undefined);
      if (surface) release(surface);
    };
  }, [karcher, geometry, repair, weld, fail]);
  return made && made.of === geometry ? made.surface : undefined;
}

function release({ mesh }: Surface<AnyMesh>): void {
  // A worker that has ended has no memory to free.
  Promise.resolve(mesh.dispose()).catch(() => {});
}

/**
 * A curve on a surface, as an object of three.js; undefined until a surface and options exist. Put
 * it into the scene as a child of the object that draws the surface, `<primitive object={curve}
 * />`. Options that differ from those of the previous render change the curve. Equal options leave
 * it as it is, even if the user has dragged its points since. A function, such as `basis`, is equal
 * only to itself: define it outside the component.
 */
export function useSurfaceCurve(
  surface: Surface<AnyMesh> | undefined,
  options: CurveOptions | undefined,
  { onChange, onError, width, color }: CurveHookOptions = {},
): SurfaceCurve | undefined {
  const fail = useFailure(onError);
  const told = useNewest(onChange);
  const [made, setMade] = useState<{ curve: SurfaceCurve; given: CurveOptions } | undefined>();
  const hasOptions = options !== undefined;
  const newest = useNewest(options);
  const look = useNewest({ width, color });
  useEffect(() => {
    if (!surface || !hasOptions) return;
    // The effects of one component run in order, so that the newest options are known.
    const first = newest.current!;
    const curve = new SurfaceCurve(surface, first, look.current);
    let isMounted = true;
    curve.addEventListener('change', ({ value, view }) => told.current?.(value, view));
    curve.ready.catch((error) => isMounted && fail(error));
    setMade({ curve, given: first });
    return () => {
      isMounted = false;
      setMade(undefined);
      const { material } = curve;
      curve.dispose();
      material.dispose();
    };
  }, [surface, hasOptions, fail, newest, look, told]);
  useEffect(() => {
    if (!made || !options || isSameValue(made.given, options)) return;
    // The effect above has disposed of a curve on another surface; its successor has these options.
    if (made.curve.surface !== surface) return;
    made.given = options;
    made.curve.set(options).catch(fail);
  });
  useEffect(() => {
    if (!made) return;
    const { material } = made.curve;
    if (width !== undefined) material.linewidth = width;
    if (color !== undefined) material.color.set(color);
  }, [made, width, color]);
  return made?.curve.surface === surface ? made?.curve : undefined;
}

/**
 * Lets the user drag the control points of a curve on the canvas. The curve lies in the scene as a
 * child of the mesh that draws its surface.
 */
export function useCurveDrag(
  curve: SurfaceCurve | undefined,
  { reach, onError }: DragHookOptions = {},
): void {
  const camera = useThree((state) => state.camera);
  const element = useThree((state) => state.gl.domElement);
  const told = useNewest(onError);
  useEffect(() => {
    // React puts children into the scene before effects run.
    if (!curve?.parent) return;
    const options = reach === undefined ? {} : { reach };
    const drag = new CurveDrag(curve, curve.parent, camera, element, options);
    drag.onError = (error) => told.current?.(error);
    return () => drag.dispose();
  }, [curve, camera, element, reach, told]);
}
