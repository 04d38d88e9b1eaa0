/** Turnable balls and ellipsoids in parallel projection: one ray for each pixel, no library and no graphics card. */

export type Vec = [number, number, number];

/** Rows of a rotation: from the body's axes to those of the screen (right, up, towards the reader). */
export type Turn = [Vec, Vec, Vec];

/** So many pixels in each direction have one ray: fewer while a hand moves the body. */
export const grainOf = ({ dragging }: { dragging: string | null }): number => (dragging === "body" ? 2 : 1);

export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const times = (s: number, a: Vec): Vec => [s * a[0], s * a[1], s * a[2]];
export const unit = (a: Vec): Vec => times(1 / Math.hypot(...a), a);
export const apply = (turn: Turn, v: Vec): Vec => [dot(turn[0], v), dot(turn[1], v), dot(turn[2], v)];
export const back = ([x, y, z]: Turn, v: Vec): Vec => [0, 1, 2].map((i) => x[i]! * v[0] + y[i]! * v[1] + z[i]! * v[2]) as Vec;

/** A rotation by an angle about a screen axis, after another turn. */
export function turned(turn: Turn, axis: Vec, angle: number): Turn {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const spin = (v: Vec): Vec => {
    const w = cross(axis, v);
    const along = dot(axis, v) * (1 - c);
    return [0, 1, 2].map((i) => c * v[i]! + s * w[i]! + along * axis[i]!) as Vec;
  };
  const columns = [0, 1, 2].map((i) => spin([turn[0][i]!, turn[1][i]!, turn[2][i]!]));
  return [0, 1, 2].map((row) => columns.map((column) => column[row]!)) as Turn;
}

/** Looking at a point of the ball, with another direction upwards. */
export function lookingAt(front: Vec, up: Vec): Turn {
  const z = unit(front);
  const aside = Math.hypot(...cross(up, z)) > 1e-9 ? cross(up, z) : cross([0.6, 0.8, 0], z);
  const x = unit(aside);
  return [x, cross(z, x), z];
}

/** Rotation of a quaternion (w, x, y, z), which takes vectors of the body to space. */
export function rotation(w: number, x: number, y: number, z: number): Turn {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/** first after second. */
export const composed = (first: Turn, second: Turn): Turn => {
  const columns = [0, 1, 2].map((i) => apply(first, [second[0][i]!, second[1][i]!, second[2][i]!]));
  return [0, 1, 2].map((row) => columns.map((column) => column[row]!)) as Turn;
};

/** Fills an image: `shade` gets a direction (in the body's axes) and where its pixel is, and returns red, green, blue, alpha. */
export function castBall(image: ImageData, radius: number, turn: Turn, shade: (direction: Vec, light: number, out: Uint8ClampedArray, at: number) => void): void {
  const { width, height, data } = image;
  const [X, Y, Z] = turn;
  const direction: Vec = [0, 0, 0];
  for (let row = 0; row < height; row++) {
    const y = (height / 2 - row - 0.5) / radius;
    for (let column = 0; column < width; column++) {
      const x = (column + 0.5 - width / 2) / radius;
      const beyond = 1 - x * x - y * y;
      const at = 4 * (row * width + column);
      if (beyond < 0) {
        data[at + 3] = 0;
        continue;
      }
      const z = Math.sqrt(beyond);
      for (let i = 0; i < 3; i++) direction[i] = x * X[i]! + y * Y[i]! + z * Z[i]!;
      shade(direction, 0.45 * z + 0.3 * y - 0.2 * x + 0.45, data, at);
    }
  }
}
