// Distances from a point as colors of the vertices.
import { load } from 'karcher';
import { geometryOf, surfaceFromMesh, vertexColors } from 'karcher/three';
import { Mesh, MeshBasicMaterial, PerspectiveCamera, Scene, WebGLRenderer } from 'three';

const karcher = await load();
const surface = surfaceFromMesh(karcher.shape('knot', 20_000));
const geometry = geometryOf(surface);
geometry.setAttribute('color', vertexColors(surface.mesh.distance({ vertex: 0 })));

const scene = new Scene();
scene.add(new Mesh(geometry, new MeshBasicMaterial({ vertexColors: true })));
const camera = new PerspectiveCamera(50, innerWidth / innerHeight, 0.01, 100);
camera.position.z = 2 * surface.diagonal;
const renderer = new WebGLRenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
renderer.render(scene, camera);
