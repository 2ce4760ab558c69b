import { type Camera, type Scene, WebGLRenderer } from 'three';
import { outliveContextLoss } from '../../viewer/context_loss';

/**
 * One WebGL context for all panels, since a page may have only a few. It draws each panel and
 * copies the image to the panel's canvas.
 */
export class SharedRenderer {
  readonly #renderer: WebGLRenderer;
  readonly #scenes = new Set<Scene>();
  readonly #onRestored: (() => void)[] = [];
  #width = 0;
  #height = 0;

  /** Throws if WebGL 2 is missing. */
  constructor({ antialias }: { antialias: boolean }) {
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('webgl2', { alpha: true, antialias });
    if (!context) {
      throw new Error(
        'WebGL 2, which draws the figures, is missing or switched off. Check that graphics acceleration is allowed in the settings.',
      );
    }
    this.#renderer = new WebGLRenderer({ canvas, context });
    outliveContextLoss(
      canvas,
      () => this.#scenes,
      () => {
        for (const listener of this.#onRestored) listener();
      },
    );
  }

  /** Adds a listener, which draws again when the lost context is back. */
  onRestored(listener: () => void): void {
    this.#onRestored.push(listener);
  }

  /**
   * Draws a scene into a canvas of the given size in CSS pixels. While the context is lost, the
   * canvas keeps its image.
   */
  draw(scene: Scene, camera: Camera, canvas: HTMLCanvasElement, width: number, height: number) {
    this.#scenes.add(scene);
    if (this.#renderer.getContext().isContextLost()) return;
    const ratio = Math.min(2, devicePixelRatio);
    if (width > this.#width || height > this.#height || this.#renderer.getPixelRatio() !== ratio) {
      this.#width = Math.max(width, this.#width);
      this.#height = Math.max(height, this.#height);
      this.#renderer.setPixelRatio(ratio);
      this.#renderer.setSize(this.#width, this.#height, false);
    }
    const [pixelWidth, pixelHeight] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== pixelWidth) canvas.width = pixelWidth;
    if (canvas.height !== pixelHeight) canvas.height = pixelHeight;
    this.#renderer.setViewport(0, 0, width, height);
    this.#renderer.setScissor(0, 0, width, height);
    this.#renderer.setScissorTest(true);
    this.#renderer.render(scene, camera);
    const context = canvas.getContext('2d')!;
    context.clearRect(0, 0, pixelWidth, pixelHeight);
    const source = this.#renderer.domElement;
    // The viewport is the lower left part of the drawing buffer.
    const top = source.height - pixelHeight;
    context.drawImage(source, 0, top, pixelWidth, pixelHeight, 0, 0, pixelWidth, pixelHeight);
  }
}
