// A curve to drag over your own GLB. The lines between the two marks use Karcher.
import { load } from 'karcher';
import { CurveDrag, SurfaceCurve, surfaceFromGeometry } from 'karcher/three';
import {
  HemisphereLight,
  Mesh,
  type Object3D,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const { scene: model } = await new GLTFLoader().loadAsync('model.glb');
const scene = new Scene().add(model, new HemisphereLight(0xffffff, 0x888888, 3));
const camera = new PerspectiveCamera(50, innerWidth / innerHeight, 0.01, 100);
camera.position.z = 3;
const renderer = new WebGLRenderer({ antialias: true, alpha: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
new OrbitControls(camera, renderer.domElement);

// Karcher from here
const meshes: Mesh[] = [];
model.traverse((object: Object3D) => {
  if (object instanceof Mesh) meshes.push(object);
});
const object = meshes[0]!;
const surface = surfaceFromGeometry(await load(), object.geometry);
const places = [-0.4, 0, 0.3, 0.6].map((x, i) => [x, i % 2 ? 0.1 : -0.3, 1] as const);
const points = places.map((place) => surface.mesh.nearestPoint(place).point);
const curve = new SurfaceCurve(surface, { kind: 'catmullrom', points });
object.add(curve);
new CurveDrag(curve, object, camera, renderer.domElement);
// to here

renderer.setAnimationLoop(() => renderer.render(scene, camera));
