// What is drawn: balls and rods that a fragment shader rounds, and flat plates.

/** A ball: a square facing the eye, on which depth and light are those of a sphere. */
const BALL = `
uniform vec3 low, high;
uniform float size;
out vec2 at;
flat out float bulge, pale;
flat out vec3 paint;
void main() {
  float r = of(radius).r * size;
  gl_Position = seen(mix(low, high, vec3(of(place).rgb) / 65535.0));
  pale = haze(gl_Position);
  gl_Position.xy += corner * r * frame.xy;
  at = corner;
  bulge = r / depth;
  paint = of(color).rgb;
}`;

const SOLID_BALL = `
in vec2 at;
flat in float bulge, pale;
flat in vec3 paint;
out vec4 shown;
void main() {
  float outward = dot(at, at);
  if (outward > 1.0) discard;
  float front = sqrt(1.0 - outward);
  float light = 0.42 + 0.58 * max(0.0, dot(vec3(at, front), vec3(-0.33, 0.42, 0.845)));
  float glint = max(0.0, dot(vec3(at, front), vec3(-0.17, 0.22, 0.96)));
  glint *= glint, glint *= glint, glint *= glint, glint *= glint, glint *= glint;
  vec3 color = paint * light * min(1.0, 0.25 + 2.2 * front) + 0.2 * glint;
  gl_FragDepth = gl_FragCoord.z - 0.5 * front * bulge;
  shown = vec4(color * (1.0 - pale) + pale, 1.0);
}`;

/** A glass ball: a faint rim, drawn over everything before it that is nearer. */
const GLASS_BALL = `
in vec2 at;
flat in float pale;
flat in vec3 paint;
out vec4 shown;
void main() {
  float outward = dot(at, at);
  if (outward > 1.0) discard;
  shown = vec4((paint * 0.75 + 0.11) * (1.0 - pale) + pale, 0.06 + 0.3 * outward * outward * outward);
}`;

/** A rod between two ends, turned to the eye; one that pulls has bands. */
const ROD = `
out float across, along;
flat out float pale;
flat out vec4 paint;
void main() {
  vec3 first = of(from).xyz, last = of(to).xyz;
  float thick = of(from).w;
  vec4 here = seen(corner.y < 0.0 ? first : last);
  vec2 way = vec2(dot(right, last - first), dot(up, last - first));
  float reach = length(way);
  way = reach > 1e-9 ? way / reach : vec2(1.0, 0.0);
  gl_Position = here;
  gl_Position.xy += corner.x * thick * vec2(-way.y, way.x) * frame.xy;
  gl_Position.z -= thick / depth;
  pale = haze(here);
  across = corner.x;
  along = corner.y < 0.0 ? 0.0 : distance(first, last);
  paint = of(color);
}`;

const ROUND_ROD = `
in float across, along;
flat in float pale;
flat in vec4 paint;
uniform float band;
out vec4 shown;
void main() {
  float front = sqrt(max(0.0, 1.0 - across * across));
  vec3 color = paint.rgb * (0.5 + 0.5 * front);
  if (paint.a < 0.75 && fract(along / band) > 0.65) color = mix(color, vec3(1.0), 0.5);
  shown = vec4(color * (1.0 - pale) + pale, 1.0);
}`;

/** A flat parallelogram: a corner and two sides. */
const PLATE = `
flat out vec4 paint;
void main() {
  gl_Position = seen(of(from).xyz + 0.5 * (corner.x + 1.0) * of(first).xyz + 0.5 * (corner.y + 1.0) * of(second).xyz);
  paint = of(color);
}`;

const FLAT_PLATE = `
flat in vec4 paint;
out vec4 shown;
void main() { shown = paint; }`;

function shapes(gl) {
  const ball = { place: "shorts", radius: "float", color: "bytes" };
  const rod = { from: "floats", to: "floats", color: "bytes" };
  const plate = { from: "floats", first: "floats", second: "floats", color: "bytes" };
  return {
    solid: new Copies(gl, "triangle", ball, BALL, SOLID_BALL),
    glass: new Copies(gl, "triangle", ball, BALL, GLASS_BALL),
    rods: new Copies(gl, "square", rod, ROD, ROUND_ROD),
    plates: new Copies(gl, "square", plate, PLATE, FLAT_PLATE),
  };
}
