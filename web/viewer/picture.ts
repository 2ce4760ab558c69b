import type { WebGLRenderer } from 'three';

/**
 * A PNG of what `render` draws, with `scale` pixels for each CSS pixel. Without a background, the
 * picture is transparent around the drawing. Afterwards the renderer's canvas needs another frame.
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
  // The canvas keeps the picture until this task ends.
  context.drawImage(renderer.domElement, 0, 0);
  renderer.setPixelRatio(ratio);
  return picture.convertToBlob({ type: 'image/png' });
}
