// Draws the scene of the page: one picture per solver, all with the same camera.
import * as THREE from "three";
import { OrbitControls } from "three/OrbitControls";
import { unzlibSync } from "three/fflate";

const FRAMES_A_SECOND = 12;
const TURN = Math.PI / 36;  // radians per key press
const FIELD_OF_VIEW = 25;  // degrees, along the shorter side
const HALF_VIEW = Math.tan(FIELD_OF_VIEW / 2 * Math.PI / 180);
const CREASE = Math.cos(40 * Math.PI / 180);
const REST = 250;  // ms
const FINE = 2;  // drawn pixels per shown pixel, in both directions
const HEIGHT = 0.72;  // largest height of the pictures, as a share of the window
const HEADING = 42;  // pixels above each picture
const NARROWEST = 165;  // pixels
const PARTS = 255;  // parts of an edge
const EDGES = "edges of the mesh";
const COLOURS = ["distance", "cells", "none"];
const PLAIN = "#e4e2dc", UNREACHED = "#d9dadd", INK = "#222222";
const CELLS = 8;  // colours of cells, without the colour for no cell
const KINDS = { f4: Float32Array, u4: Uint32Array, i4: Int32Array, u1: Uint8Array };

const element = (id) => document.getElementById(id);

function fail(message) {
  element("message").textContent = message;
  element("message").hidden = false;
  element("views").hidden = true;
  element("controls").hidden = true;
}

// Synchronous, unlike the streams of browsers: the page must be drawn when it is loaded, because
// programs that take a picture of a page do not wait longer.
function unpacked({ type, data }) {
  const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  return new KINDS[type](unzlibSync(bytes).slice().buffer);
}

// Unpacks all arrays of a scene in place.
function unpack(object) {
  for (const [key, value] of Object.entries(object ?? {})) {
    if (value?.data !== undefined) object[key] = unpacked(value);
    else if (typeof value === "object") unpack(value);
  }
}

const bytesOf = (color) => [1, 3, 5].map((i) => parseInt(color.slice(i, i + 2), 16));

THREE.ColorManagement.enabled = false;  // all colours are screen colours

// The surface is drawn once for all pictures, into textures with its shade, the distance, the colour
// of the cell, and for up to eight solvers the frame in which it is reached. Each picture is painted
// from these textures, so that the cost of playing does not depend on the number of faces.
const BEHIND = 0;  // no surface, instead of the colour of a cell

// Shaded like the figures: both sides are equal, with light from above on the left.
const SURFACE = {
  glslVersion: THREE.GLSL3,
  vertexShader: `
    in float distance, cell;
    in vec4 first, second;
    out vec3 towards;
    out float far;
    flat out float owner;
    out vec4 reached, reachedToo;
    void main() {
      towards = normalMatrix * normal;
      far = distance;
      owner = cell;
      reached = first;
      reachedToo = second;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: `
    in vec3 towards;
    in float far;
    flat in float owner;
    in vec4 reached, reachedToo;
    layout(location = 0) out vec4 look;
    layout(location = 1) out vec4 frames;
    layout(location = 2) out vec4 framesToo;
    void main() {
      vec3 normal = normalize(gl_FrontFacing ? towards : -towards);
      float shade = pow(0.5 + 0.5 * dot(normal, normalize(vec3(-0.45, 0.55, 0.7))), 1.2);
      float parts = floor(clamp(far, 0.0, 1.0) * 65535.0 + 0.5);
      look = vec4(shade, floor(parts / 256.0) / 255.0, mod(parts, 256.0) / 255.0, owner);
      frames = reached;
      framesToo = reachedToo;
    }`,
  side: THREE.DoubleSide,
  polygonOffset: true,  // puts lines on the surface in front of it
  polygonOffsetFactor: 1,
  polygonOffsetUnits: 2,
};

const PAINTING = {
  glslVersion: THREE.GLSL3,
  vertexShader: "void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }",
  fragmentShader: `
    precision highp sampler2D;
    uniform sampler2D look, frames, framesToo, depths, ramp;
    uniform vec4 mine, mineToo;
    uniform vec3 cells[${CELLS + 1}];
    uniform vec3 plain, unreached;
    uniform float frame;
    uniform int colour, taps, samples;
    uniform vec2 corner;
    layout(location = 0) out vec4 painted;
    const vec3 DARK = vec3(0.50, 0.52, 0.56), BRIGHT = vec3(1.0, 0.995, 0.98);
    vec3 at(ivec2 place) {
      vec4 here = texelFetch(look, place, 0);
      int cell = int(here.a * 255.0 + 0.5);
      if (cell == ${BEHIND}) return vec3(1.0);
      float distance = (here.g * 256.0 + here.b) * 255.0 / 65535.0;
      float first = dot(texelFetch(frames, place, 0), mine) + dot(texelFetch(framesToo, place, 0), mineToo);
      vec3 color = plain;
      if (colour == 0) color = texture(ramp, vec2(distance, 0.5)).rgb;
      if (colour == 1) color = cells[cell - 1];
      if (colour != 1 && first * 255.0 > frame - 0.5) color = unreached;
      return color * mix(DARK, BRIGHT, here.r);
    }
    void main() {
      ivec2 place = ivec2(gl_FragCoord.xy - corner) * taps;
      vec3 sum = vec3(0.0);
      for (int x = 0; x < samples; ++x) for (int y = 0; y < samples; ++y) sum += at(place + ivec2(x, y));
      painted = vec4(sum / float(samples * samples), 1.0);
      gl_FragDepth = texelFetch(depths, place, 0).r;
    }`,
  depthFunc: THREE.AlwaysDepth,
};

// Size of a picture in pixels, for lines with a width in pixels. It is equal for all pictures.
const pixels = { value: new THREE.Vector2(1, 1) };

// Draws segments as quads: each corner has the positions of both ends. (Instances would need less
// data, but software renderers draw each instance like a separate mesh.)
function fill(geometry, segments) {
  const count = segments.length / 6;
  const own = new Float32Array(12 * count), other = new Float32Array(12 * count);
  const side = new Float32Array(4 * count), index = new Uint32Array(6 * count);
  for (let s = 0; s < count; ++s) {
    const from = segments.subarray(6 * s, 6 * s + 3), to = segments.subarray(6 * s + 3, 6 * s + 6);
    for (let k = 0; k < 4; ++k) {
      own.set(k < 2 ? from : to, 12 * s + 3 * k);
      other.set(k < 2 ? to : from, 12 * s + 3 * k);
    }
    side.set([-1, 1, 1, -1], 4 * s);
    index.set([0, 1, 2, 2, 1, 3].map((k) => 4 * s + k), 6 * s);
  }
  geometry.setAttribute("position", new THREE.BufferAttribute(own, 3));
  geometry.setAttribute("other", new THREE.BufferAttribute(other, 3));
  geometry.setAttribute("side", new THREE.BufferAttribute(side, 1));
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  return geometry;
}

function thickLines(segments, color, width) {
  const mesh = new THREE.Mesh(fill(new THREE.BufferGeometry(), segments), new THREE.ShaderMaterial({
    uniforms: { color: { value: new THREE.Color(color) }, width: { value: width * devicePixelRatio }, pixels },
    vertexShader: `
      uniform vec2 pixels;
      uniform float width;
      attribute vec3 other;
      attribute float side;
      void main() {
        vec4 here = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        vec4 there = projectionMatrix * modelViewMatrix * vec4(other, 1.0);
        vec2 along = (there.xy / there.w - here.xy / here.w) * pixels;
        along = length(along) > 1e-4 ? normalize(along) : vec2(1.0, 0.0);
        here.xy += (side * vec2(-along.y, along.x) - 0.5 * along) * width / pixels * here.w;
        gl_Position = here;
      }`,
    fragmentShader: "uniform vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }",
    side: THREE.DoubleSide,
  }));
  mesh.frustumCulled = false;
  return mesh;
}

function thinLines(segments, color) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(segments, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color }));
}

// Draws a disc of some pixels at each point.
function marks(points, color) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  return new THREE.Points(geometry, new THREE.ShaderMaterial({
    uniforms: { color: { value: new THREE.Color(color) }, size: { value: 9 * devicePixelRatio } },
    vertexShader: `
      uniform float size;
      void main() {
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        gl_Position.z -= 0.002 * gl_Position.w;
        gl_PointSize = size;
      }`,
    fragmentShader: `
      uniform vec3 color;
      void main() {
        float radius = length(gl_PointCoord - 0.5);
        if (radius > 0.5) discard;
        gl_FragColor = vec4(radius > 0.3 ? color : vec3(1.0), 1.0);
      }`,
  }));
}

// A mesh to draw. At a crease, where the normal of a face differs much from that of the vertex, the
// corner becomes a separate vertex with the normal of the face.
class Drawn {
  constructor({ vertices, faces }) {
    const whole = new THREE.BufferGeometry();
    whole.setAttribute("position", new THREE.BufferAttribute(vertices, 3));
    whole.setIndex(new THREE.BufferAttribute(faces, 1));
    whole.computeVertexNormals();
    this.positions = Array.from(vertices);
    this.normals = Array.from(whole.getAttribute("normal").array);
    this.owners = Array.from({ length: vertices.length / 3 }, (_, v) => v);  // vertices of the original mesh
    this.index = Array.from(faces);
    this.crease();
  }

  crease() {
    const [a, b, c] = [0, 0, 0].map(() => new THREE.Vector3()), normal = new THREE.Vector3();
    for (let f = 0; f < this.index.length; f += 3) {
      [a, b, c].forEach((corner, k) => corner.fromArray(this.positions, 3 * this.index[f + k]));
      normal.crossVectors(b.sub(a), c.sub(a)).normalize();
      for (let i = f; i < f + 3; ++i) {
        const v = 3 * this.index[i];
        const along = normal.x * this.normals[v] + normal.y * this.normals[v + 1] + normal.z * this.normals[v + 2];
        if (along >= CREASE || normal.lengthSq() === 0) continue;
        this.index[i] = this.owners.push(this.owners[this.index[i]]) - 1;
        this.positions.push(...this.positions.slice(v, v + 3));
        this.normals.push(normal.x, normal.y, normal.z);
      }
    }
  }

  // Adds a vertex at the mean of some others.
  addBetween(others, owner) {
    for (const numbers of [this.positions, this.normals]) {
      for (let i = 0; i < 3; ++i) {
        numbers.push(others.reduce((sum, v) => sum + numbers[3 * v + i], 0) / others.length);
      }
    }
    return this.owners.push(owner) - 1;
  }

  // Splits faces with corners in several cells, so that each part belongs to the cell of its corner.
  splitByCell(cells) {
    const index = [];
    for (let f = 0; f < this.index.length; f += 3) {
      const corners = this.index.slice(f, f + 3), owners = corners.map((v) => this.owners[v]);
      if (owners.every((v) => cells[v] === cells[owners[0]])) {
        index.push(...corners);
        continue;
      }
      corners.forEach((v, k) => {
        const next = this.addBetween([v, corners[(k + 1) % 3]], owners[k]);
        const middle = this.addBetween(corners, owners[k]);
        const last = this.addBetween([corners[(k + 2) % 3], v], owners[k]);
        index.push(v, next, middle, v, middle, last);
      });
    }
    this.index = index;
    return this;
  }
}

// The surface of all pictures, and the textures into which it is drawn.
class Surface {
  constructor(scene) {
    this.scene = scene;
    this.whole = this.geometry(new Drawn(scene));
    this.model = new THREE.Mesh(this.whole, new THREE.ShaderMaterial(SURFACE));
    this.target = new THREE.WebGLRenderTarget(1, 1, {
      count: 3, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
      depthTexture: new THREE.DepthTexture(1, 1, THREE.UnsignedIntType),
    });
    const bytes = Uint8Array.from(scene.colors.flatMap((color) => [...bytesOf(color), 255]));
    this.ramp = new THREE.DataTexture(bytes, scene.colors.length, 1);
    this.ramp.minFilter = this.ramp.magFilter = THREE.LinearFilter;
    this.ramp.needsUpdate = true;
  }

  geometry(drawn) {
    const { distances, greatest, solvers } = this.scene, { owners } = drawn;
    const made = new THREE.BufferGeometry();
    const reached = solvers.length ? solvers.map(({ first }) => first) : [distances.map((d) => d < 0 ? 255 : 0)];
    const four = (from) => Uint8Array.from({ length: 4 * owners.length }, (_, i) => reached[from + i % 4]?.[owners[i >> 2]] ?? 0);
    made.setAttribute("position", new THREE.Float32BufferAttribute(drawn.positions, 3));
    made.setAttribute("normal", new THREE.Float32BufferAttribute(drawn.normals, 3));
    made.setAttribute("distance", new THREE.Float32BufferAttribute(owners.map((v) => distances[v] / greatest), 1));
    made.setAttribute("cell", new THREE.Float32BufferAttribute(owners.map((v) => this.cell(v) / 255), 1));
    made.setAttribute("first", new THREE.BufferAttribute(four(0), 4, true));
    made.setAttribute("second", new THREE.BufferAttribute(four(4), 4, true));
    made.setIndex(drawn.index);
    return made;
  }

  // Returns the number of the cell's colour, from 1. 0 stands for no surface.
  cell(v) {
    const { cells } = this.scene, number = cells?.nearest[v];
    return 1 + (number < cells?.sources.length ? number % CELLS : CELLS);
  }

  // @param taps pixels of the textures per pixel of the picture, in both directions
  draw(renderer, camera, { width, height }, taps, inCells) {
    if (inCells) this.split ??= this.geometry(new Drawn(this.scene).splitByCell(this.scene.cells.nearest));
    this.model.geometry = inCells ? this.split : this.whole;
    this.target.setSize(taps * width, taps * height);
    renderer.setRenderTarget(this.target);
    renderer.setClearColor("#000000", BEHIND);
    renderer.clear();
    renderer.render(this.model, camera);
    renderer.setRenderTarget(null);
    renderer.setClearColor("#ffffff", 1);
  }
}

// The windows of a solver in one frame.
class Wavefront {
  constructor(scene, solver) {
    this.scene = scene;
    this.solver = solver;
    this.from = [0];
    for (const count of solver.segments) this.from.push(this.from.at(-1) + count);
    this.lines = thickLines(new Float32Array(0), solver.color, 2);
    this.frame = 0;
  }

  show(frame) {
    if (frame === this.frame) return;
    this.frame = frame;
    this.lines.geometry.dispose();
    this.lines.geometry = fill(new THREE.BufferGeometry(), this.segments(frame));
  }

  segments(frame) {
    const { vertices, faces } = this.scene, { steps, begins, ends } = this.solver;
    const first = this.from[frame - 1], last = this.from[frame];
    const points = new Float32Array(6 * (last - first));
    for (let s = first, h = 0, out = 0; s < last; ++s, out += 6) {
      h += steps[s];
      const a = 3 * faces[h], b = 3 * faces[h % 3 === 2 ? h - 2 : h + 1];
      for (let i = 0; i < 3; ++i) {
        const origin = vertices[a + i], along = (vertices[b + i] - origin) / PARTS;
        points[out + i] = origin + begins[s] * along;
        points[out + 3 + i] = origin + ends[s] * along;
      }
    }
    return points;
  }
}

// A picture: the surface and the wavefront of its solver, and the lines and marks that all pictures
// share.
class Panel {
  constructor(surface, solver, number) {
    this.solver = solver;
    this.box = document.createElement("div");
    this.box.className = "panel";
    this.world = new THREE.Scene();
    this.world.add(this.paint = this.painting(surface, number));
    if (solver) {
      const heading = this.box.appendChild(document.createElement("h2"));
      const swatch = heading.appendChild(document.createElement("span"));
      swatch.className = "swatch";
      swatch.style.background = solver.color;
      heading.append(solver.name);
      this.numbers = this.box.appendChild(document.createElement("p"));
      this.wavefront = new Wavefront(surface.scene, solver);
      this.world.add(this.wavefront.lines);
    }
    this.stage = this.box.appendChild(document.createElement("div"));
    this.stage.className = "stage";
  }

  // Returns a triangle that covers the picture.
  painting({ target, ramp, scene }, number) {
    const channel = (from) => new THREE.Vector4(...[0, 1, 2, 3].map((i) => Number(number === from + i)));
    const [look, frames, framesToo] = target.textures, cells = scene.cells?.colors ?? Array(CELLS + 1).fill(PLAIN);
    const uniforms = {
      look, frames, framesToo, depths: target.depthTexture, ramp, mine: channel(0), mineToo: channel(4),
      cells: cells.map((color) => new THREE.Color(color)), plain: new THREE.Color(PLAIN), unreached: new THREE.Color(UNREACHED), frame: 1, colour: 0, taps: 1, samples: 1,
      corner: new THREE.Vector2(),
    };
    const named = Object.fromEntries(Object.entries(uniforms).map(([name, value]) => [name, { value }]));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
    const triangle = new THREE.Mesh(geometry, new THREE.ShaderMaterial({ ...PAINTING, uniforms: named }));
    triangle.frustumCulled = false;
    triangle.renderOrder = -1;
    return triangle;
  }

  update({ frame, colour, shown }) {
    const { uniforms } = this.paint.material;
    uniforms.colour.value = COLOURS.indexOf(colour);
    if (!this.solver) return;
    uniforms.frame.value = frame;
    const windows = frame ? this.solver.windows[frame - 1] : 0, { lines } = this.wavefront;
    lines.visible = shown.has("wavefront") && windows > 0;
    if (lines.visible) this.wavefront.show(frame);
    const spread = windows ? `, spread ${this.solver.spread[frame - 1].toFixed(2)}` : "";
    this.numbers.textContent = `${windows.toLocaleString("en")} windows${spread}`;
  }
}

class Page {
  // @param software whether the CPU draws, for which smooth lines are too expensive
  constructor(scene, software) {
    this.scene = scene;
    this.views = element("views");
    this.surface = new Surface(scene);
    this.panels = (scene.solvers.length ? scene.solvers : [null]).map((solver, i) => new Panel(this.surface, solver, i));
    this.last = scene.solvers[0]?.windows.length ?? 0;
    this.state = { frame: Math.round(this.last / 2), colour: "distance", shown: new Set(), hidden: new Set() };
    this.startRenderer(software);
    this.startCamera();
    this.makeLayers();
    this.makeControls();
    this.arrange();
    new ResizeObserver(() => this.arrange()).observe(this.views);
    document.addEventListener("keydown", (event) => this.key(event));
    this.change({});
    this.drawNow();
  }

  startRenderer(software) {
    this.renderer = new THREE.WebGLRenderer({ antialias: !software });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.setClearColor("#ffffff");
    this.renderer.setScissorTest(true);
    this.renderer.domElement.addEventListener("webglcontextlost", () => fail("The browser has ended WebGL; load the page again."));
    this.views.append(this.renderer.domElement);
    this.grid = this.views.appendChild(document.createElement("div"));
    this.grid.id = "panels";
    this.grid.append(...this.panels.map((panel) => panel.box));
  }

  // Looks in the same direction as the camera of the figures.
  startCamera() {
    const { axes, up } = this.scene;
    this.surface.whole.computeBoundingSphere();
    const { center, radius } = this.surface.whole.boundingSphere;
    const distance = this.distanceToSeeAll(center);
    this.camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, distance / 100, 10 * distance);
    this.camera.up.setComponent(0, 0).setComponent(1, 0).setComponent(2, 0).setComponent(up, 1);
    this.camera.position.fromArray(axes[2]).multiplyScalar(distance).add(center);
    this.controls = new OrbitControls(this.camera, this.views);
    this.controls.target.copy(center);
    this.controls.minDistance = radius / 50;
    this.controls.maxDistance = 5 * distance;
    this.controls.update();
    this.controls.saveState();
    this.controls.addEventListener("change", () => this.move());
  }

  distanceToSeeAll(center) {
    const [right, up, towards] = this.scene.axes.map((axis) => new THREE.Vector3(...axis));
    const { vertices } = this.scene, point = new THREE.Vector3();
    let distance = 0;
    for (let i = 0; i < vertices.length; i += 3) {
      point.fromArray(vertices, i).sub(center);
      const aside = Math.max(Math.abs(point.dot(right)), Math.abs(point.dot(up)));
      distance = Math.max(distance, aside / HALF_VIEW + point.dot(towards));
    }
    return 1.03 * distance;
  }

  // Makes the layers that all pictures share, by their names on the page.
  makeLayers() {
    const { isolines, paths, vertices, sources, cells } = this.scene;
    const places = (of) => of.flatMap((v) => [...vertices.subarray(3 * v, 3 * v + 3)]);
    this.marks = marks(places(sources), INK);
    this.marksOfCells = cells && marks(places(cells.sources), INK);
    this.layers = new Map();
    const both = new THREE.Group();
    both.add(thinLines(isolines.thin, "#5b6470"), thickLines(isolines.thick, "#3c4450", 1.6));
    this.layers.set("isolines", both);
    if (paths) this.layers.set("paths", thickLines(paths.segments, paths.color, 2.2));
    this.layers.set(EDGES, null);  // made when it is first shown
  }

  layer(name) {
    if (this.layers.get(name) === null) {
      const edges = new THREE.WireframeGeometry(this.surface.whole).getAttribute("position").array;
      this.layers.set(name, thinLines(edges, "#9a9a9a"));
    }
    return this.layers.get(name);
  }

  makeControls() {
    const { solvers, cells, greatest, colors } = this.scene;
    element("colour").append(...COLOURS.filter((name) => cells || name !== "cells").map((name) =>
      this.choice("radio", name, name === "distance", () => this.change({ colour: name }))));
    const lines = [...(solvers.length ? ["wavefront"] : []), ...this.layers.keys()];
    for (const name of lines) {
      const on = name === "wavefront" || (!solvers.length && name !== EDGES);
      if (on) this.state.shown.add(name);
      element("show").append(this.choice("checkbox", name, on, (checked) => this.toggle(this.state.shown, name, checked)));
    }
    element("greatest").textContent = `distance ${greatest.toPrecision(4)}`;
    document.querySelector(".ramp").style.background = `linear-gradient(to right, ${colors.join(",")})`;
    if (!solvers.length) return;
    for (const panel of this.panels) {
      element("shown").append(this.choice("checkbox", panel.solver.name, true, (checked) => {
        this.toggle(this.state.hidden, panel, !checked);
        this.arrange();
      }));
    }
    element("frame").max = this.last;
    element("frame").addEventListener("input", () => {
      this.play(false);
      this.change({ frame: Number(element("frame").value) });
    });
    element("play").addEventListener("click", () => this.play(!this.playing));
  }

  choice(type, name, checked, act) {
    const label = document.createElement("label"), input = label.appendChild(document.createElement("input"));
    Object.assign(input, { type, checked, name: type === "radio" ? "colour" : name });
    input.addEventListener("change", () => act(input.checked));
    label.append(name);
    return label;
  }

  toggle(set, value, there) {
    set[there ? "add" : "delete"](value);
    this.change({});
  }

  // Chooses the number of columns that makes the pictures largest.
  arrange() {
    const width = this.views.clientWidth, most = Math.max(HEIGHT * innerHeight, 300);
    const count = Math.max(1, this.panels.length - this.state.hidden.size);
    const rows = (columns) => Math.ceil(count / columns);
    const side = (columns) => Math.min(width / columns, most / rows(columns) - HEADING);
    let columns = 1;
    for (let more = 2; more <= Math.min(count, width / NARROWEST); ++more) if (side(more) > side(columns)) columns = more;
    const height = Math.round(rows(columns) * (side(columns) + HEADING));
    this.views.style.height = `${height}px`;
    for (const panel of this.panels) {
      panel.box.style.display = this.state.hidden.has(panel) ? "none" : "";
      panel.box.style.flexBasis = `${100 / columns}%`;
      panel.box.style.height = `${100 / rows(columns)}%`;
    }
    this.renderer.setPixelRatio(devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.move();
  }

  // Draws the surface anew.
  move() {
    this.taps = 1;
    this.surfaceIsDrawn = false;
    this.stir();
  }

  // Draws coarsely, and finely after REST milliseconds without changes.
  stir() {
    this.rests = false;
    clearTimeout(this.resting);
    this.resting = setTimeout(() => {
      if (this.playing) return this.stir();
      this.rests = true;
      this.surfaceIsDrawn &&= this.taps === FINE;
      this.taps = FINE;
      this.draw();
    }, REST);
    this.draw();
  }

  change(changes) {
    if (changes.colour) this.surfaceIsDrawn = false;
    Object.assign(this.state, changes);
    for (const panel of this.panels) panel.update(this.state);
    if (this.last) {
      const { frame } = this.state;
      element("frame").value = frame;
      element("progress").textContent = `${(100 * frame / this.last).toFixed(0)}% of the vertices`;
    }
    this.stir();
  }

  play(on) {
    this.playing = on;
    element("play").innerHTML = on ? "&#10074;&#10074;" : "&#9654;";
    element("play").setAttribute("aria-label", on ? "Pause" : "Play");
    if (!on) return;
    if (this.state.frame >= this.last) this.change({ frame: 0 });
    const begin = performance.now(), from = this.state.frame;
    const step = (now) => {
      if (!this.playing) return;
      const frame = Math.min(this.last, from + Math.max(0, Math.floor((now - begin) / 1000 * FRAMES_A_SECOND)));
      if (frame !== this.state.frame) this.change({ frame });
      if (frame < this.last) requestAnimationFrame(step);
      else this.play(false);
    };
    requestAnimationFrame(step);
  }

  // Draws at the next repaint, once for all changes until then.
  draw() {
    document.body.dataset.rests = false;
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.drawNow();
    });
  }

  drawNow() {
    const canvas = this.renderer.domElement.getBoundingClientRect(), ratio = devicePixelRatio;
    this.renderer.setScissor(0, 0, canvas.width, canvas.height);
    this.renderer.clear();
    for (const panel of this.panels) {
      if (this.state.hidden.has(panel)) continue;
      const stage = panel.stage.getBoundingClientRect();
      const left = Math.round(stage.left - canvas.left), below = Math.round(canvas.bottom - stage.bottom);
      const width = Math.floor(stage.width), height = Math.floor(stage.height);
      if (width < 1 || height < 1) continue;
      this.drawSurface(Math.ceil(width * ratio), Math.ceil(height * ratio));
      this.renderer.setViewport(left, below, width, height);
      this.renderer.setScissor(left, below, width, height);
      const { uniforms } = panel.paint.material;
      uniforms.taps.value = this.taps;
      uniforms.samples.value = this.rests ? this.taps : 1;
      uniforms.corner.value.set(Math.floor(left * ratio), Math.floor(below * ratio));
      const ofCells = this.state.colour === "cells";
      panel.world.add(ofCells ? this.marksOfCells : this.marks);
      (ofCells ? this.marks : this.marksOfCells)?.removeFromParent();
      for (const name of this.layers.keys()) {
        if (this.state.shown.has(name)) panel.world.add(this.layer(name));
        else this.layers.get(name)?.removeFromParent();
      }
      this.renderer.render(panel.world, this.camera);
    }
    document.body.dataset.rests = this.rests;
  }

  // Draws the surface once for all pictures, which have the same size.
  drawSurface(width, height) {
    if (this.surfaceIsDrawn) return;
    this.surfaceIsDrawn = true;
    pixels.value.set(width, height);
    this.fit(width / height);
    this.surface.draw(this.renderer, this.camera, { width, height }, this.taps, this.state.colour === "cells");
  }

  fit(aspect) {
    this.camera.fov = 2 * Math.atan(HALF_VIEW / Math.min(aspect, 1)) * 180 / Math.PI;
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input, button, summary")) return;
    const step = (by) => this.last && this.change({ frame: Math.min(Math.max(this.state.frame + by, 0), this.last) });
    const acts = {
      ArrowLeft: () => this.turn(-TURN, 0), ArrowRight: () => this.turn(TURN, 0),
      ArrowUp: () => this.turn(0, -TURN), ArrowDown: () => this.turn(0, TURN),
      "+": () => this.approach(0.9), "=": () => this.approach(0.9), "-": () => this.approach(1 / 0.9),
      "0": () => this.controls.reset(), ",": () => step(-1), ".": () => step(1),
      " ": () => this.last && this.play(!this.playing),
    };
    if (!acts[event.key]) return;
    acts[event.key]();
    event.preventDefault();
  }

  // Moves the camera around the model, like dragging.
  turn(around, down) {
    const { position, up } = this.camera, { target } = this.controls;
    const upright = new THREE.Quaternion().setFromUnitVectors(up, new THREE.Vector3(0, 1, 0));
    const offset = position.clone().sub(target).applyQuaternion(upright);
    const sphere = new THREE.Spherical().setFromVector3(offset);
    sphere.theta += around;
    sphere.phi += down;
    sphere.makeSafe();
    position.setFromSpherical(sphere).applyQuaternion(upright.invert()).add(target);
    this.controls.update();
  }

  approach(factor) {
    const { target } = this.controls;
    this.camera.position.sub(target).multiplyScalar(factor).add(target);
    this.controls.update();
  }
}

function start() {
  const context = document.createElement("canvas").getContext("webgl2");
  if (!context) {
    return fail("This browser shows no WebGL 2, with which the page draws: turn it on, or try another browser.");
  }
  const scene = JSON.parse(element("scene").textContent);
  unpack(scene);
  const names = context.getExtension("WEBGL_debug_renderer_info");
  const renderer = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  new Page(scene, /swiftshader|llvmpipe|software/i.test(renderer));
}

try {
  start();
} catch (error) {
  fail(`The page cannot be shown: ${error.message}`);
}
