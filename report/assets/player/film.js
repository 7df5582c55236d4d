// From the data of the page to a film: typed arrays, one stretch a frame.

/** Inflates base64 of a zlib stream. */
async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Takes numbers whose bytes are stored plane by plane, the lowest first. */
class Planes {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  take(numbers) {
    const width = numbers.BYTES_PER_ELEMENT;
    const count = numbers.length;
    for (let plane = 0; plane < width; plane += 1) {
      const shift = 8 * plane;
      const from = this.at + plane * count;
      for (let k = 0; k < count; k += 1) numbers[k] |= this.bytes[from + k] << shift;
    }
    this.at += width * count;
    return numbers;
  }
}

/** Numbers stored as differences to those `apart` before them. */
function summed(numbers, apart) {
  for (let k = apart; k < numbers.length; k += 1) numbers[k] += numbers[k - apart];
  return numbers;
}

/** Single-precision numbers from their upper halves. */
function fromUpperHalves(halves) {
  const bits = new Uint32Array(halves.length);
  for (let k = 0; k < halves.length; k += 1) bits[k] = halves[k] << 16;
  return new Float32Array(bits.buffer);
}

/** Places, speeds and contacts of all frames, and what follows from them. */
async function readFilm(meta, text) {
  const planes = new Planes(await inflate(text));
  const n = meta.particles;
  const frames = meta.frames.length;
  const axes = [0, 1, 2].map(() => summed(planes.take(new Uint16Array(n * frames)), n));
  const speeds = fromUpperHalves(planes.take(new Uint16Array(n * frames)));
  const starts = [0];
  for (const frame of meta.frames) starts.push(starts[starts.length - 1] + frame.contacts);
  const m = starts[frames];
  const a = summed(planes.take(new Uint32Array(m)), 1);
  const b = planes.take(new Uint32Array(m));
  for (let k = 0; k < m; k += 1) b[k] += a[k];
  const forces = fromUpperHalves(planes.take(new Uint16Array(m)));
  const holds = planes.take(new Uint8Array(m));
  const places = new Uint16Array(3 * n * frames);
  for (let k = 0; k < n * frames; k += 1) {
    for (let axis = 0; axis < 3; axis += 1) places[3 * k + axis] = axes[axis][k];
  }
  const radii = new Float32Array(n);
  for (let k = 0; k < n; k += 1) radii[k] = Array.isArray(meta.radii) ? meta.radii[k] : meta.radii;
  return { meta, n, frames, places, speeds, starts, a, b, forces, holds, radii };
}

/** The centre of a particle in a frame. */
function centre(film, frame, particle) {
  const [low, high] = film.meta.box;
  const at = 3 * (frame * film.n + particle);
  return [0, 1, 2].map((k) => low[k] + (film.places[at + k] / 65535) * (high[k] - low[k]));
}

/** The value below which a share of some finite numbers lies; looks at 50,000 of them. */
function quantile(numbers, share) {
  const step = Math.max(1, Math.floor(numbers.length / 5e4));
  const some = [];
  for (let k = 0; k < numbers.length; k += step) if (Number.isFinite(numbers[k])) some.push(numbers[k]);
  some.sort((x, y) => x - y);
  return some.length ? some[Math.min(some.length - 1, Math.floor(share * some.length))] : 0;
}
