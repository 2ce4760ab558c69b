/** A gesture that one finger holds, such as the drag of a handle. */
export interface Held {
  /** The pointer id of the finger that holds the gesture; null if none does. */
  readonly heldBy: number | null;
  /** Undoes the gesture. */
  letGo(): void;
}

/**
 * Two fingers on the stage always move the view. If the first finger drags a handle, the second one
 * undoes this drag, and the view takes both. The returned function tells whether several fingers
 * are down.
 */
export function twoFingersMeanTheView(stage: HTMLElement, held: Held): () => boolean {
  const fingers = new Map<number, PointerEvent>();
  const isTouch = (event: PointerEvent) => event.pointerType === 'touch';
  // Capturing listeners run before those of the touched element.
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
