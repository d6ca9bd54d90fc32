// The camera in the hands of whoever looks: round the target, or free flight. Vectors are arrays of three.

const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.sqrt(dot(a, a));
const unit = (a) => a.map((x) => x / length(a));

/** v turned about the unit vector `axis` by `angle` in radians.   Rodrigues */
function turned(v, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  const along = dot(axis, v) * (1 - c), side = cross(axis, v);
  return v.map((x, i) => c * x + s * side[i] + along * axis[i]);
}

const SLOWEST = 1e-3, FASTEST = 1e3, STEEPEST = 0.999;

export class CameraHand {
  constructor(pose) {
    this.speed = 1; // distances to the target in a second, in flight
    this.flies = false;
    this.begin(pose);
  }

  /** The pose of the scene file: where R goes back to. */
  begin(pose) {
    this.home = pose;
    this.reset();
  }

  reset() {
    this.position = [...this.home.position];
    this.target = [...this.home.target];
    this.up = unit(this.home.up);
    this.moved = false;
    this.reach = length(add(this.target, this.position, -1)); // the unit of all ways
  }

  /** Nine numbers for the module; those of the file to the last bit while nothing was moved. */
  pose() {
    const { position, target, up } = this.moved ? this : this.home;
    return [...position, ...target, ...up];
  }

  /** Turn by these angles in radians: round the target, or in flight the way that one looks. */
  turn(right, down) {
    const arm = this.flies ? add(this.target, this.position, -1) : add(this.position, this.target, -1);
    const side = unit(cross(arm, this.up));
    let next = turned(arm, this.up, -right);
    const tilted = turned(arm, side, this.flies ? -down : down);
    if (Math.abs(dot(unit(tilted), this.up)) < STEEPEST) next = turned(tilted, this.up, -right);
    if (this.flies) this.target = add(this.position, next);
    else this.position = add(this.target, next);
    this.moved = true;
  }

  /** Nearer to the target by this factor; in flight the wheel sets the speed. */
  wheel(factor) {
    if (this.flies) {
      this.speed = Math.min(FASTEST, Math.max(SLOWEST, this.speed / factor));
      return;
    }
    this.position = add(this.target, add(this.position, this.target, -1).map((x) => x * factor));
    this.moved = true;
  }

  /** Move both ends: ways to the right, up and ahead, in the unit of `reach`. */
  move(right, up, ahead) {
    const forward = unit(add(this.target, this.position, -1));
    const side = unit(cross(forward, this.up));
    for (const [way, direction] of [[right, side], [up, this.up], [ahead, forward]]) {
      this.position = add(this.position, direction, way * this.reach);
      this.target = add(this.target, direction, way * this.reach);
    }
    this.moved = true;
  }

  /** As changes of the scene file. */
  overrides() {
    if (!this.moved) return [];
    const list = (v) => `[${v.map((x) => Number(x.toPrecision(9)))}]`;
    return ['camera.orbit=0', `camera.position=${list(this.position)}`, `camera.target=${list(this.target)}`,
      `camera.up=${list(this.up)}`];
  }
}
