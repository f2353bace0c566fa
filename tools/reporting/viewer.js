// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The bodies over time. Faces are drawn one by one, so that the stress of a cell stays that of this
// cell, and the normal of a face comes from the derivatives of its place on the screen.
(function () {
  "use strict";
  const source = document.getElementById("view-data");
  if (!source) return;
  const data = JSON.parse(source.textContent);
  const element = id => document.getElementById("view-" + id);
  const canvas = element("canvas");
  const gl = canvas.getContext("webgl2", { alpha: false, preserveDrawingBuffer: true });
  if (!gl) {
    element("message").textContent =
      "This browser offers no WebGL 2, which the view needs. The pictures below do without.";
    return;
  }

  const decode = (text, Kind) =>
    new Kind(Uint8Array.from(atob(text), letter => letter.charCodeAt(0)).buffer);
  for (const mesh of data.meshes) {
    mesh.reference = decode(mesh.reference, Float32Array);
    mesh.faces = decode(mesh.faces, Uint32Array);
  }
  for (const moment of data.moments)
    for (const name of ["displacement", "velocity", "pressure", "stress"])
      moment[name] = decode(moment[name], Float32Array);
  for (const obstacle of data.obstacles) {
    obstacle.points = decode(obstacle.points, Float32Array);
    obstacle.cells = decode(obstacle.cells, Uint32Array);
  }

  const length = (array, i) => Math.hypot(array[3 * i], array[3 * i + 1], array[3 * i + 2]);
  const fields = {
    stress: { title: "von Mises stress", colours: "cold", at: (m, face) => m.stress[face] },
    pressure: { title: "contact pressure", colours: "warm", at: (m, face, n) => m.pressure[n] },
    displacement: {
      title: "displacement", colours: "cold", at: (m, face, n) => length(m.displacement, n) },
    velocity: { title: "velocity", colours: "cold", at: (m, face, n) => m.velocity[n] },
  };
  for (const field of Object.values(fields)) {
    field.top = 0;
    for (const moment of data.moments) {
      const faces = data.meshes[moment.mesh].faces;
      for (let i = 0; i < faces.length; ++i)
        field.top = Math.max(field.top, field.at(moment, i >> 2, faces[i]) || 0);
    }
    field.top = field.top || 1;
  }

  // The box that holds all bodies at all moments.
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const moment of data.moments)
    moment.displacement.forEach((value, i) => {
      const place = value + data.meshes[moment.mesh].reference[i];
      if (!Number.isFinite(place)) return;
      low[i % 3] = Math.min(low[i % 3], place);
      high[i % 3] = Math.max(high[i % 3], place);
    });
  const middle = low.map((value, i) => 0.5 * (value + high[i]));
  const radius = 0.5 * Math.hypot(...low.map((value, i) => high[i] - value)) || 1;

  const shader = (type, text) => {
    const result = gl.createShader(type);
    gl.shaderSource(result, "#version 300 es\nprecision highp float;\n" + text);
    gl.compileShader(result);
    if (!gl.getShaderParameter(result, gl.COMPILE_STATUS)) throw Error(gl.getShaderInfoLog(result));
    return result;
  };
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, `
    in vec3 point; in float value; in vec2 corner;
    uniform mat3 turn; uniform vec3 middle, shift, scale;
    out vec3 place; out float shown; out vec2 across;
    void main() {
      place = turn * (point - middle); shown = value; across = corner;
      gl_Position = vec4((place + shift) * scale, 1.0);
    }`));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, `
    in vec3 place; in float shown; in vec2 across;
    uniform sampler2D map; uniform vec4 plain; uniform float top, light, lines;
    out vec4 colour;
    void main() {
      colour = plain.a > 0.0 ? plain : texture(map, vec2(clamp(shown / top, 0.002, 0.998), 0.5));
      vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
      colour.rgb *= 1.0 - light * (0.4 - 0.4 * abs(dot(normal, vec3(-0.35, 0.5, 0.79))));
      vec2 width = fwidth(across) + 1e-6;
      vec2 edge = min(across, 1.0 - across) / width;
      float faint = clamp(1.0 - 5.0 * max(width.x, width.y), 0.0, 1.0);
      colour.rgb *= 1.0 - 0.35 * lines * faint * (1.0 - smoothstep(0.3, 1.3, min(edge.x, edge.y)));
    }`));
  gl.linkProgram(program);
  gl.useProgram(program);
  const place = {};
  for (const name of ["turn", "middle", "shift", "scale", "plain", "top", "light", "lines"])
    place[name] = gl.getUniformLocation(program, name);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  [["point", 3, 0], ["value", 1, 12], ["corner", 2, 16]].forEach(([name, size, offset]) => {
    const index = gl.getAttribLocation(program, name);
    gl.enableVertexAttribArray(index);
    gl.vertexAttribPointer(index, size, gl.FLOAT, false, 24, offset);
  });
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
    gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, filter, gl.LINEAR);

  const flat = data.dimension === 2;
  const start = () => ({ yaw: -0.5, pitch: 0.25, zoom: 1, x: 0, y: 0 });
  let camera = start(), timer = null, waiting = false;

  function faceVertices(moment, field, factor) {
    const mesh = data.meshes[moment.mesh], n = mesh.faces.length / 4;
    const corners = [[0, 0, 0], [1, 1, 0], [2, 1, 1], [0, 0, 0], [2, 1, 1], [3, 0, 1]];
    const vertices = new Float32Array(36 * n);
    let at = 0;
    for (let face = 0; face < n; ++face)
      for (const [corner, u, v] of corners) {
        const node = mesh.faces[4 * face + corner];
        for (let i = 3 * node; i < 3 * node + 3; ++i)
          vertices[at++] = mesh.reference[i] + factor * moment.displacement[i];
        vertices[at++] = field.at(moment, face, node);
        vertices[at++] = u;
        vertices[at++] = v;
      }
    return vertices;
  }

  function obstacleVertices(obstacle) {
    const vertices = new Float32Array(6 * obstacle.cells.length);
    obstacle.cells.forEach((node, i) =>
      vertices.set([...obstacle.points.subarray(3 * node, 3 * node + 3), 0, 0.5, 0.5], 6 * i));
    return vertices;
  }

  function drawVertices(vertices, mode) {
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STREAM_DRAW);
    gl.drawArrays(mode, 0, vertices.length / 6);
  }

  function setCamera() {
    const a = flat ? 0 : camera.yaw, b = flat ? Math.PI / 2 : camera.pitch;
    const [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
    // Columns: where x, y and z go; z is up unless the scene is flat.
    gl.uniformMatrix3fv(place.turn, false, [ca, -sa * sb, sa * cb, sa, ca * sb, -ca * cb, 0, cb, sb]);
    const size = Math.min(canvas.width, canvas.height) * camera.zoom / (1.1 * radius);
    gl.uniform3fv(place.middle, middle);
    gl.uniform3f(place.shift, camera.x, camera.y, 0);
    // Far obstacles are cut off in depth only behind a hundred sizes.
    gl.uniform3f(place.scale, size / canvas.width, size / canvas.height, -0.01 / radius);
  }

  function draw() {
    waiting = false;
    const moment = data.moments[+element("time").value], field = fields[element("field").value];
    canvas.width = canvas.clientWidth * devicePixelRatio;
    canvas.height = canvas.clientHeight * devicePixelRatio;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    setCamera();
    gl.uniform1f(place.top, +element("top").value || field.top);
    gl.uniform1f(place.light, flat ? 0 : 1);
    gl.uniform1f(place.lines, element("mesh").checked ? 1 : 0);
    gl.uniform4f(place.plain, 0, 0, 0, 0);
    drawVertices(faceVertices(moment, field, +element("factor").value), gl.TRIANGLES);
    gl.uniform1f(place.lines, 0);
    gl.depthMask(false); // what presses is seen through the obstacle
    const shown = data.rests ? [0] : [];
    if (moment.obstacle !== null) shown.push(moment.obstacle);
    for (const index of element("obstacles").checked ? shown : []) {
      const lines = data.obstacles[index].corners === 2;
      gl.uniform4f(place.plain, 0.42, 0.45, 0.5, lines ? 1 : 0.3);
      drawVertices(obstacleVertices(data.obstacles[index]), lines ? gl.LINES : gl.TRIANGLES);
    }
    gl.depthMask(true);
    element("moment").textContent =
      `time ${+moment.time.toPrecision(6)} (${+element("time").value + 1} of ${data.moments.length})`;
  }

  const redraw = () => { if (!waiting) { waiting = true; requestAnimationFrame(draw); } };

  function chooseField() {
    const field = fields[element("field").value], colours = data.colours[field.colours];
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, colours.length, 1, 0, gl.RGB, gl.UNSIGNED_BYTE,
                  new Uint8Array([].concat(...colours)));
    element("bar").style.background =
      `linear-gradient(to right, ${colours.map(c => `rgb(${c})`).join(",")})`;
    element("top").value = +field.top.toPrecision(4);
    redraw();
  }

  function play() {
    const slider = element("time");
    clearInterval(timer);
    timer = timer ? null : setInterval(() => {
      slider.value = (+slider.value + 1) % data.moments.length;
      redraw();
    }, Math.max(40, 6000 / data.moments.length));
    element("play").textContent = timer ? "Pause" : "Play";
  }

  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  element("time").max = data.moments.length - 1;
  for (const [name, field] of Object.entries(fields))
    element("field").add(new Option(field.title, name));
  for (const id of ["time", "top", "factor", "mesh", "obstacles"])
    element(id).addEventListener("input", redraw);
  element("field").addEventListener("input", chooseField);
  element("play").addEventListener("click", play);
  canvas.addEventListener("pointerdown", event => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", event => {
    if (!event.buttons) return;
    if (flat || event.shiftKey || event.buttons !== 1) {
      const unit = 2.2 * radius / Math.min(canvas.clientWidth, canvas.clientHeight) / camera.zoom;
      camera.x += event.movementX * unit;
      camera.y -= event.movementY * unit;
    } else {
      camera.yaw -= event.movementX * 0.008;
      camera.pitch = Math.max(-1.57, Math.min(1.57, camera.pitch + event.movementY * 0.008));
    }
    redraw();
  });
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    camera.zoom *= Math.exp(-0.0015 * event.deltaY);
    redraw();
  }, { passive: false });
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("dblclick", () => { camera = start(); redraw(); });
  new ResizeObserver(redraw).observe(canvas);
  chooseField();
})();
