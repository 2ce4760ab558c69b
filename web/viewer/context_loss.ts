import { Mesh, type Object3D } from 'three';

/**
 * Goes on when the browser takes a canvas's drawing context away and gives it back empty, as after a
 * fault of the graphics driver. What three.js has made for the scenes is given up while there is no
 * context: it would be deleted later otherwise, in one that it does not belong to.
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
