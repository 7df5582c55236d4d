// Programs and buffers of WebGL 2.

/** Where a point in space is seen: shared by all vertex shaders. `sight` is the same for all. */
const SIGHT = `#version 300 es
precision highp float;
uniform vec3 right, up, toward, middle;
uniform vec4 frame;  // scale in x and y, shift in x and y, in clip coordinates
uniform float depth, hazeNear, hazeFar;
vec4 seen(vec3 place) {
  vec3 at = place - middle;
  vec2 spot = vec2(dot(right, at), dot(up, at)) * frame.xy + frame.zw;
  return vec4(spot, -dot(toward, at) / depth, 1.0);
}
// Far things are paler: the share of white.
float haze(vec4 place) {
  return 0.42 * clamp((place.z - hazeNear) / (hazeFar - hazeNear), 0.0, 1.0);
}
`;

/** Begins every fragment shader. */
const FRAGMENT = `#version 300 es
precision highp float;
`;

function compile(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
      throw new Error(gl.getShaderInfoLog(shader));
    }
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const places = {};
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
  for (let k = 0; k < count; k += 1) {
    const { name } = gl.getActiveUniform(program, k);
    places[name] = gl.getUniformLocation(program, name);
  }
  return { program, places };
}

/** Texels in a row of the textures that hold numbers. */
const ROW = 1024;
/** How numbers lie in a texture: format inside and outside, type, numbers a texel, sampler. */
const TEXELS = {
  shorts: (gl) => [gl.RGB16UI, gl.RGB_INTEGER, gl.UNSIGNED_SHORT, 3, "usampler2D", Uint16Array],
  bytes: (gl) => [gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, 4, "sampler2D", Uint8Array],
  float: (gl) => [gl.R32F, gl.RED, gl.FLOAT, 1, "sampler2D", Float32Array],
  floats: (gl) => [gl.RGBA32F, gl.RGBA, gl.FLOAT, 4, "sampler2D", Float32Array],
};
/** Corners of shapes, and those of their triangles. */
const SHAPES = {
  // Round the unit circle.
  triangle: { points: [[-Math.sqrt(3), -1], [Math.sqrt(3), -1], [0, 2]], corners: [0, 1, 2] },
  square: { points: [[-1, -1], [1, -1], [-1, 1], [1, 1]], corners: [0, 1, 2, 2, 1, 3] },
};

/** A thing drawn many times in one call: corners by their number, all else from textures. Software
 * draws instances one by one, which takes ten times as long. */
class Copies {
  /** `layout`: name → a kind of `TEXELS`; the shader has `corner` and `of(name)`. */
  constructor(gl, shape, layout, vertex, fragment) {
    const { points, corners } = SHAPES[shape];
    const kinds = Object.entries(layout).map(([name, kind]) => [name, TEXELS[kind](gl)]);
    const head = `precision highp usampler2D;
${kinds.map(([name, kind]) => `uniform highp ${kind[4]} ${name};`).join("\n")}
const vec2 corners[${points.length}] = vec2[](${points.map((point) => `vec2(${point})`)});
#define corner corners[gl_VertexID % ${points.length}]
#define of(name) texelFetch(name, ivec2(gl_VertexID / ${points.length} % ${ROW}, gl_VertexID / ${points.length} / ${ROW}), 0)
`;
    Object.assign(this, { gl, points, corners, copies: 0 }, compile(gl, SIGHT + head + vertex, FRAGMENT + fragment));
    this.array = gl.createVertexArray();
    this.indices = gl.createBuffer();
    this.textures = {};
    for (const [name, kind] of kinds) this.textures[name] = { texture: gl.createTexture(), kind, rows: 0 };
  }

  /** Numbers of all copies. */
  set(name, numbers) {
    const { gl } = this;
    const entry = this.textures[name];
    const [inside, outside, type, width, , List] = entry.kind;
    const rows = Math.max(1, Math.ceil(numbers.length / width / ROW));
    gl.bindTexture(gl.TEXTURE_2D, entry.texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    if (rows > entry.rows) {
      gl.texImage2D(gl.TEXTURE_2D, 0, inside, ROW, rows, 0, outside, type, null);
      for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
      [entry.rows, entry.whole] = [rows, new List(rows * ROW * width)];
    }
    entry.whole.set(numbers);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, ROW, rows, outside, type, entry.whole);
  }

  /** Corners of the triangles of so many copies. */
  index(count) {
    const { gl, points, corners } = this;
    this.copies = count;
    const list = new Uint32Array(corners.length * count);
    for (let k = 0; k < list.length; k += 1) {
      list[k] = points.length * Math.floor(k / corners.length) + corners[k % corners.length];
    }
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list, gl.STATIC_DRAW);
  }

  draw(count, sight, own = {}) {
    const { gl, places } = this;
    if (count === 0) return;
    gl.useProgram(this.program);
    for (const [name, value] of Object.entries({ ...sight, ...own })) {
      if (!places[name]) continue;
      if (typeof value === "number") gl.uniform1f(places[name], value);
      else gl[`uniform${value.length}fv`](places[name], value);
    }
    Object.entries(this.textures).forEach(([name, { texture }], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(places[name], unit);
    });
    gl.activeTexture(gl.TEXTURE0);
    gl.bindVertexArray(this.array);
    if (count > this.copies) this.index(2 * count);
    gl.drawElements(gl.TRIANGLES, this.corners.length * count, gl.UNSIGNED_INT, 0);
  }
}
