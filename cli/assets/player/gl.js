// Programs and buffers of WebGL 2.

/** Where a point in space is seen: shared by all vertex shaders. `sight` is the same for all. */
const SIGHT = `#version 300 es
precision highp float;
uniform vec3 right, up, toward, middle;
uniform vec4 frame;  // scale in x and y, shift in x and y, in clip coordinates
uniform float depth;
vec4 seen(vec3 place) {
  vec3 at = place - middle;
  vec2 spot = vec2(dot(right, at), dot(up, at)) * frame.xy + frame.zw;
  return vec4(spot, -dot(toward, at) / depth, 1.0);
}
`;

/** Far things are paler. */
const HAZE = `#version 300 es
precision highp float;
uniform float hazeNear, hazeFar;
vec3 hazed(vec3 color, float z) {
  return mix(color, vec3(1.0), 0.42 * clamp((z - hazeNear) / (hazeFar - hazeNear), 0.0, 1.0));
}
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

/** A kind of thing drawn many times as the four corners of a quadrilateral. */
class Instances {
  /** `layout`: name → [numbers, GL type, normalized]; each has a buffer of its own. */
  constructor(gl, vertex, fragment, layout) {
    Object.assign(this, { gl, layout }, compile(gl, vertex, fragment));
    this.array = gl.createVertexArray();
    this.buffers = {};
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
    this.attribute("corner", 2, gl.FLOAT, false, 0);
    for (const [name, [size, type, normalized]] of Object.entries(layout)) {
      this.buffers[name] = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
      this.attribute(name, size, type, normalized, 1);
    }
    gl.bindVertexArray(null);
  }

  attribute(name, size, type, normalized, divisor) {
    const { gl } = this;
    const place = gl.getAttribLocation(this.program, name);
    if (place < 0) return;
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, type, normalized, 0, 0);
    gl.vertexAttribDivisor(place, divisor);
  }

  set(name, numbers) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
  }

  draw(count, sight, own = {}) {
    const { gl, places } = this;
    gl.useProgram(this.program);
    for (const [name, value] of Object.entries({ ...sight, ...own })) {
      if (!places[name]) continue;
      if (typeof value === "number") gl.uniform1f(places[name], value);
      else gl[`uniform${value.length}fv`](places[name], value);
    }
    gl.bindVertexArray(this.array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
    gl.bindVertexArray(null);
  }
}
