// A page with a curve by the hooks of `karcher/react`, which react.test.mjs mounts, drags and unmounts.
import { Canvas, useThree } from '@react-three/fiber';
import type { CurveOptions } from 'karcher';
import { useCurveDrag, useKarcher, useSurface, useSurfaceCurve } from 'karcher/react';
import type { SurfaceCurve } from 'karcher/three';
import { Component, type ReactNode, StrictMode, useMemo } from 'react';
import { createRoot } from 'react-dom/client';
import { type Camera, TorusGeometry, Vector3 } from 'three';

interface Shown {
  options: CurveOptions;
  /** Whether each render has another function as basis. */
  inline?: boolean;
  worker: boolean;
  look?: { width: number; color: string };
  /** The number of segments round the torus: another number is another geometry. */
  segments: number;
  /** Another number mounts the model anew. With a number, failures go to `onError`. */
  attempt?: number;
}

const seen = {
  curve: undefined as SurfaceCurve | undefined,
  camera: undefined as Camera | undefined,
  changes: 0,
  value: undefined as CurveOptions | undefined,
  made: new Set<SurfaceCurve>(),
  bytes: () => -1,
  /** The bytes of the engine's memory before its first use. */
  fresh: -1,
  message: '',
};

function Model({ options, inline, worker, segments, look, attempt }: Shown) {
  const geometry = useMemo(() => new TorusGeometry(1, 0.4, 16, segments), [segments]);
  const tell = (error: unknown) => {
    seen.message = (error as Error).message;
  };
  const onError = attempt === undefined ? undefined : tell;
  const karcher = useKarcher({ worker, onError });
  const surface = useSurface(geometry, { worker, onError });
  const onChange = (value: CurveOptions) => {
    seen.changes++;
    seen.value = value;
  };
  const basis = (t: number) => [1 - t, t];
  const given = inline ? { ...options, basis } : options;
  const curve = useSurfaceCurve(surface, given, { onChange, ...look });
  useCurveDrag(curve);
  seen.camera = useThree((state) => state.camera);
  seen.curve = curve;
  if (curve) seen.made.add(curve);
  if (karcher && 'allocatedBytes' in karcher) {
    seen.bytes = () => karcher.allocatedBytes() as number;
    if (seen.fresh < 0) seen.fresh = seen.bytes();
  }
  return (
    <mesh geometry={geometry}>
      <meshBasicMaterial polygonOffset polygonOffsetFactor={1} />
      {curve && <primitive object={curve} />}
    </mesh>
  );
}

class Boundary extends Component<{ children: ReactNode }, { message: string }> {
  override state = { message: '' };
  static getDerivedStateFromError = (error: Error) => ({ message: error.message });
  override componentDidCatch(error: Error) {
    seen.message = error.message;
  }
  override render() {
    return this.state.message ? null : this.props.children;
  }
}

const root = createRoot(document.getElementById('root')!);

const page = {
  seen,
  show: (shown: Shown) =>
    root.render(
      <StrictMode>
        <Canvas camera={{ position: [0, 0, 3.2] }}>
          <Boundary key={JSON.stringify([shown.worker, shown.attempt])}>
            <Model {...shown} />
          </Boundary>
        </Canvas>
      </StrictMode>,
    ),
  unmount: () => root.render(null),
  /** The place of a control point in the window, in pixels. */
  at: (number: number) => {
    const { curve, camera } = seen;
    const place = curve!.surface.position(curve!.value.points[number]!, new Vector3());
    place.applyMatrix4(curve!.matrixWorld).project(camera!);
    return [200 * (1 + place.x), 200 * (1 - place.y)] as const;
  },
};
export type ReactPage = typeof page;
Object.assign(window, { page });
