import { Mesh, type Object3D } from 'three';

/**
 * Survives the loss of a canvas's drawing context: the browser takes it away and gives it back empty, such as after a
 * fault of the graphics driver. Resources of three.js for the scenes are given up while there is no context; later
 * they would be deleted in a context that they do not belong to.
 */
export function outliveContextLoss(
  canvas: HTMLCanvasElement,
  scenes: () => Iterable<Object3D>,
  redraw: () => void,
): void {
  canvas.addEventListener('webglcontextlost', () => {
    for (const scene of scenes()) scene.traverse(giveUp);
  });
  canvas.addEventListener('webglcontextrestored', redraw);
}

function giveUp(object: Object3D): void {
  if (!(object instanceof Mesh)) return;
  object.geometry.dispose();
  for (const material of [object.material].flat()) material.dispose();
}
