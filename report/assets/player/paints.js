// What colours mean: a value or a kind a particle, and the legend that says so.

const bytesOf = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

/** Kinds of what a contact does, by the bits of its thresholds. */
const HOLDS = [
  { name: "sticks", color: "#9aa0a6" },
  { name: "slides", color: "#d55e00" },
  { name: "rolls", color: "#009e73" },
  { name: "spins", color: "#cc79a7" },
  { name: "two or three at once", color: "#f0c520" },
  { name: "carries nothing", color: "#e3e6e8" },
];
const holdKind = (hold) => (hold & 128 ? 5 : [0, 1, 2, 4, 3, 4, 4, 4][hold & 7]);

/** Shares of a scale from values. */
function scaleOf(numbers, logarithmic) {
  const high = quantile(numbers, 0.995) || 1;
  if (!logarithmic) return { low: 0, high, share: (x) => x / high };
  const low = Math.max(quantile(numbers, 0.05), 1e-4 * high, Number.MIN_VALUE);
  const span = Math.log(high / low) || 1;
  return { low, high, logarithmic, share: (x) => (x > 0 ? Math.log(x / low) / span : 0) };
}

/** The ways to colour the particles of a film. */
function paintsOf(film) {
  const { meta, n } = film;
  const ramp = meta.ramp.map(bytesOf);
  const onRamp = (share) => ramp[Math.round(Math.max(0, Math.min(1, share)) * (ramp.length - 1))];
  const value = (label, unit, scale, at) => ({
    label,
    unit,
    scale,
    colors: (frame) => {
      const values = at(frame);
      return (k) => onRamp(scale.share(values[k]));
    },
  });
  const kinds = (label, list, at) => ({
    label,
    kinds: list,
    colors: (frame) => {
      const of = at(frame);
      const colors = list.map((kind) => bytesOf(kind.color));
      return (k) => colors[of[k]];
    },
  });
  const speedsAt = (frame) => film.speeds.subarray(frame * n, (frame + 1) * n);
  const speed = value("speed", meta.units.speed, scaleOf(film.speeds, true), speedsAt);
  if (meta.body === "tip") {
    const top = Math.max(...meta.layers) + 1;
    const layer = value("layer, from below", "", { low: 1, high: top, whole: true, share: (x) => x / (top - 1) }, () => meta.layers);
    return { part: kinds("part", meta.partKinds, () => meta.parts), layer, speed };
  }
  const heights = Float32Array.from({ length: n }, (_, k) => centre(film, 0, k)[2]);
  const layer = value("height in the deposit", meta.units.length, scaleOf(heights, false), () => heights);
  if (film.starts[film.frames] === 0) return { layer, speed };
  const loads = (frame) => perParticle(film, frame, (sums, k, contact) => { sums[k] += Math.abs(film.forces[contact]); });
  const counts = (frame) => perParticle(film, frame, (sums, k) => { sums[k] += 1; });
  const some = [0.2, 0.4, 0.6, 0.8, 1].map((share) => Math.round(share * (film.frames - 1)));
  const force = value("normal forces, summed", meta.units.force, scaleOf(some.flatMap((at) => [...loads(at)]), false), loads);
  const most = Math.max(1, quantile(some.flatMap((at) => [...counts(at)]), 0.999));
  const coordination = value("number of contacts", "", { low: 0, high: most, whole: true, share: (x) => x / most }, counts);
  const mode = kinds("the strongest contact", HOLDS, (frame) => strongest(film, frame));
  return { layer, force, coordination, mode, speed };
}

/** A sum over each particle's contacts. */
function perParticle(film, frame, add) {
  const sums = new Float32Array(film.n);
  for (let k = film.starts[frame]; k < film.starts[frame + 1]; k += 1) {
    add(sums, film.a[k], k);
    if (film.b[k] < film.n) add(sums, film.b[k], k);
  }
  return sums;
}

/** What the contact of the largest force does, of each particle. */
function strongest(film, frame) {
  const [kinds, largest] = [new Uint8Array(film.n).fill(5), new Float32Array(film.n).fill(-1)];
  for (let k = film.starts[frame]; k < film.starts[frame + 1]; k += 1) {
    const force = Math.abs(film.forces[k]);
    for (const body of [film.a[k], film.b[k]]) {
      if (body >= film.n || force <= largest[body]) continue;
      largest[body] = force;
      kinds[body] = holdKind(film.holds[k]);
    }
  }
  return kinds;
}
