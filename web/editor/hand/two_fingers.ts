/** The thing that a finger holds. */
export interface Held {
  /** The finger that moves a handle, by its pointer's number; null without one. */
  readonly heldBy: number | null;
  /** Takes back what was begun. */
  letGo(): void;
}

/**
 * Two fingers on the stage always mean the view: where the first one has hold of a handle when the
 * second comes down, its drag is taken back, and the view goes on with both. Answers whether there are
 * several fingers down.
 */
export function twoFingersMeanTheView(stage: HTMLElement, held: Held): () => boolean {
  const fingers = new Map<number, PointerEvent>();
  const isTouch = (event: PointerEvent) => event.pointerType === 'touch';
  // This comes before what the finger touches hears of it.
  const heard = { capture: true };
  stage.addEventListener(
    'pointerdown',
    (event) => {
      if (!isTouch(event)) return;
      const first = held.heldBy === null ? undefined : fingers.get(held.heldBy);
      fingers.set(event.pointerId, event);
      if (!first || first.pointerId === event.pointerId) return;
      held.letGo();
      // The view also receives the first finger, which came down on the handle.
      const { pointerId, clientX, clientY, isPrimary } = first;
      const again = { pointerId, clientX, clientY, isPrimary, pointerType: 'touch', buttons: 1 };
      stage.dispatchEvent(new PointerEvent('pointerdown', { ...again, bubbles: true }));
    },
    heard,
  );
  window.addEventListener(
    'pointermove',
    (event) => {
      if (fingers.has(event.pointerId)) fingers.set(event.pointerId, event);
    },
    heard,
  );
  for (const type of ['pointerup', 'pointercancel'] as const) {
    window.addEventListener(type, (event) => fingers.delete(event.pointerId), heard);
  }
  return () => fingers.size > 1;
}
