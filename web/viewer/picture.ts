import type { WebGLRenderer } from 'three';

/**
 * What `render` draws as a PNG, of so many pixels for each of CSS; see-through where nothing is drawn
 * and no background is given. The renderer's canvas holds the picture afterwards: it wants another frame.
 */
export function pictureOf(
  renderer: WebGLRenderer,
  render: () => void,
  { width, height }: { width: number; height: number },
  scale: number,
  background: string | null,
): Promise<Blob> {
  const ratio = renderer.getPixelRatio();
  const picture = new OffscreenCanvas(width * scale, height * scale);
  const context = picture.getContext('2d')!;
  if (background) {
    context.fillStyle = background;
    context.fillRect(0, 0, picture.width, picture.height);
  }
  renderer.setPixelRatio(scale);
  render();
  // What is drawn holds until this task ends.
  context.drawImage(renderer.domElement, 0, 0);
  renderer.setPixelRatio(ratio);
  return picture.convertToBlob({ type: 'image/png' });
}
