import { Mesh, type Object3D } from 'three';

/**
 * Recovers from the loss of a canvas's drawing context. The browser takes it away and returns it
 * empty, for example after a fault of the graphics driver. The function disposes of the scenes'
 * resources during the loss: three.js would otherwise delete them later in the new context, to
 * which they do not belong.
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
