// A picture laid round a point of the surface by the log map, as texture coordinates.
import { load } from 'karcher';
import { decalGeometry, geometryOf, surfaceFromMesh } from 'karcher/three';
import {
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  TextureLoader,
  WebGLRenderer,
} from 'three';

const karcher = await load();
const surface = surfaceFromMesh(karcher.shape('torus', 20_000));
const { point } = surface.mesh.nearestPoint([0, 0, surface.diagonal]);
const geometry = geometryOf(surface);
const { vectors } = surface.mesh.logMap(point);
const decal = decalGeometry(surface, vectors, surface.frame(point), 0.1 * surface.diagonal);

const scene = new Scene();
const map = await new TextureLoader().loadAsync('decal.png');
scene.add(
  new Mesh(
    geometry,
    new MeshBasicMaterial({ color: 0xdddddd, polygonOffset: true, polygonOffsetFactor: 1 }),
  ),
);
scene.add(new Mesh(decal, new MeshBasicMaterial({ map, transparent: true })));
const camera = new PerspectiveCamera(50, innerWidth / innerHeight, 0.01, 100);
camera.position.z = 2 * surface.diagonal;
const renderer = new WebGLRenderer({ antialias: true, alpha: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
renderer.render(scene, camera);
