// A curve to drag over your own GLB, with React and react-three-fiber.
import { Canvas, useLoader } from '@react-three/fiber';
import { useCurveDrag, useSurface, useSurfaceCurve } from 'karcher/react';
import { createRoot } from 'react-dom/client';
import { Mesh } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

function Model() {
  const { nodes } = useLoader(GLTFLoader, 'model.glb');
  const model = Object.values(nodes).find((node) => node instanceof Mesh)!;
  const { count } = model.geometry.attributes.position!;
  const points = [0.1813, 0.8966, 0.2099].map((part) => ({ vertex: Math.floor(part * count) }));
  const surface = useSurface(model.geometry);
  const curve = useSurfaceCurve(surface, { kind: 'catmullrom', points });
  useCurveDrag(curve);
  return (
    <mesh geometry={model.geometry} material={model.material}>
      {curve && <primitive object={curve} />}
    </mesh>
  );
}

createRoot(document.getElementById('root')!).render(
  <Canvas camera={{ position: [0, 0, 3] }}>
    <hemisphereLight intensity={3} groundColor="#888" />
    <Model />
  </Canvas>,
);
