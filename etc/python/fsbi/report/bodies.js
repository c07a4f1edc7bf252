// fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies, bonds, walls and paths by three.js: turned, played, chosen.

const BODY_COLOURS = [0xE8A33D, 0x5FB3D9, 0xD98CB3, 0x7FBF7B, 0xB0B0B0];
const PLAY_SECONDS = 10;

function bytes(text) {
    const raw = atob(text);
    const found = new Uint8Array(raw.length);
    for (let i = 0; i < raw.length; ++i) found[i] = raw.charCodeAt(i);
    return found.buffer;
}
const floats = text => new Float32Array(bytes(text));
const whole = text => new Uint32Array(bytes(text));

function solid(points, faces) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
    geometry.setIndex(new THREE.BufferAttribute(faces, 1));
    geometry.computeVertexNormals();
    return geometry;
}

// One body: a fixed surface that moves, or a surface for every time. While it is not
// in the domain its motion is no number, its surface null
function bodyModel(spec, colour, edged, times) {
    const faces = whole(spec.faces);
    const motion = spec.motion ? floats(spec.motion) : null;
    const surfaces = [];
    const there = k => motion ? !isNaN(motion[7 * k]) : spec.frames[k] !== null;
    const first = motion ? 0 : Math.max(0, spec.frames.findIndex(f => f !== null));
    const surface = k => {
        if (motion) k = 0;
        if (!surfaces[k]) {
            const frame = motion ? spec : spec.frames[k];
            surfaces[k] = solid(floats(frame.points), !motion && frame.faces ? whole(frame.faces) : faces);
        }
        return surfaces[k];
    };
    const skin = new THREE.Mesh(surface(first), new THREE.MeshPhongMaterial(
        { color: colour, side: THREE.DoubleSide, shininess: 20, flatShading: edged, polygonOffset: true,
            polygonOffsetFactor: 1, polygonOffsetUnits: 1, opacity: 0.55 }));
    const edges = new THREE.Mesh(surface(first), new THREE.MeshBasicMaterial(
        { color: 0x3a2a10, wireframe: true, transparent: true, opacity: 0.35 }));
    const group = new THREE.Group();
    group.add(skin, edges);
    edges.visible = false;
    skin.userData.name = spec.name;
    const show = k => {
        group.visible = there(k);
        if (!group.visible) return;
        if (motion) {
            const m = motion.subarray(7 * k, 7 * k + 7);
            group.position.set(m[0], m[1], m[2]);
            group.quaternion.set(m[4], m[5], m[6], m[3]);
        } else {
            skin.geometry = edges.geometry = surface(k);
        }
        group.updateMatrixWorld(true);
    };
    // null while it is not there
    const sphere = k => {
        show(k);
        if (!group.visible) return null;
        skin.geometry.computeBoundingSphere();
        return skin.geometry.boundingSphere.clone().applyMatrix4(group.matrixWorld);
    };
    let entry = 0;                          // the first time that it is drawn
    while (entry < times - 1 && !there(entry)) ++entry;
    return { name: spec.name, colour, group, skin, edges, show, sphere, entry };
}

// Bonds as thin rods: blue are pressed, red are pulled
function bondRods(frame, largest, radius) {
    const ends = frame.ends ? floats(frame.ends) : [];
    const points = [], colours = [], faces = [];
    const pressed = new THREE.Color("#2166ac"), none = new THREE.Color("#b9c3cf"),
        pulled = new THREE.Color("#b2182b");
    frame.tension.forEach((tension, i) => {
        const a = new THREE.Vector3(...ends.subarray(6 * i, 6 * i + 3));
        const b = new THREE.Vector3(...ends.subarray(6 * i + 3, 6 * i + 6));
        const along = b.clone().sub(a);
        const side = new THREE.Vector3(1, 0, 0);
        if (Math.abs(along.x) > 0.9 * along.length()) side.set(0, 1, 0);
        side.cross(along).setLength(radius);
        const turn = along.clone().normalize();
        const colour = none.clone().lerp(tension > 0 ? pulled : pressed, Math.min(1, Math.abs(tension) / largest));
        const first = points.length / 3;
        for (let s = 0; s < 6; ++s) {
            const off = side.clone().applyAxisAngle(turn, s * Math.PI / 3);
            for (const end of [a, b]) {
                points.push(end.x + off.x, end.y + off.y, end.z + off.z);
                colours.push(colour.r, colour.g, colour.b);
            }
            const p = first + 2 * s, q = first + 2 * ((s + 1) % 6);
            faces.push(p, p + 1, q, q, p + 1, q + 1);
        }
    });
    const geometry = solid(new Float32Array(points), new Uint32Array(faces));
    geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(colours), 3));
    return geometry;
}

function lines(corners, colour, opacity) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(corners), 3));
    return [geometry, { color: colour, transparent: opacity < 1, opacity }];
}

// The box of the domain, and plane walls near bodies
function wallModel(wall) {
    const group = new THREE.Group();
    const box = new THREE.Box3(new THREE.Vector3(...wall.low), new THREE.Vector3(...wall.high));
    group.add(new THREE.Box3Helper(box, 0xb8c0ca));
    for (const plane of wall.planes) {
        const size = plane.high.map((h, i) => Math.max(h - plane.low[i], 1e-6));
        const sheet = new THREE.Mesh(new THREE.BoxGeometry(...size), new THREE.MeshBasicMaterial(
            { color: 0x9fb0c0, transparent: true, opacity: 0.28, depthWrite: false }));
        sheet.position.set(...plane.high.map((h, i) => (h + plane.low[i]) / 2));
        group.add(sheet);
    }
    return group;
}

function bodies(spec) {
    const element = id => document.getElementById(id);
    const canvas = element("canvas");
    let renderer;
    element("stage").hidden = false;
    try {
        renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    } catch (error) {
        element("stage").hidden = true;
        document.querySelector(".missing").textContent =
            "The bodies are in this page, but this browser has no WebGL to draw them.";
        return null;
    }
    renderer.setClearColor(0xffffff);
    const world = new THREE.Scene();
    const camera = new THREE.PerspectiveCamera(30, 2, 0.01, 1e6);
    const light = new THREE.DirectionalLight(0xffffff, 0.75);
    camera.add(light, light.target);
    light.target.position.set(0, 0, -1);
    light.position.set(0.4, 0.7, 1);
    world.add(camera, new THREE.AmbientLight(0xffffff, 0.45));
    const controls = new THREE.OrbitControls(camera, canvas);

    const models = spec.bodies.map((b, i) => bodyModel(b, BODY_COLOURS[i % 5], "factor" in spec, spec.times.length));
    models.forEach(m => world.add(m.group));
    const last = spec.times.length - 1;
    const size = Math.max(1e-300, ...models.map(m => { const s = m.sphere(m.entry); return s ? s.radius : 0; }));
    const everything = [0, Math.floor(last / 2), last, ...models.map(m => m.entry)].map(around)
        .reduce((a, b) => a.union(b));
    const ways = wayLines(spec, models);
    world.add(ways);
    const walls = spec.walls.map(wallModel);
    walls.forEach(w => world.add(w));
    const largest = Math.max(1e-300, ...spec.bonds.flatMap(f => f ? f.tension.map(Math.abs) : []));
    const rods = spec.bonds.length ? new THREE.Mesh(new THREE.BufferGeometry(),
        new THREE.MeshPhongMaterial({ vertexColors: THREE.VertexColors, side: THREE.DoubleSide })) : null;
    if (rods) {
        rods.frustumCulled = false;
        world.add(rods);
    }

    const state = { frame: -1, playing: false, clock: spec.times[0], chosen: models[0], before: null };

    function around(k) {
        const box = new THREE.Box3();
        for (const m of models) {
            m.show(k);
            if (m.group.visible) box.union(new THREE.Box3().setFromObject(m.group));
        }
        return box;
    }
    function look(box) {
        const sphere = box.getBoundingSphere(new THREE.Sphere());
        const distance = sphere.radius / Math.sin(camera.fov / 2 * Math.PI / 180) * 1.1;
        // at right angles to what is long
        const long = box.getSize(new THREE.Vector3());
        const towards = long.z > 1.5 * long.x ? new THREE.Vector3(1, 0.25, 0.45) : new THREE.Vector3(0.3, 0.18, 1);
        towards.normalize();
        controls.target.copy(sphere.center);
        camera.position.copy(sphere.center).addScaledVector(towards, distance);
        camera.near = distance / 500;
        camera.far = distance * 200;
        camera.updateProjectionMatrix();
        controls.update();
    }
    function reset() {
        const here = around(state.frame);
        look(element("follow").checked && !here.isEmpty() ? here : everything);
        models.forEach(m => m.show(state.frame));
    }
    function show(k) {
        if (k === state.frame) return;
        state.frame = k;
        const time = spec.times[k];
        models.forEach(m => m.show(k));
        if (rods) {
            rods.visible = Boolean(spec.bonds[k]);
            if (rods.visible) rods.geometry = bondRods(spec.bonds[k], largest, 0.012 * size);
        }
        let at = 0;
        spec.walls.forEach((w, i) => { if (w.time <= time * (1 + 1e-6)) at = i; });
        walls.forEach((w, i) => { w.visible = i === at; });
        element("slider").value = k;
        element("clock").textContent = `t = ${short(time)} ${data.time}`;
        follow();
        values(time);
        charts.forEach(c => c.show(time));
    }
    function follow() {
        const sphere = state.chosen.sphere(state.frame);
        const centre = sphere && sphere.center;
        if (element("follow").checked && centre && state.before) {
            const way = centre.clone().sub(state.before);
            camera.position.add(way);
            controls.target.add(way);
        }
        state.before = centre;
    }
    function values(time) {
        const name = state.chosen.name;
        const wanted = ["position", "velocity", "angularVelocity", "centre", "force/fluid", "fluidForce"];
        element("values").textContent = "";
        const table = make("table", {}, element("values"));
        for (const t of data.tables) {
            const [, body, ...rest] = t.path.split("/");
            if (body !== name || !wanted.includes(rest.join("/")) || !t.recorded) continue;
            if (!state.chosen.group.visible) continue;
            const row = nearest(t.values[0], time);
            const line = make("tr", { "data-path": t.path, "data-row": row }, table);
            make("td", {}, line, `${name} ${rest.join(" ")}`);
            make("td", {}, line, t.values.slice(1).map(c => short(c[row])).join("  "));
            make("td", {}, line, `${t.units[1]} at ${short(t.values[0][row])} ${data.time}`);
        }
    }
    function choose(model) {
        state.chosen = model;
        const sphere = model.sphere(Math.max(state.frame, 0));
        state.before = sphere && sphere.center;
        models.forEach((m, i) => element("choices").children[i].classList.toggle("chosen", m === model));
        values(spec.times[Math.max(state.frame, 0)]);
    }
    function play(on) {
        state.playing = on;
        if (on && state.frame >= last) state.clock = spec.times[0];
        element("play").textContent = on ? "Pause" : "Play";
    }
    function pick(event) {
        const place = canvas.getBoundingClientRect();
        const ray = new THREE.Raycaster();
        ray.setFromCamera(new THREE.Vector2((event.clientX - place.left) / place.width * 2 - 1,
            1 - (event.clientY - place.top) / place.height * 2), camera);
        const hit = ray.intersectObjects(models.filter(m => m.group.visible).map(m => m.skin))[0];
        if (hit) choose(models.find(m => m.skin === hit.object));
    }

    let before = null;
    function frame(now) {
        if (state.playing && before !== null) {
            state.clock += (spec.times[last] - spec.times[0]) * (now - before) / 1000 / PLAY_SECONDS;
            let k = state.frame;
            while (k < last && spec.times[k + 1] <= state.clock) ++k;
            if (spec.times[k] > state.clock) k = 0;
            show(k);
            if (k === last) play(false);
        }
        before = now;
        const width = canvas.clientWidth, height = canvas.clientHeight;
        if (canvas.width !== width * devicePixelRatio || canvas.height !== height * devicePixelRatio) {
            renderer.setPixelRatio(devicePixelRatio);
            renderer.setSize(width, height, false);
            camera.aspect = width / height;
            camera.updateProjectionMatrix();
        }
        controls.update();
        renderer.render(world, camera);
        requestAnimationFrame(frame);
    }

    models.forEach(m => {
        const button = make("button", {}, element("choices"));
        make("span", { class: "dot", style: `background:#${m.colour.toString(16).padStart(6, "0")}` }, button);
        button.append(m.name);
        button.onclick = () => choose(m);
    });
    element("slider").max = last;
    element("slider").oninput = event => {
        play(false);
        state.clock = spec.times[event.target.value];
        show(Number(event.target.value));
    };
    element("play").onclick = () => play(!state.playing);
    element("edges").onchange = e => models.forEach(m => { m.edges.visible = e.target.checked; });
    element("glass").onchange = e => models.forEach(m => {
        m.skin.material.transparent = e.target.checked;
        m.skin.material.side = e.target.checked ? THREE.FrontSide : THREE.DoubleSide;
        m.skin.material.needsUpdate = true;
    });
    element("ways").onchange = e => { ways.visible = e.target.checked; };
    element("follow").onchange = reset;
    element("whole").onclick = reset;
    canvas.addEventListener("click", pick);
    tell(spec, largest);
    choose(models[0]);
    element("follow").checked = everything.getBoundingSphere(new THREE.Sphere()).radius > 8 * size;
    show(0);
    reset();
    requestAnimationFrame(frame);
    return { state, camera, models, rods, times: spec.times };
}

function wayLines(spec, models) {
    const group = new THREE.Group();
    models.forEach(m => {
        for (const path of spec.paths[m.name] || []) {
            const [geometry, look] = lines(floats(path), m.colour, 0.9);
            group.add(new THREE.Line(geometry, new THREE.LineBasicMaterial(look)));
        }
    });
    return group;
}

function tell(spec, largest) {
    const told = [];
    if (spec.factor && spec.factor !== 1) told.push(`displacement × ${spec.factor}`);
    if (spec.left_out) told.push(`${spec.left_out} of the saved times are left out, for the page's size`);
    if (spec.bonds.includes(null)) told.push("Bonds are known, and shown, at the saved times");
    told.push("Drag turns, the wheel zooms, the right button moves; a click chooses a body");
    document.getElementById("told").textContent = told.join(". ") + ".";
    if (spec.bonds.length) {
        const box = document.getElementById("tensions");
        box.hidden = false;
        if (largest > 1e-290) {
            box.append(`Bonds: pressed by ${short(largest)} ${data.force}`, make("i", {}),
                `pulled by ${short(largest)} ${data.force}`);
        } else {
            box.append("No saved state has a bond.");
        }
    }
}
