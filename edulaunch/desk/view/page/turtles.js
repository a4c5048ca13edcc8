/* Turtles and robots in their worlds, from above. */

const MARK_EVERY_PX = 70, CANVAS_M = 11.088889, GONE_S = 0.1, JUMP_M = 0.5;
const SHELLS = [[112, 173, 88], [236, 152, 70], [204, 74, 62], [158, 126, 190], [64, 176, 172], [240, 206, 72]];
const MARKS = ['', '●', '▲', '■', '◆', '✚'];
const TURN = 2 * Math.PI, ANGLES = 60, MOST_NAMED = 14;
const rgb = (colour, alpha = 1) => `rgba(${colour.join()},${alpha})`;

/* A turtle or robot with its poses from its pose or odometry topic. */
class Mover {
  constructor(store, topic, world, number) {
    Object.assign(this, { store, topic, world, number, walked: 0 });
    const robot = topic.type === 'nav_msgs/msg/Odometry';
    this.path = topic.name.replace(/\/(pose|odom)$/, '') || topic.name;
    this.name = robot ? (this.path === '/odom' ? 'robot' : this.path.slice(1)) : this.path.split('/').pop();
    const columns = robot ? ['pose.pose.position.x', 'pose.pose.position.y'] : ['x', 'y'];
    [this.x, this.y] = columns.map(path => topic.column(path));
    this.robot = robot;
    if (!robot) this.theta = topic.column('theta');
  }
  heading(number) {
    if (!this.robot) return this.theta.a[number];
    const of = axis => this.topic.value('pose.pose.orientation.' + axis, number);
    return 2 * Math.atan2(of('z'), of('w'));
  }
  /* Return the pose at a time, interpolated between two messages, or null if the turtle or robot did not exist. */
  at(time) {
    const stamps = this.topic.t, i = this.topic.at(time);
    if (i < 0) return stamps.n && stamps.a[0] - time < 0.05 ? this.row(0) : null;
    if (time - stamps.a[i] >= GONE_S) return null;
    const here = this.row(i);
    if (i + 1 >= stamps.n || stamps.a[i + 1] - stamps.a[i] >= GONE_S) return here;
    const next = this.row(i + 1);
    if (Math.abs(next.x - here.x) + Math.abs(next.y - here.y) > JUMP_M) return here;
    const part = (time - stamps.a[i]) / (stamps.a[i + 1] - stamps.a[i]);
    const turn = Math.atan2(Math.sin(next.a - here.a), Math.cos(next.a - here.a));
    return { x: here.x + part * (next.x - here.x), y: here.y + part * (next.y - here.y), a: here.a + part * turn };
  }
  row(i) {
    const [x, y] = this.point(i);
    return { x, y, a: this.heading(i) + (this.base ? this.base.a : 0) };
  }
  /* Convert to the frame of the world, which may be a static ancestor of the robot's own frame. */
  point(i) {
    const x = this.x.a[i], y = this.y.a[i], { base } = this;
    return base ? [base.x + x * Math.cos(base.a) - y * Math.sin(base.a), base.y + x * Math.sin(base.a) + y * Math.cos(base.a)] : [x, y];
  }
  /* Return the outline from above: from the description in its namespace or the nearest parent, otherwise from a footprint. */
  outline() {
    const mine = this.topic.name.replace(/\/[^/]*$/, '');
    const near = this.store.robots.filter(row => row.described ? `${mine}/`.startsWith(`${row.name}/`) : row.name.startsWith(`${mine}/`));
    near.sort((one, two) => two.described - one.described || (two.described ? two.name.length - one.name.length : 0) || two.t - one.t);
    return near[0]?.parts;
  }
}

/* Return the topmost static ancestor of a frame, and the pose of the frame in it. */
function stillRoot(store, frame) {
  let pose = IDENTITY;
  const above = new Map([...store.tracks.values()].filter(track => track.fixed && track.c[0].n).map(track => [track.child, track]));
  for (let steps = 0; above.has(frame) && steps < 100; steps++) {
    const track = above.get(frame);
    pose = product(track.transform(track.c[0].n - 1), pose);
    frame = track.parent;
  }
  return { root: frame, base: { x: pose.p[0], y: pose.p[1], a: yawOf(pose.q) } };
}

/* Return the worlds of a store: a window for each turtlesim node, and a field for each robot or for all robots with a common static frame. */
function readWorlds(store) {
  const windows = new Map();
  for (const topic of store.topics.values()) {
    const turtle = topic.type === 'turtlesim/msg/Pose' && topic.name.endsWith('/pose');
    if ((!turtle && topic.type !== 'nav_msgs/msg/Odometry') || !topic.t.n) continue;
    const end = store.endpoints.find(row => row.kind === 'publisher' && row.name === topic.name && row.type === topic.type);
    const owner = end ? store.nodeName(end.node) : topic.name;
    const frame = turtle ? '' : topic.value('header.frame_id', 0) || 'odom', { root, base } = turtle ? {} : stillRoot(store, frame);
    const key = turtle ? owner : `robots in ${root}`;
    if (!windows.has(key)) windows.set(key, { title: key, kind: turtle ? 'turtlesim' : 'robot', node: owner, frame: root, movers: [] });
    const world = windows.get(key);
    world.movers.push(Object.assign(new Mover(store, topic, world, world.movers.length), { base, frame }));
  }
  for (const world of windows.values()) {
    if (world.kind === 'robot' && world.movers.length === 1) {  /* a single robot is shown at its own odometry pose */
      const [mover] = world.movers;
      Object.assign(world, { title: mover.topic.name, frame: mover.frame });
      mover.base = null;
      mover.name = 'robot';
    }
    for (const mover of world.movers) if (mover.robot) mover.parts = mover.outline();
  }
  const worlds = [...windows.values()].sort((a, b) => (a.kind === b.kind ? a.title.localeCompare(b.title) : a.kind === 'turtlesim' ? -1 : 1));
  for (const world of worlds) world.movers.forEach(mover => { mover.pens = world.kind === 'turtlesim' ? pensOf(store, mover) : [ROBOT_PEN]; });
  for (const world of worlds) world.wipes = wipesOf(store, world);
  return worlds;
}

const FIRST_PEN = { t: -1, colour: [179, 184, 255], width: 3, off: false };
const ROBOT_PEN = { t: -1, colour: [196, 78, 10], width: 3, off: false };

function pensOf(store, mover) {
  const pens = [FIRST_PEN];
  for (const call of store.calls) {
    if (!call?.served || call.service !== mover.path + '/set_pen') continue;
    const [r, g, b, width, off] = call.request, last = pens[pens.length - 1];
    pens.push(off ? { ...last, t: call.t, off: true } : { t: call.t, colour: [r, g, b], width: width || 1, off: false });
  }
  return pens;
}

function wipesOf(store, world) {
  const namespace = world.node.replace(/\/[^/]*$/, '');
  return store.calls.filter(call => call?.served && [`${namespace}/clear`, `${namespace}/reset`].includes(call.service)).map(call => call.t);
}

class WorldView {
  /* One world on a canvas. Trails have their own layer, so that each frame draws only new parts. */
  constructor(desk, world) {
    Object.assign(this, { desk, world });
    this.figure = make('figure', { class: 'world' });
    this.canvas = make('canvas', { role: 'img', tabindex: 0, 'aria-label': 'turtles' });
    this.layer = document.createElement('canvas');
    this.caption = make('figcaption', {}, world.title);
    this.shut = make('button', { type: 'button', class: 'field', hidden: true, 'aria-expanded': 'false' });
    this.shut.addEventListener('click', () => { this.open = !this.open; desk.redraw(); });
    this.figure.append(this.canvas, this.caption, this.shut);
    this.drawn = { to: -1, key: '' };
    this.canvas.addEventListener('pointerdown', event => this.grab(event));
    this.canvas.addEventListener('pointermove', event => this.hover(event));
    this.canvas.addEventListener('pointerleave', () => { this.over = null; desk.redraw(); });
  }
  folded(ended) {
    const gone = ended !== null;
    this.shut.hidden = !gone;
    this.caption.hidden = gone;
    this.canvas.hidden = gone && !this.open;
    this.figure.classList.toggle('gone', gone && !this.open);
    this.shut.setAttribute('aria-expanded', String(Boolean(this.open)));
    if (gone) this.shut.textContent = `${this.open ? '▾' : '▸'} ${this.world.title} ended at ${ended.toFixed(2)} s`;
  }
  limits() {
    if (this.world.kind === 'turtlesim') return [0, CANVAS_M, 0, CANVAS_M];
    let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const mover of this.world.movers) {
      for (let i = mover.seen || 0; i < mover.topic.t.n; i++) {
        mover.box ??= [Infinity, -Infinity, Infinity, -Infinity];
        const [x, y] = mover.point(i);
        mover.box = [Math.min(mover.box[0], x), Math.max(mover.box[1], x), Math.min(mover.box[2], y), Math.max(mover.box[3], y)];
      }
      mover.seen = mover.topic.t.n;
      [left, right, low, high] = [Math.min(left, mover.box[0]), Math.max(right, mover.box[1]), Math.min(low, mover.box[2]), Math.max(high, mover.box[3])];
    }
    const reach = Math.max(0, ...this.world.movers.flatMap(mover => (mover.parts || []).flatMap(([, corners]) => corners.map(([a, b]) => Math.hypot(a, b)))));
    const half = Math.max(right - left, high - low, 1) * 0.6 + reach, x = (left + right) / 2, y = (low + high) / 2;
    return [x - half, x + half, y - half, y + half];
  }
  resize(side) {
    const ratio = Math.max(1, window.devicePixelRatio || 1), pixels = Math.round(side * ratio);
    if (this.canvas.width === pixels && this.side === side) return;
    this.side = side;
    this.ratio = ratio;
    for (const canvas of [this.canvas, this.layer]) canvas.width = canvas.height = pixels;
    this.canvas.style.width = this.canvas.style.height = side + 'px';
    this.drawn.key = '';
  }
  place(x, y) { return [(x - this.left) * this.scale, this.side - (y - this.low) * this.scale]; }
  background(time) {
    if (this.world.kind !== 'turtlesim') return this.desk.colours.field;
    const part = (name, usual) => this.desk.store.parameter(this.world.node, 'background_' + name, time)?.value ?? usual;
    return rgb([part('r', 69), part('g', 86), part('b', 255)]);
  }
  draw(time) {
    const [left, right, low] = this.limits();
    [this.left, this.low, this.scale] = [left, low, this.side / (right - left)];
    const pen = this.canvas.getContext('2d');
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    pen.fillStyle = this.background(time);
    pen.fillRect(0, 0, this.side, this.side);
    if (this.world.kind === 'robot') this.grid(pen, right - left);
    if (this.desk.isTurn || !this.drawn.key || time < this.drawn.to) this.trails(time);
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.drawImage(this.layer, 0, 0);
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.here = this.world.movers.map(mover => ({ mover, pose: mover.at(time) })).filter(entry => entry.pose);
    if (this.held) this.here.forEach(entry => { if (entry.mover === this.held.mover) entry.pose = this.held.pose; });
    if (this.world.kind === 'robot') this.scan(pen, time);
    this.taken = [];
    for (const { mover, pose } of this.here) this.body(pen, mover, pose);
    if (this.desk.options.axes) this.axes(pen, time);
    this.names(pen);
    if (!this.desk.isTimeToTell(this)) return this.here;
    const said = this.here.map(({ mover, pose }) => `${mover.name} at (${pose.x.toFixed(2)}, ${pose.y.toFixed(2)})`).join(', ');
    this.canvas.setAttribute('aria-label', `${this.world.title} at ${time.toFixed(2)} seconds: ${said || 'empty'}`);
    return this.here;
  }
  /* Draw the trails up to a time on the layer: only the new part, or everything after going back, a wipe or a change of size. */
  trails(time) {
    const pen = this.layer.getContext('2d'), since = Math.max(-1, ...this.world.wipes.filter(wipe => wipe <= time));
    const key = [this.side, this.left, this.scale, since, this.desk.options.colours, this.world.movers.map(mover => mover.pens.length)].join();
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    if (key !== this.drawn.key || time < this.drawn.to) {
      pen.clearRect(0, 0, this.side, this.side);
      this.drawn = { key, to: -1 };
    }
    const from = Math.max(since, this.drawn.to);
    if (this.drawn.to < 0 || since > this.drawn.to) for (const mover of this.world.movers) mover.walked = 0;
    for (const mover of this.world.movers) this.trail(pen, mover, from, time);
    this.drawn.to = time;
  }
  trail(pen, mover, from, time) {
    const stamps = mover.topic.t, last = stamps.upTo(time) - 1;
    let i = Math.max(0, stamps.upTo(from) - 1), which = 0, open = false;
    pen.lineCap = pen.lineJoin = 'round';
    const stones = [];
    for (; i < last; i++) {
      const t = stamps.a[i + 1];
      while (which + 1 < mover.pens.length && mover.pens[which + 1].t <= t) { which++; if (open) { pen.stroke(); open = false; } }
      const { colour, width, off } = mover.pens[which];
      const jump = Math.abs(mover.x.a[i + 1] - mover.x.a[i]) + Math.abs(mover.y.a[i + 1] - mover.y.a[i]) > JUMP_M;
      if (off || (jump && mover.robot) || t - stamps.a[i] >= GONE_S) { if (open) { pen.stroke(); open = false; } continue; }
      if (!open) {
        const own = this.desk.options.colours && mover.pens.length === 1 && this.world.movers.length > 1;
        mover.marks = own ? MARKS[mover.number % MARKS.length] : '';
        pen.strokeStyle = rgb(own ? SHELLS[mover.number % SHELLS.length] : colour);
        pen.lineWidth = Math.max(1, width * this.side / 500);
        pen.beginPath();
        pen.moveTo(...this.place(...mover.point(i)));
        open = true;
      }
      const [x, y] = this.place(...mover.point(i + 1));
      pen.lineTo(x, y);
      if (mover.marks && this.passes(mover, i)) stones.push([x, y]);
    }
    if (open) pen.stroke();
    if (!stones.length) return;
    pen.font = '11px system-ui, sans-serif';
    pen.textAlign = 'center';
    pen.fillStyle = 'rgba(31,41,51,0.85)';
    for (const [x, y] of stones) pen.fillText(mover.marks, x, y + 4);
    pen.textAlign = 'start';
  }
  /* Return whether a trail reaches its next mark between two poses. Marks identify trails without colour. */
  passes(mover, i) {
    const before = Math.floor(mover.walked / MARK_EVERY_PX);
    mover.walked += Math.hypot(mover.x.a[i + 1] - mover.x.a[i], mover.y.a[i + 1] - mover.y.a[i]) * this.scale;
    return Math.floor(mover.walked / MARK_EVERY_PX) > before;
  }
  grid(pen, width) {
    const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50].find(size => width / size < 9) || 100;
    pen.strokeStyle = this.desk.colours.grid;
    pen.fillStyle = this.desk.colours.soft;
    pen.font = '10px sans-serif';
    pen.lineWidth = 1;
    for (let value = Math.ceil(this.left / step) * step; value < this.left + width; value += step) {
      const [x] = this.place(value, 0);
      line(pen, [[x, 0], [x, this.side]]);
      pen.fillText(+value.toFixed(2), x + 2, this.side - 3);
    }
    for (let value = Math.ceil(this.low / step) * step; value < this.low + width; value += step) {
      const [, y] = this.place(0, value);
      line(pen, [[0, y], [this.side, y]]);
      pen.fillText(+value.toFixed(2), 2, y - 2);
    }
  }
  scan(pen, time) {
    const tree = this.desk.tree(time), frame = this.world.frame || 'odom';
    for (const scans of this.desk.store.scans.values()) {
      const found = scans.filter(scan => scan.time <= time && time - scan.time < 1).pop();
      const pose = found && tree.seenFrom(frame).get(found.frame);
      if (!pose) continue;
      pen.fillStyle = this.desk.colours.lit;
      found.ranges.forEach((range, i) => {
        if (range === null) return;
        const angle = found.angle + i * found.step + yawOf(pose.q);
        const [x, y] = this.place(pose.p[0] + range / 100 * Math.cos(angle), pose.p[1] + range / 100 * Math.sin(angle));
        pen.fillRect(x - 1, y - 1, 2, 2);
      });
    }
  }
  body(pen, mover, { x, y, a }) {
    const size = this.world.kind === 'turtlesim' ? this.side / 9.5 : Math.min(Math.max(this.scale * 0.4, 22), this.side / 8);
    const colour = SHELLS[mover.number % SHELLS.length];
    const [px, py] = this.place(x, y), draw = mover.robot ? drawRobot : drawTurtle;
    if (this.isCrowd && !mover.parts) {
      const sheet = this.stamp(draw, colour, size, true), edge = sheet.height, side = edge / this.ratio, whole = value => Math.round((value - side / 2) * this.ratio) / this.ratio;
      const angle = (Math.round(a / TURN * ANGLES) % ANGLES + ANGLES) % ANGLES;
      pen.drawImage(sheet, angle * edge, 0, edge, edge, whole(px), whole(py), side, side);
      return;
    }
    pen.save();
    pen.translate(px, py);
    pen.rotate(-a);
    if (mover.parts) this.shape(pen, mover.parts, colour);
    else {
      const stamp = this.stamp(draw, colour, size), side = stamp.width / this.ratio;
      pen.drawImage(stamp, -side / 2, -side / 2, side, side);
    }
    pen.restore();
  }
  get isCrowd() { return this.here.length > MOST_NAMED; }
  /* Draw a robot from its description, at its real size. The nose of a small robot is enlarged. */
  shape(pen, parts, colour) {
    const reach = Math.max(...parts.flatMap(([, corners]) => corners.flat().map(Math.abs))), grow = Math.max(1, 15 / (reach * this.scale));
    pen.scale(this.scale, -this.scale);
    for (const [kind, corners] of parts) {
      const nose = kind === 'nose', by = nose ? grow : 1;
      pen.lineWidth = (nose ? 1.6 : 1) / this.scale;
      shape(pen, nose ? rgb(colour) : kind === 'wheel' ? '#1f2933' : 'rgba(76,106,146,0.85)', nose ? '#fff' : '#1f2933', () => {
        for (const [x, y] of corners) pen.lineTo(x * by, y * by);
        pen.closePath();
      });
    }
  }
  /* Draw each colour and size of a body once, because a turtle has twenty lines and there may be a hundred turtles.
     A crowd takes copies from a sheet of all angles in steps of 6 degrees, because the computer copies whole pixels much faster than it turns a picture. */
  stamp(draw, colour, size, turned = false) {
    const key = [draw.name, colour, size, this.ratio, turned].join();
    if (this.stamps?.key !== this.side) this.stamps = { key: this.side, known: new Map() };
    if (!this.stamps.known.has(key)) {
      const canvas = document.createElement('canvas'), pen = canvas.getContext('2d');
      const edge = canvas.width = canvas.height = Math.ceil(size * 1.3 * this.ratio);
      if (turned) {
        const stamp = this.stamp(draw, colour, size);
        canvas.width = edge * ANGLES;
        for (let i = 0; i < ANGLES; i++) {
          pen.setTransform(1, 0, 0, 1, (i + 0.5) * edge, edge / 2);
          pen.rotate(-i / ANGLES * TURN);
          pen.drawImage(stamp, -edge / 2, -edge / 2);
        }
      } else {
        pen.translate(edge / 2, edge / 2);
        pen.scale(size * this.ratio, -size * this.ratio);
        pen.lineWidth = 1 / size;
        draw(pen, colour);
      }
      this.stamps.known.set(key, canvas);
    }
    return this.stamps.known.get(key);
  }
  axes(pen, time) {
    const seen = this.desk.tree(time).seenFrom(this.world.frame || 'world');
    const own = new Set(this.world.movers.map(mover => mover.name));
    const mine = this.world.kind === 'robot' || [...seen.keys()].some(name => own.has(name));
    if (!mine) return;
    for (const [name, pose] of seen) {
      if (name === (this.world.frame || 'world')) continue;
      const [x, y] = this.place(pose.p[0], pose.p[1]), length = 22;
      for (const [axis, colour] of [[[1, 0, 0], '#cc241d'], [[0, 1, 0], '#2e8c30']]) {
        const [dx, dy] = turned(pose.q, axis);
        for (const [style, wide] of [['#fff', 4], [colour, 2]]) {
          pen.strokeStyle = style;
          pen.lineWidth = wide;
          line(pen, [[x, y], [x + dx * length, y - dy * length]]);
        }
      }
      if (!own.has(name)) this.here.push({ label: name, place: [x, y] });
    }
  }
  /* Draw names beside their turtles, and move names that would overlap. In a crowd, draw only the name under the pointer. */
  names(pen) {
    const crowd = this.isCrowd || this.desk.hurry > 1;
    pen.font = '12px system-ui, sans-serif';
    for (const { mover, pose, label, place } of this.here) {
      if (crowd && mover !== this.over) continue;
      const [x, y] = place || this.place(pose.x, pose.y), text = label || `${MARKS[mover.number % MARKS.length]} ${mover.name}`.trim();
      this.name(pen, text, x, y, label ? 12 : this.side / 18);
    }
  }
  name(pen, text, x, y, reach) {
    const width = pen.measureText(text).width + 8, height = 16, { side, taken } = this;
    const ways = [[0, -1], [0, 1], [1, 0], [-1, 0], [1, -1], [-1, -1], [1, 1], [-1, 1]];
    const places = [reach, reach + 14, reach + 28].flatMap(far => ways.map(([dx, dy]) =>
      [x - width / 2 + dx * (far + width / 2), y - height / 2 + dy * (far + height / 2)]));
    const free = ([left, top]) => left >= 0 && top >= 0 && left + width <= side && top + height <= side &&
      !taken.some(([l, t, w, h]) => left < l + w && l < left + width && top < t + h && t < top + height);
    const inside = (value, most) => Math.max(0, Math.min(value, most));
    const [left, top] = places.find(free) || [inside(places[0][0], side - width), inside(places[0][1], side - height)];
    taken.push([left, top, width, height]);
    pen.fillStyle = 'rgba(255,255,255,0.86)';
    pen.fillRect(left, top, width, height);
    pen.fillStyle = '#1f2933';
    pen.fillText(text, left + 4, top + 12);
  }
  under(event) {
    const box = this.canvas.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    const near = (this.here || []).filter(entry => entry.mover).map(entry => {
      const [px, py] = this.place(entry.pose.x, entry.pose.y);
      return { ...entry, far: Math.hypot(px - x, py - y) };
    }).sort((a, b) => a.far - b.far)[0];
    return { x: x / this.scale + this.left, y: (this.side - y) / this.scale + this.low, entry: near?.far < this.side / 14 ? near : null };
  }
  hover(event) {
    const { x, y, entry } = this.under(event);
    if (this.held) {
      this.held.pose = { ...this.held.pose, x, y };
    } else if ((entry?.mover || null) === this.over) return;
    this.over = entry?.mover || null;
    const movable = entry && this.desk.canMove(entry.mover);
    this.canvas.style.cursor = this.held ? 'grabbing' : movable ? 'grab' : '';
    this.canvas.title = entry ? `${entry.mover.path}: x ${entry.pose.x.toFixed(2)}, y ${entry.pose.y.toFixed(2)}, theta ${entry.pose.a.toFixed(2)}` : '';
    this.desk.redraw();
  }
  grab(event) {
    const { entry } = this.under(event);
    this.desk.select(entry?.mover || this.world.movers[0]);
    if (!entry || !this.desk.canMove(entry.mover)) return;
    this.held = { mover: entry.mover, pose: { ...entry.pose } };
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.addEventListener('pointerup', () => {
      const { mover, pose } = this.held;
      this.held = null;
      this.desk.send({ op: 'teleport', turtle: mover.path, x: pose.x, y: pose.y, theta: pose.a });
    }, { once: true });
  }
}

function line(pen, points) {
  pen.beginPath();
  points.forEach(([x, y], i) => i ? pen.lineTo(x, y) : pen.moveTo(x, y));
  pen.stroke();
}

/* Draw many lines of one style in one stroke. */
function strokes(pen, lines, colour, width, dash = []) {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.setLineDash(dash);
  pen.beginPath();
  for (const [from, to] of lines) { pen.moveTo(...from); pen.lineTo(...to); }
  pen.stroke();
  pen.setLineDash([]);
}

function shape(pen, fill, edge, draw) {
  pen.beginPath();
  draw();
  pen.fillStyle = fill;
  pen.strokeStyle = edge;
  pen.fill();
  pen.stroke();
}

function drawTurtle(pen, colour) {
  const shade = part => rgb(colour.map(value => Math.round(value * part))), dark = '#1f2933', skin = 'rgb(243,233,208)';
  const oval = (x, y, rx, ry, turn = 0) => () => pen.ellipse(x, y, rx, ry, turn, 0, 2 * Math.PI);
  for (const side of [1, -1]) {
    shape(pen, skin, dark, oval(0.27, side * 0.33, 0.21, 0.085, side * 0.95));
    shape(pen, skin, dark, oval(-0.28, side * 0.29, 0.16, 0.075, -side * 0.85));
  }
  shape(pen, skin, dark, () => { pen.moveTo(-0.36, 0.06); pen.lineTo(-0.54, 0); pen.lineTo(-0.36, -0.06); pen.closePath(); });
  shape(pen, skin, dark, oval(0.46, 0, 0.155, 0.12));
  shape(pen, shade(1), dark, oval(0, 0, 0.4, 0.34));
  const corner = (r, s, i) => [r * Math.cos(i * Math.PI / 3), s * Math.sin(i * Math.PI / 3)];
  shape(pen, shade(0.82), shade(0.5), () => { for (let i = 0; i < 6; i++) pen.lineTo(...corner(0.19, 0.17, i)); pen.closePath(); });
  for (let i = 0; i < 6; i++) line(pen, [corner(0.19, 0.17, i), corner(0.37, 0.315, i)]);
  for (const side of [1, -1]) shape(pen, dark, dark, oval(0.51, side * 0.062, 0.026, 0.026));
}

function drawRobot(pen, colour) {
  const dark = '#1f2933';
  for (const side of [1, -1]) shape(pen, dark, dark, () => pen.rect(-0.2, side > 0 ? 0.30 : -0.44, 0.4, 0.14));
  shape(pen, 'rgb(76,106,146)', dark, () => pen.ellipse(0, 0, 0.4, 0.36, 0, 0, 2 * Math.PI));
  shape(pen, rgb(colour), dark, () => { pen.moveTo(0.5, 0); pen.lineTo(0.02, 0.2); pen.lineTo(0.12, 0); pen.lineTo(0.02, -0.2); pen.closePath(); });
}
