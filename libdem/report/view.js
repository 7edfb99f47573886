// The view of a report: bodies of one frame after the other, as instances of spheres and meshes, coloured by what they
// do. Reads the JSON of #data (libdem/report/view_data.cpp), needs three.js and its OrbitControls in THREE.
// A frame and a colouring can be asked for in the address: report.html#frame=3&colour=force
'use strict';
(function () {
  const byId = (id) => document.getElementById(id);
  const data = JSON.parse(byId('data').textContent);
  const canvas = byId('canvas');

  // ---- what was packed ----
  const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const bodies = {
    id: data.bodies.id,
    shape: new Uint32Array(bytesOf(data.bodies.shape)),
    species: new Uint32Array(bytesOf(data.bodies.species)),
    size: new Float32Array(bytesOf(data.bodies.size)),
    diameter: new Float32Array(bytesOf(data.bodies.diameter)),
  };
  const unpacked = data.frames.map(() => null);
  function frameOf(index) {
    if (unpacked[index]) return unpacked[index];
    const packed = data.frames[index];
    const frame = { shown: new Uint32Array(bytesOf(packed.shown)), places: new Uint16Array(bytesOf(packed.places)) };
    if (packed.turns) frame.turns = new Int16Array(bytesOf(packed.turns));
    for (const name of Object.keys(data.scales)) frame[name] = new Uint16Array(bytesOf(packed[name]));
    unpacked[index] = frame;
    return frame;
  }
  const width = data.upper.map((u, k) => u - data.lower[k]);

  // ---- colours ----
  const stops = [[72, 66, 150], [64, 96, 160], [50, 123, 163], [39, 148, 157], [38, 173, 139], [72, 194, 112],
    [126, 211, 80], [188, 223, 56], [253, 231, 37]];
  function sequential(t) {
    const at = Math.min(Math.max(t, 0), 1) * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
    return stops[k].map((c, i) => (c + (stops[k + 1][i] - c) * (at - k)) / 255);
  }
  const distinct = [[76, 120, 168], [245, 133, 24], [84, 162, 75], [228, 87, 86], [114, 183, 178], [238, 202, 59],
    [178, 121, 162], [255, 157, 166], [157, 117, 93], [150, 150, 150]].map((c) => c.map((x) => x / 255));
  const css = (c) => 'rgb(' + c.map((x) => Math.round(255 * x)).join(',') + ')';
  const range = (list) => {
    let lower = Infinity, upper = -Infinity;
    for (const v of list) { lower = Math.min(lower, v); upper = Math.max(upper, v); }
    return lower > upper ? [0, 0] : [lower, upper];
  };
  const share = (v, [lower, upper]) => (upper > lower ? (v - lower) / (upper - lower) : 0);
  const colourings = {};
  for (const [name, scale] of Object.entries(data.scales)) {
    const top = scale.top || scale.largest;
    colourings[name] = {
      label: scale.label,
      ends: [0, top], clipped: scale.largest > top,
      of: (frame, k) => sequential(top > 0 ? frame[name][k] / 65535 * scale.largest / top : 0),
    };
  }
  const sizes = range(bodies.diameter), ids = range(bodies.id);
  colourings.size = { label: 'diameter (m)', ends: sizes, of: (f, k) => sequential(share(bodies.diameter[f.shown[k]], sizes)) };
  // Categories, of those that bodies have.
  function categories(label, names, values) {
    const has = new Set(values), used = [...names.keys()].filter((i) => has.has(i));
    const rank = new Map(used.map((value, i) => [value, i]));
    return {
      label, names: used.map((i) => names[i]),
      of: (f, k) => distinct[rank.get(values[f.shown[k]]) % distinct.length],
    };
  }
  const families = [...new Set(data.shapes.map((s) => s.family))];
  const familyOf = data.shapes.map((s) => families.indexOf(s.family));
  colourings.species = categories('species', ['none'].concat(data.species), bodies.species);
  colourings.shape = categories('shape', families, bodies.shape.map((s) => familyOf[s]));
  for (const band of data.bands)
    colourings[band.name] = categories(band.label, ['none'].concat(band.names), new Uint32Array(bytesOf(band.of)));
  colourings.id = { label: 'id', ends: ids, of: (f, k) => sequential(share(bodies.id[f.shown[k]], ids)) };

  // ---- the scene ----
  const scene = new THREE.Scene();
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  } catch (error) {
    return;  // no WebGL: the still picture stays
  }
  byId('instead').hidden = true;
  byId('view').hidden = false;
  const up = new THREE.Vector3(...data.up);
  const centre = new THREE.Vector3(...data.lower.map((l, k) => l + 0.5 * width[k]));
  const radius = 0.5 * Math.hypot(...width) || 1;
  const camera = new THREE.PerspectiveCamera(30, 1, radius / 200, radius * 60);
  camera.up.copy(up);
  const sideways = data.dimension === 2 ? new THREE.Vector3(0, 0, 1)
    : new THREE.Vector3(0.45, -1, 0).addScaledVector(up, -new THREE.Vector3(0.45, -1, 0).dot(up)).normalize()
      .addScaledVector(up, 0.38).normalize();
  camera.position.copy(centre).addScaledVector(sideways, radius / Math.sin(Math.PI / 12));
  scene.add(new THREE.HemisphereLight(0xffffff, 0x8f98a5, 0.62));
  const lamp = new THREE.DirectionalLight(0xffffff, 0.42);
  scene.add(lamp);
  scene.add(lamp.target);
  renderer.setPixelRatio(window.devicePixelRatio || 1);
  canvas.appendChild(renderer.domElement);

  function geometryOf(mesh) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(bytesOf(mesh.points)), 3));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytesOf(mesh.triangles)), 1));
    const flat = geometry.toNonIndexed();  // so that faces stay flat
    flat.computeVertexNormals();
    return flat;
  }
  // Normals of bodies that are stretched: this version of three.js turns them as if they were not.
  function asStretched(shader) {
    shader.vertexShader = shader.vertexShader.replace('#include <defaultnormal_vertex>',
      THREE.ShaderChunk.defaultnormal_vertex.replace('transformedNormal = mat3( instanceMatrix ) * transformedNormal;',
        'mat3 m = mat3(instanceMatrix);\n' +
        'transformedNormal = m * (transformedNormal / vec3(dot(m[0], m[0]), dot(m[1], m[1]), dot(m[2], m[2])));'));
  }
  const material = new THREE.MeshLambertMaterial({ vertexColors: THREE.VertexColors === undefined ? true : THREE.VertexColors });
  material.onBeforeCompile = asStretched;

  // One set of instances for each mesh and one for round bodies, each large enough for every frame.
  const partsOf = data.shapes.map((s) => s.parts.map((p) => ({
    mesh: p.mesh, own: p.own, size: new THREE.Vector3(...p.size), centre: new THREE.Vector3(...p.centre),
    turn: new THREE.Quaternion(p.turn[1], p.turn[2], p.turn[3], p.turn[0]),
  })));
  const sets = new Map();
  const most = new Map();
  data.frames.forEach((_, index) => {
    const here = new Map();
    for (const b of frameOf(index).shown)
      for (const p of partsOf[bodies.shape[b]]) here.set(p.mesh, (here.get(p.mesh) || 0) + 1);
    here.forEach((n, mesh) => most.set(mesh, Math.max(n, most.get(mesh) || 0)));
  });
  most.forEach((count, mesh) => {
    const detail = count > 4000 ? [12, 8] : count > 800 ? [20, 14] : [32, 22];
    const geometry = mesh < 0 ? new THREE.SphereBufferGeometry(1, ...detail) : geometryOf(data.meshes[mesh]);
    const colours = new THREE.InstancedBufferAttribute(new Float32Array(3 * count), 3);
    geometry.setAttribute('color', colours);
    const instances = new THREE.InstancedMesh(geometry, material, count);
    instances.frustumCulled = false;
    scene.add(instances);
    sets.set(mesh, { instances, colours, used: 0 });
  });

  const wallMaterial = new THREE.MeshLambertMaterial({
    color: 0x8aa0b8, transparent: true, opacity: 0.22, side: THREE.DoubleSide, depthWrite: false,
  });
  const lineMaterial = new THREE.LineBasicMaterial({ color: 0x5b6b80, transparent: true, opacity: 0.55 });
  const wallGroup = new THREE.Group();
  scene.add(wallGroup);
  const walls = data.walls.map((wall) => {
    if (!wall) return null;
    const geometry = geometryOf(wall), object = new THREE.Group();
    object.add(new THREE.Mesh(geometry, wallMaterial));
    object.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 20), lineMaterial));
    wallGroup.add(object);
    return object;
  });
  const cell = new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.BoxBufferGeometry(1, 1, 1)), lineMaterial);
  scene.add(cell);

  // ---- a frame ----
  const place = new THREE.Vector3(), turn = new THREE.Quaternion(), matrix = new THREE.Matrix4();
  const partPlace = new THREE.Vector3(), partTurn = new THREE.Quaternion(), partSize = new THREE.Vector3();
  function showFrame(index) {
    const frame = frameOf(index), packed = data.frames[index], colouring = colourings[state.colour];
    sets.forEach((set) => { set.used = 0; });
    for (let k = 0; k < frame.shown.length; ++k) {
      const b = frame.shown[k], colour = colouring.of(frame, k);
      place.set(...data.lower.map((l, i) => l + width[i] * frame.places[3 * k + i] / 65535));
      turn.set(0, 0, 0, 1);
      if (frame.turns)
        turn.set(...[1, 2, 3, 0].map((i) => frame.turns[4 * k + i] / 32767)).normalize();
      for (const part of partsOf[bodies.shape[b]]) {
        const set = sets.get(part.mesh), scale = bodies.size[3 * b];
        partPlace.copy(part.centre).multiplyScalar(scale).applyQuaternion(turn).add(place);
        partTurn.copy(turn).multiply(part.turn);
        if (part.own) partSize.set(bodies.size[3 * b], bodies.size[3 * b + 1], bodies.size[3 * b + 2]);
        else partSize.copy(part.size).multiplyScalar(scale);
        matrix.compose(partPlace, partTurn, partSize).toArray(set.instances.instanceMatrix.array, 16 * set.used);
        set.colours.array.set(colour, 3 * set.used);
        ++set.used;
      }
    }
    sets.forEach((set) => {
      set.instances.count = set.used;
      set.instances.visible = set.used > 0;
      set.instances.instanceMatrix.needsUpdate = true;
      set.colours.needsUpdate = true;
    });
    walls.forEach((wall, i) => {
      if (!wall) return;
      const pose = packed.walls[i];
      wall.visible = !!pose;
      if (!pose) return;
      wall.position.set(pose[0], pose[1], pose[2]);
      wall.quaternion.set(pose[4], pose[5], pose[6], pose[3]);
    });
    cell.visible = !!packed.cell;
    if (packed.cell) {
      cell.scale.set(...[0, 1, 2].map((k) => packed.cell[1][k] - packed.cell[0][k] || 1e-9 * radius));
      cell.position.set(...[0, 1, 2].map((k) => 0.5 * (packed.cell[1][k] + packed.cell[0][k])));
    }
    const shown = frame.shown.length;
    byId('clock').textContent = 't = ' + packed.time.toPrecision(5) + ' s, ' + packed.bodies + ' bodies' +
      (shown < packed.bodies ? ' (' + shown + ' shown)' : '');
    document.body.dataset.bodies = packed.bodies;
    document.body.dataset.shown = shown;
    document.body.dataset.frame = index;
    legend(colouring);
    draw();
  }
  const shortly = (v) => (v === 0 ? '0' : Math.abs(v) >= 1e5 || Math.abs(v) < 1e-3 ? v.toExponential(2) : String(+v.toPrecision(4)));
  function legend(colouring) {
    const box = byId('legend');
    box.textContent = '';
    const add = (parent, kind, name, text) => {
      const element = document.createElement(kind);
      element.className = name;
      if (text !== undefined) element.textContent = text;
      parent.appendChild(element);
      return element;
    };
    add(box, 'div', 'label', colouring.label);
    if (colouring.names) {
      const most = 14;
      colouring.names.slice(0, most).forEach((name, i) => {
        const row = add(box, 'div', 'row');
        add(row, 'span', 'swatch').style.background = css(distinct[i % distinct.length]);
        add(row, 'span', 'name', name);
      });
      if (colouring.names.length > most) add(box, 'div', 'row', 'and ' + (colouring.names.length - most) + ' more');
      return;
    }
    const steps = stops.map((_, i) => css(sequential(i / (stops.length - 1))));
    add(box, 'span', 'bar').style.background = 'linear-gradient(to top,' + steps.join(',') + ')';
    const ends = add(box, 'span', 'ends');
    add(ends, 'span', 'end', (colouring.clipped ? '≥ ' : '') + shortly(colouring.ends[1]));
    add(ends, 'span', 'end', shortly(colouring.ends[0]));
  }

  // ---- controls ----
  const controls = new THREE.OrbitControls(camera, renderer.domElement);
  controls.target.copy(centre);
  controls.screenSpacePanning = true;
  function draw() {
    lamp.position.copy(camera.position).addScaledVector(up, radius);
    lamp.target.position.copy(controls.target);
    renderer.render(scene, camera);
    document.body.dataset.triangles = renderer.info.render.triangles;
  }
  function resize() {
    const w = canvas.clientWidth, h = canvas.clientHeight;
    camera.aspect = w / h;
    camera.updateProjectionMatrix();
    renderer.setSize(w, h);
    draw();
  }
  const asked = new URLSearchParams(location.hash.slice(1));
  const last = data.frames.length - 1;
  const state = { frame: last, colour: Object.keys(colourings)[0] };
  if (asked.has('frame')) state.frame = Math.min(Math.max(0, parseInt(asked.get('frame'), 10) || 0), last);
  if (asked.get('colour') in colourings) state.colour = asked.get('colour');
  const choice = byId('colour');
  for (const name of Object.keys(colourings)) choice.add(new Option(colourings[name].label, name));
  choice.value = state.colour;
  choice.onchange = () => { state.colour = choice.value; showFrame(state.frame); };
  const slider = byId('time');
  slider.max = last;
  slider.value = state.frame;
  slider.oninput = () => { state.frame = +slider.value; showFrame(state.frame); };
  byId('walls').onchange = (event) => { wallGroup.visible = event.target.checked; draw(); };
  let timer = 0;
  byId('play').onclick = () => {
    if (timer) {
      clearInterval(timer);
      timer = 0;
    } else {
      timer = setInterval(() => {
        state.frame = (state.frame + 1) % data.frames.length;
        slider.value = state.frame;
        showFrame(state.frame);
      }, 120);
    }
    byId('play').textContent = timer ? 'stop' : 'play';
  };
  controls.addEventListener('change', draw);
  window.addEventListener('resize', resize);
  byId('controls').hidden = false;
  controls.update();
  showFrame(state.frame);
  resize();
  document.body.dataset.view = 'three';
})();
