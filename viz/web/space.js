// The scene, its cells and the ray in space.

class Space {
  constructor(canvas) {
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.localClippingEnabled = true;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 1, 10);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.addEventListener('change', () => this.draw_soon());
    this.controls.addEventListener('change', () => this.on_turn?.());
    this.lo = new THREE.Vector3(...data.bounds[0]), this.hi = new THREE.Vector3(...data.bounds[1]);
    this.radius = this.lo.distanceTo(this.hi) / 2 || 1;
    this.plane = new THREE.Plane();
    this.add_lights();
    this.add_mesh();
    this.cell_lines = this.add(new THREE.LineSegments(
        new THREE.BufferGeometry(), new THREE.LineBasicMaterial({vertexColors: THREE.VertexColors})));
    this.walk = this.add(new THREE.Group());
    this.look_from('side');
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  add(object) {
    this.scene.add(object);
    return object;
  }

  add_lights() {
    for (const [strength, ...place] of [[0.75, -0.6, 0.9, 1], [0.35, 0.8, 0.1, 1]]) {
      const light = new THREE.DirectionalLight(0xffffff, strength);
      light.position.set(...place);
      this.camera.add(light);
    }
    this.scene.add(this.camera, new THREE.AmbientLight(0xffffff, 0.25));
  }

  add_mesh() {
    const {position, corner} = unpacked(data.mesh), points = new Float32Array(position.length);
    for (let i = 0; i < points.length; ++i) {
      const [lo, hi] = [data.bounds[0][i % 3], data.bounds[1][i % 3]];
      points[i] = lo + (hi - lo) * position[i] / 65535;
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
    geometry.setIndex(new THREE.BufferAttribute(corner, 1));
    geometry.computeVertexNormals();
    this.mesh = this.add(new THREE.Mesh(
        geometry,
        new THREE.MeshLambertMaterial(
            {side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1})));
  }

  // 'front' is where rays are picked from; 'side' shows them from aside.
  look_from(where) {
    const focus = new THREE.Vector3(...data.focus), eye = new THREE.Vector3(...data.eye).sub(focus);
    if (where === 'side') eye.applyAxisAngle(new THREE.Vector3(0, 1, 0), -Math.PI * 50 / 180).multiplyScalar(1.18);
    this.camera.near = this.radius / 100, this.camera.far = eye.length() + 50 * this.radius;
    this.camera.position.copy(focus).add(eye);
    this.controls.target.copy(focus);
    this.controls.update();
    this.draw_soon();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.renderer.domElement.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.fov = 30 * Math.max(1, Math.min(2, 1.15 * height / width));  // narrow screens see as much
    this.camera.updateProjectionMatrix();
    for (const line of this.walk.children) line.material.resolution?.set(width, height);
    this.draw_soon();
  }

  draw_soon() {
    if (this.is_due) return;
    this.is_due = true;
    requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.is_due = false;
    this.renderer.render(this.scene, this.camera);
  }

  // Unit vector toward the eye.
  view_axis() { return this.camera.position.clone().sub(this.controls.target).normalize().toArray(); }

  // As a PNG in base64; for tests.
  picture() {
    this.draw();
    return this.renderer.domElement.toDataURL();
  }

  recolor() {
    this.renderer.setClearColor(css('--space'));
    this.mesh.material.color.set(css('--mesh'));
  }

  set_mesh(opacity, cut) {
    const material = this.mesh.material;
    this.mesh.visible = opacity > 0;
    material.opacity = opacity, material.transparent = opacity < 1, material.depthWrite = opacity >= 1;
    material.clippingPlanes = cut ? [cut] : [];
    material.needsUpdate = true;
  }

  // What lies below `position` along the axis; nothing is cut where the axis is -1.
  cut_at(axis, share) {
    if (axis < 0) return null;
    const normal = [0, 0, 0], [lo, hi] = [data.bounds[0][axis], data.bounds[1][axis]];
    normal[axis] = -1;
    this.plane.set(new THREE.Vector3(...normal), lo + (hi - lo) * share);
    return this.plane;
  }

  // `chosen`: indices of cells, `color_of` of one of them as [r, g, b] from 0 to 255.
  set_cells(lines, chosen, color_of) {
    let length = 0;
    for (const i of chosen) length += lines.first[i + 1] - lines.first[i];
    const points = new Float32Array(length), colors = new Uint8Array(length);
    let at = 0;
    for (const i of chosen) {
      const outline = lines.points.subarray(lines.first[i], lines.first[i + 1]), color = color_of(i);
      points.set(outline, at);
      for (let k = 0; k < outline.length; ++k) colors[at + k] = color[k % 3];
      at += outline.length;
    }
    this.cell_lines.geometry.dispose();
    this.cell_lines.geometry = new THREE.BufferGeometry();
    this.cell_lines.geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
    this.cell_lines.geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3, true));
    this.draw_soon();
    return length / 6;
  }

  clear_walk() {
    for (const child of this.walk.children) child.geometry.dispose(), child.material.dispose();
    this.walk.remove(...this.walk.children);
  }

  // Thick lines over all; what lies behind the mesh shines through.
  add_lines(points, color, width) {
    if (points.length === 0) return;
    for (const is_hidden of [true, false]) {
      const geometry = new THREE.LineSegmentsGeometry().setPositions(points);
      const material = new THREE.LineMaterial({
        color: new THREE.Color(color).getHex(),
        linewidth: width,
        depthTest: !is_hidden,
        transparent: is_hidden,
        opacity: is_hidden ? 0.3 : 1,
        depthWrite: !is_hidden
      });
      const {clientWidth, clientHeight} = this.renderer.domElement;
      material.resolution.set(clientWidth, clientHeight);
      const object = new THREE.LineSegments2(geometry, material);
      object.renderOrder = is_hidden ? 2 : 3;
      object.frustumCulled = false;
      this.walk.add(object);
    }
  }

  add_triangles(points, color, opacity) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(points), 3));
    const material = new THREE.MeshBasicMaterial(
        {color, side: THREE.DoubleSide, transparent: true, opacity, depthTest: false, depthWrite: false});
    this.walk.add(Object.assign(new THREE.Mesh(geometry, material), {renderOrder: 1}));
  }

  add_point(place, color, size) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(place), 3));
    const material = new THREE.PointsMaterial({
      color,
      size: size * this.renderer.getPixelRatio(),
      sizeAttenuation: false,
      depthTest: false,
      transparent: true
    });
    this.walk.add(Object.assign(new THREE.Points(geometry, material), {renderOrder: 4}));
  }
}
