// SPDX-License-Identifier: Apache-2.0
// Mouse, pen and fingers on a scene.

export interface HandEvents {
  turn: (azimuth: number, elevation: number) => void;  // by so many degrees
  zoom: (factor: number) => void;
}

const degrees_per_px = 0.4;

/**
 * The mouse turns while it is pressed. One finger turns to left and right, and the page scrolls up and down under it; two
 * turn in both directions and zoom. The wheel zooms with Ctrl, or when the scene has the focus. Ends with `signal`.
 */
export function watch_hands(frame: HTMLElement, events: HandEvents, signal: AbortSignal): void {
  const hands = new Map<number, { x: number; y: number }>();
  const apart = () => {
    const [a, b] = [...hands.values()];
    return a && b ? Math.max(20, Math.hypot(a.x - b.x, a.y - b.y)) : null;
  };
  frame.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && !event.metaKey && document.activeElement !== frame) return;
    event.preventDefault();
    events.zoom(event.deltaY > 0 ? 0.88 : 1.14);
  }, { signal, passive: false });
  frame.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'mouse' && event.button !== 0) return;
    hands.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }, { signal });
  // Of the window: a mouse that leaves the frame while it is pressed goes on turning.
  window.addEventListener('pointermove', (event) => {
    const before = hands.get(event.pointerId);
    if (!before) return;
    const was = apart();
    hands.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const is = apart();
    const share = hands.size > 1 ? 0.5 : 1;
    const [dx, dy] = [event.clientX - before.x, event.clientY - before.y];
    events.turn(-dx * degrees_per_px * share, event.pointerType === 'touch' && hands.size === 1 ? 0 : dy * degrees_per_px * share);
    if (was !== null && is !== null) events.zoom(is / was);
  }, { signal });
  for (const end of ['pointerup', 'pointercancel'] as const)
    window.addEventListener(end, (event) => hands.delete(event.pointerId), { signal });
}
