// What is drawn: balls and rods that a fragment shader rounds, and flat plates.

/** A ball: a square facing the eye, on which depth and light are those of a sphere. */
const BALL = `
in vec2 corner;
in vec3 place;
in float radius;
in vec4 color;
uniform vec3 low, high;
uniform float size;
out vec2 at;
out float bulge;
flat out vec3 paint;
void main() {
  float r = radius * size * (color.a < 0.5 ? 0.0 : 1.0);
  gl_Position = seen(mix(low, high, place));
  gl_Position.xy += corner * r * frame.xy;
  at = corner;
  bulge = r / depth;
  paint = color.rgb;
}`;

const SOLID_BALL = `
in vec2 at;
in float bulge;
flat in vec3 paint;
out vec4 shown;
void main() {
  float outward = dot(at, at);
  if (outward > 1.0) discard;
  float front = sqrt(1.0 - outward);
  float light = 0.42 + 0.58 * max(0.0, dot(vec3(at, front), vec3(-0.33, 0.42, 0.845)));
  float glint = pow(max(0.0, dot(vec3(at, front), vec3(-0.17, 0.22, 0.96))), 40.0);
  vec3 color = paint * light * smoothstep(0.0, 0.35, front + 0.12) + 0.22 * glint;
  gl_FragDepth = gl_FragCoord.z - 0.5 * front * bulge;
  shown = vec4(hazed(color, gl_FragCoord.z), 1.0);
}`;

/** A glass ball: a faint rim, drawn over everything before it that is nearer. */
const GLASS_BALL = `
in vec2 at;
flat in vec3 paint;
out vec4 shown;
void main() {
  float outward = dot(at, at);
  if (outward > 1.0) discard;
  shown = vec4(hazed(mix(vec3(0.45), paint, 0.75), gl_FragCoord.z), 0.05 + 0.2 * outward * outward * outward);
}`;

/** A rod between two ends, turned to the eye; one that pulls has bands. */
const ROD = `
in vec2 corner;
in vec3 from, to;
in float thick;
in vec4 color;
out float across, along;
flat out vec4 paint;
void main() {
  vec4 ends[2] = vec4[2](seen(from), seen(to));
  vec4 here = corner.y < 0.0 ? ends[0] : ends[1];
  vec2 way = (ends[1].xy - ends[0].xy) / frame.xy;
  float reach = length(way);
  way = reach > 1e-9 ? way / reach : vec2(1.0, 0.0);
  gl_Position = here;
  gl_Position.xy += corner.x * thick * vec2(-way.y, way.x) * frame.xy;
  gl_Position.z -= thick / depth;
  across = corner.x;
  along = corner.y < 0.0 ? 0.0 : distance(from, to);
  paint = color;
}`;

const ROUND_ROD = `
in float across, along;
flat in vec4 paint;
uniform float band;
out vec4 shown;
void main() {
  float front = sqrt(max(0.0, 1.0 - across * across));
  vec3 color = paint.rgb * (0.5 + 0.5 * front);
  if (paint.a < 0.75 && fract(along / band) > 0.65) color = mix(color, vec3(1.0), 0.5);
  shown = vec4(hazed(color, gl_FragCoord.z), 1.0);
}`;

/** A flat parallelogram: a corner and two sides. */
const PLATE = `
in vec2 corner;
in vec3 from, first, second;
in vec4 color;
flat out vec4 paint;
void main() {
  gl_Position = seen(from + 0.5 * (corner.x + 1.0) * first + 0.5 * (corner.y + 1.0) * second);
  paint = color;
}`;

const FLAT_PLATE = `
flat in vec4 paint;
out vec4 shown;
void main() { shown = paint; }`;

function shapes(gl) {
  const [bytes, float] = [[4, gl.UNSIGNED_BYTE, true], [3, gl.FLOAT, false]];
  const ball = { place: [3, gl.UNSIGNED_SHORT, true], radius: [1, gl.FLOAT, false], color: bytes };
  const rod = { from: float, to: float, thick: [1, gl.FLOAT, false], color: bytes };
  const plate = { from: float, first: float, second: float, color: bytes };
  return {
    solid: new Instances(gl, SIGHT + BALL, HAZE + SOLID_BALL, ball),
    glass: new Instances(gl, SIGHT + BALL, HAZE + GLASS_BALL, ball),
    rods: new Instances(gl, SIGHT + ROD, HAZE + ROUND_ROD, rod),
    plates: new Instances(gl, SIGHT + PLATE, HAZE + FLAT_PLATE, plate),
  };
}
