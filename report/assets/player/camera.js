// Parallel projection: one scale for all directions, z upwards.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

class Camera {
  constructor(box) {
    this.box = box;
    this.reset();
  }

  /** Looks from the front, a little from the right and from above. */
  reset() {
    [this.azimuth, this.elevation] = [-1.13, 0.2];
    [this.zoom, this.shift] = [1, [0, 0]];
  }

  /** Directions of the picture and the middle of the box. */
  axes() {
    const [sin, cos] = [Math.sin(this.azimuth), Math.cos(this.azimuth)];
    const [rise, run] = [Math.sin(this.elevation), Math.cos(this.elevation)];
    return {
      right: [-sin, cos, 0],
      up: [-rise * cos, -rise * sin, run],
      toward: [run * cos, run * sin, rise],
      middle: this.box[0].map((low, k) => 0.5 * (low + this.box[1][k])),
    };
  }

  /** Pixels a unit of length at which the box fills the picture, zoomed. */
  scale(width, height) {
    const { right, up } = this.axes();
    const sides = this.box[0].map((low, k) => this.box[1][k] - low);
    const extent = (axis) => sides.reduce((sum, side, k) => sum + side * Math.abs(axis[k]), 0);
    return this.zoom * Math.min(width / extent(right), height / extent(up));
  }

  /** Half the depth of everything seen. */
  depth() {
    return Math.hypot(...this.box[0].map((low, k) => this.box[1][k] - low));
  }

  turn(dx, dy) {
    this.azimuth -= 0.008 * dx;
    this.elevation = Math.max(-1.55, Math.min(1.55, this.elevation + 0.008 * dy));
  }

  move(dx, dy) {
    this.shift = [this.shift[0] + dx, this.shift[1] - dy];
  }

  /** Zooms by a factor; the place at (x, y) from the middle of the picture stays. */
  zoomBy(factor, x = 0, y = 0) {
    const zoom = Math.max(0.2, Math.min(60, this.zoom * factor));
    const grown = zoom / this.zoom;
    this.shift = [x + (this.shift[0] - x) * grown, y + (this.shift[1] - y) * grown];
    this.zoom = zoom;
  }
}
