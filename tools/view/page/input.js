// Mouse, touch and keys become turns and ways of the camera.

const TURN = 0.006; // radians a pixel
const KEY_TURN = 1.4, KEY_WAY = 0.7; // radians and reaches a second
const CLICK = 4; // pixels: less is a click and no drag
const HELD = new Set(['w', 'a', 's', 'd', 'q', 'e', 'arrowleft', 'arrowright', 'arrowup', 'arrowdown']);

/** `actions`: changed(), clicked(event), key(name) for single keys; the canvas hears everything else. */
export function listen(canvas, hand, actions) {
  const fingers = new Map();
  const held = new Set();
  let dragged = 0, spread = 0;

  canvas.addEventListener('pointerdown', (event) => {
    canvas.focus({ preventScroll: true });
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (!document.pointerLockElement) canvas.setPointerCapture(event.pointerId);
    dragged = fingers.size > 1 ? CLICK : 0;
    spread = 0;
  });
  const lift = (event) => {
    if (!fingers.delete(event.pointerId) || event.type === 'pointercancel') return;
    if (dragged < CLICK && fingers.size === 0) actions.clicked(event);
  };
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);

  canvas.addEventListener('pointermove', (event) => {
    const before = fingers.get(event.pointerId);
    if (document.pointerLockElement === canvas) {
      turn(event.movementX, event.movementY, event);
    } else if (before) {
      const dx = event.clientX - before[0], dy = event.clientY - before[1];
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      if (fingers.size > 1) return pinch(dx, dy);
      turn(dx, dy, event);
    }
  });

  function turn(dx, dy, event) {
    dragged += Math.abs(dx) + Math.abs(dy);
    if (event.shiftKey || event.buttons === 2 || event.buttons === 4) hand.move(-dx * TURN / 4, dy * TURN / 4, 0);
    else hand.turn(dx * TURN, dy * TURN);
    actions.changed();
  }

  /** Two fingers: apart is nearer, both along is a way. */
  function pinch(dx, dy) {
    const [a, b] = [...fingers.values()];
    const now = Math.hypot(a[0] - b[0], a[1] - b[1]);
    if (spread > 0 && now > 0) hand.wheel(spread / now);
    spread = now;
    hand.move(-dx * TURN / 8, dy * TURN / 8, 0);
    actions.changed();
  }

  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    if (window !== top && document.activeElement !== canvas) return; // beside a text the wheel scrolls until one clicks
    event.preventDefault();
    hand.wheel(Math.exp(0.001 * Math.max(-300, Math.min(300, event.deltaY))));
    actions.changed();
  }, { passive: false });

  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.toLowerCase();
    const isCross = event.shiftKey && key.startsWith('arrow');
    if (isCross || !HELD.has(key)) {
      if (actions.key(key, isCross)) event.preventDefault();
      return;
    }
    event.preventDefault();
    held.add(key);
    actions.changed();
  });
  canvas.addEventListener('keyup', (event) => held.delete(event.key.toLowerCase()));
  for (const [where, what] of [[canvas, 'blur'], [window, 'blur'], [document, 'visibilitychange']]) {
    where.addEventListener(what, () => { held.clear(); fingers.clear(); });
  }

  /** What held keys do in so many seconds; true while any is held. */
  return function step(seconds) {
    if (held.size === 0) return false;
    const on = (plus, minus) => (held.has(plus) ? 1 : 0) - (held.has(minus) ? 1 : 0);
    const way = KEY_WAY * hand.speed * seconds;
    hand.move(way * on('d', 'a'), way * on('e', 'q'), way * on('w', 's'));
    const right = on('arrowright', 'arrowleft'), down = on('arrowdown', 'arrowup');
    if (right || down) hand.turn(KEY_TURN * seconds * right, KEY_TURN * seconds * down);
    return true;
  };
}
