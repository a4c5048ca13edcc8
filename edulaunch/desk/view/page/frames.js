/* The tf frames from above or in 3D relative to a chosen frame, the tf tree, and a manual lookup. */

const MOST_NAMES = 60, FEW = 16, GLYPH_PX = 16;

class FramesView {
  constructor(desk) {
    this.desk = desk;
    this.turn = { yaw: -0.6, pitch: 0.55 };
    this.glyphs = new Map();
    this.widths = new Map();
    this.visible = new Set();
    this.watch = new IntersectionObserver(rows => {
      for (const row of rows) if (row.isIntersecting) this.visible.add(row.target); else this.visible.delete(row.target);
      desk.redraw();
    });
    this.box = make('div', { class: 'pane' });
    this.fixed = make('select', { 'aria-label': 'fixed frame' });
    this.mode = make('select', { 'aria-label': 'projection of the frames' });
    for (const [value, text] of [['3d', 'in 3D'], ['above', 'from above']]) this.mode.append(make('option', { value }, text));
    this.canvas = make('canvas', { role: 'img', tabindex: 0, 'aria-label': 'frames' });
    this.table = make('table', { class: 'small' });
    const bar = make('div', { class: 'tools' });
    bar.append(make('label', {}, 'seen from ', this.fixed), this.mode, make('span', { class: 'soft' }, 'drag to turn, wheel to zoom'));
    this.told = make('div', { class: 'told', 'aria-live': 'polite', hidden: true });
    this.box.append(bar, this.canvas, this.told, this.probe(), this.table);
    this.zoom = 1;
    this.canvas.addEventListener('pointermove', event => {
      if (!event.buttons) return;
      this.turn.yaw -= event.movementX / 150;
      this.turn.pitch = Math.min(1.55, Math.max(-0.2, this.turn.pitch + event.movementY / 150));
      desk.redraw();
    });
    this.canvas.addEventListener('wheel', event => { event.preventDefault(); this.zoom *= event.deltaY < 0 ? 1.1 : 1 / 1.1; desk.redraw(); }, { passive: false });
    this.canvas.addEventListener('keydown', event => {
      const ways = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
      if (!(event.key in ways)) return;
      event.preventDefault();
      event.stopPropagation();
      this.turn.yaw += ways[event.key][0];
      this.turn.pitch += ways[event.key][1];
      desk.redraw();
    });
    for (const control of [this.fixed, this.mode]) control.addEventListener('change', () => desk.redraw());
  }
  probe() {
    const box = make('fieldset', { class: 'probe' });
    this.target = make('select', { 'aria-label': 'target frame' });
    this.source = make('select', { 'aria-label': 'source frame' });
    this.when = make('input', { type: 'number', step: 0.01, placeholder: 'latest', 'aria-label': 'time in seconds (empty for the latest)' });
    this.answer = make('output', { class: 'mono' });
    this.spans = make('canvas', { class: 'spans', role: 'img', 'aria-label': 'spans of the frames' });
    box.append(make('legend', {}, 'lookup_transform'), make('label', {}, 'target ', this.target), make('label', {}, 'source ', this.source),
      make('label', {}, 'time ', this.when), this.answer, this.spans);
    for (const control of [this.target, this.source, this.when]) control.addEventListener('input', () => this.desk.redraw());
    return box;
  }
  choices(names, tree) {
    const key = names.join('\n');
    if (key === this.known) return;
    this.known = key;
    const usual = names.includes('world') ? 'world' : names[0], near = names.filter(name => tree.root(name) === tree.root(usual));
    for (const [select, wanted] of [[this.fixed, usual], [this.target, names.includes('turtle2') ? 'turtle2' : usual],
      [this.source, names.includes('turtle1') ? 'turtle1' : near[near.length - 1]]]) {
      const before = select.value || wanted;
      select.replaceChildren(...names.map(name => make('option', { value: name }, name)));
      select.value = names.includes(before) ? before : wanted;
    }
  }
  draw(time) {
    const tree = this.desk.tree(time), names = tree.names();
    this.choices(names, tree);
    const width = this.width = this.box.clientWidth - 4, height = Math.min(width * 0.72, 430);
    const pen = sized(this.canvas, width, height), isTimeToTell = this.desk.isTimeToTell(this);
    pen.fillStyle = this.desk.colours.field;
    pen.fillRect(0, 0, width, height);
    if (!names.length) { note(pen, 'No transforms have been broadcast yet.', width, height, this.desk.colours.soft); return; }
    const seen = tree.seenFrom(this.fixed.value);
    this.project(seen, width, height);
    this.floor(pen);
    const between = fixed => [...tree.links.values()].filter(link => link.fixed === fixed && seen.has(link.child) && seen.has(link.parent))
      .map(link => [this.at(seen.get(link.child).p), this.at(seen.get(link.parent).p)]);
    strokes(pen, between(false), this.desk.colours.soft, 1.2);
    strokes(pen, between(true), this.desk.colours.soft, 1.2, [5, 3]);
    const taken = [];
    this.axes(pen, [...seen.values()]);
    for (const [name, pose] of [...seen].slice(0, MOST_NAMES)) this.label(pen, this.marked(name, time) ? `⚠ ${name}` : name, this.at(pose.p), taken, width, height);
    this.tell(time);
    if (seen.size > MOST_NAMES) note(pen, `${seen.size} frames, the first ${MOST_NAMES} with their names`, width, 24, this.desk.colours.soft);
    if (isTimeToTell) this.canvas.setAttribute('aria-label', `${seen.size} frames seen from ${this.fixed.value}: ${[...seen].slice(0, MOST_NAMES).map(([name, pose]) => `${name} at ${pose.p.map(value => value.toFixed(2)).join(', ')}`).join('; ')}`);
    if (isTimeToTell) this.rows(tree, seen, time);
    this.look(tree, time, isTimeToTell);
  }
  project(seen, width, height) {
    const above = this.mode.value === 'above', points = [...seen.values()].map(pose => pose.p);
    const span = axis => [Math.min(...points.map(p => p[axis])), Math.max(...points.map(p => p[axis]))];
    const [[x0, x1], [y0, y1], [z0, z1]] = [span(0), span(1), span(2)];
    const wanted = { c: [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2], r: Math.max(x1 - x0, y1 - y0, z1 - z0, 0.6) };
    const view = this.view ??= wanted;
    if (wanted.r > view.r * 1.02 || wanted.r < view.r * 0.6 || Math.hypot(...wanted.c.map((v, i) => v - view.c[i])) > view.r * 0.2) this.view = wanted;
    const { c, r } = this.view, scale = this.zoom * Math.min(width, height) / (r * 1.5);
    const [cy, sy] = [Math.cos(this.turn.yaw), Math.sin(this.turn.yaw)], [cp, sp] = [Math.cos(this.turn.pitch), Math.sin(this.turn.pitch)];
    this.length = r * 0.12;
    this.low = Math.min(0, z0);
    this.at = p => {
      const x = p[0] - c[0], y = p[1] - c[1], z = p[2] - c[2];
      if (above) return [width / 2 + x * scale, height / 2 - y * scale];
      const across = x * cy - y * sy, deep = x * sy + y * cy;
      return [width / 2 + across * scale, height / 2 - (z * cp + deep * sp) * scale];
    };
  }
  floor(pen) {
    const { c, r } = this.view, step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20].find(size => r * 1.5 / size < 9) || 50;
    const from = axis => Math.floor((c[axis] - r * 0.75) / step) * step, to = axis => Math.ceil((c[axis] + r * 0.75) / step) * step;
    pen.strokeStyle = this.desk.colours.grid;
    pen.lineWidth = 1;
    for (let x = from(0); x <= to(0) + 1e-9; x += step) line(pen, [this.at([x, from(1), this.low]), this.at([x, to(1), this.low])]);
    for (let y = from(1); y <= to(1) + 1e-9; y += step) line(pen, [this.at([from(0), y, this.low]), this.at([to(0), y, this.low])]);
  }
  /* Draw all axes of one colour in one stroke, because there may be hundreds of frames. */
  axes(pen, poses) {
    const tip = (pose, axis) => this.at(turned(pose.q, axis).map((value, i) => pose.p[i] + value * this.length));
    const high = this.mode.value === 'above' ? [] : poses.filter(pose => Math.abs(pose.p[2] - this.low) > 1e-3);
    strokes(pen, high.map(({ p }) => [this.at(p), this.at([p[0], p[1], this.low])]), this.desk.colours.soft, 0.8, [2, 3]);
    const { x, y, z } = this.desk.colours;
    for (const [axis, colour, width] of [[[0, 0, 1], z, 2], [[0, 1, 0], y, 2], [[1, 0, 0], x, 3]]) {
      strokes(pen, poses.map(pose => [this.at(pose.p), tip(pose, axis)]), colour, width);
      if (poses.length <= FEW) this.letters(pen, poses, axis, colour);
    }
  }
  /* Draw a letter at each tip, because some users cannot distinguish the colours of the axes. */
  letters(pen, poses, axis, colour) {
    const letter = this.glyph('xyz'[axis.indexOf(1)], colour), half = GLYPH_PX / 2;
    for (const pose of poses) {
      const [x, y] = this.at(turned(pose.q, axis).map((value, i) => pose.p[i] + value * this.length * 1.25)), [px, py] = this.at(pose.p);
      if (Math.hypot(x - px, y - py) > 9) pen.drawImage(letter, x - half, y - half, GLYPH_PX, GLYPH_PX);
    }
  }
  /* Draw each outlined letter once, because outlined text is slow to draw. */
  glyph(letter, colour) {
    const key = letter + colour + this.desk.colours.field;
    if (!this.glyphs.has(key)) {
      const canvas = document.createElement('canvas'), pen = canvas.getContext('2d');
      canvas.width = canvas.height = GLYPH_PX * 2;
      pen.scale(2, 2);
      Object.assign(pen, { font: 'bold 11px system-ui, sans-serif', textAlign: 'center', textBaseline: 'middle', lineWidth: 3, strokeStyle: this.desk.colours.field, fillStyle: colour });
      pen.strokeText(letter, GLYPH_PX / 2, GLYPH_PX / 2);
      pen.fillText(letter, GLYPH_PX / 2, GLYPH_PX / 2);
      this.glyphs.set(key, canvas);
    }
    return this.glyphs.get(key);
  }
  label(pen, text, [x, y], taken, width, height) {
    pen.font = '12px system-ui, sans-serif';
    if (!this.widths.has(text)) this.widths.set(text, pen.measureText(text).width + 6);
    const wide = this.widths.get(text);
    const places = [[8, -10], [8, 8], [-wide - 8, -10], [-wide - 8, 8], [8, -26], [8, 24], [-wide / 2, -30], [-wide / 2, 28], [8, -42], [8, 40]];
    const free = (l, t) => l > 0 && t > 0 && l + wide < width && t + 15 < height && !taken.some(([a, b, w]) => l < a + w && a < l + wide && t < b + 15 && b < t + 15);
    const [dx, dy] = places.find(([dx, dy]) => free(x + dx, y + dy - 8)) || places[0], left = x + dx, top = y + dy - 8;
    taken.push([left, top, wide]);
    pen.fillStyle = this.desk.colours.plate;
    pen.fillRect(left, top, wide, 15);
    pen.fillStyle = this.desk.colours.ink;
    pen.fillText(text, left + 3, top + 12);
  }
  marked(name, time) { return sayingsOf(this.desk.store, 'frame', name, time).length > 0; }
  point(kind, name) { this.chosen = name; this.desk.redraw(); }
  tell(time) {
    const rows = this.chosen ? sayingsOf(this.desk.store, 'frame', this.chosen, time) : [];
    this.told.hidden = !rows.length;
    if (rows.length && this.desk.isTimeToTell(this.told)) this.told.replaceChildren(make('b', {}, this.chosen), ...sentences(rows));
  }
  /* Fill in the table. While time passes, only the rows in view get new numbers. */
  rows(tree, seen, time) {
    const links = [...tree.links.values()], key = links.map(link => [link.child, link.parent, link.parents, this.marked(link.child, time), this.marked(link.parent, time)].join()).join('\n');
    if (key !== this.listed) {
      this.listed = key;
      this.list(links, time);
    }
    links.forEach((link, i) => {
      const row = this.lines[i], pose = seen.get(link.child), age = time - (link.stamp - this.desk.store.start);
      if (this.desk.moves && !this.visible.has(row)) return;
      const texts = [...(pose ? [...pose.p, yawOf(pose.q)].map(value => value.toFixed(3)) : ['another', 'tree', '', '']), link.fixed ? 'static' : `${Math.max(0, age).toFixed(2)} s`];
      texts.forEach((text, n) => { const cell = row.children[n + 2].firstChild; if (cell.data !== text) cell.data = text; });
      row.className = !link.fixed && age > 1 ? 'old' : '';
    });
  }
  list(links, time) {
    const head = make('tr', {}, ...['frame', 'parent', 'x', 'y', 'z', 'yaw', 'age'].map(text => make('th', {}, text)));
    const name = frame => {
      if (!this.marked(frame, time)) return frame;
      const mark = make('button', { type: 'button', class: 'field bad', title: 'show the advice on this frame' }, `⚠ ${frame}`);
      mark.addEventListener('click', () => this.point('frame', frame));
      return mark;
    };
    this.lines = links.map(link => make('tr', {}, ...[link.parents > 1 ? `${link.child} ⚠ two parents` : name(link.child), name(link.parent), '', '', '', '', ''].map(text => make('td', {}, text))));
    this.table.replaceChildren(head, ...this.lines);
    this.watch.disconnect();
    this.visible = new Set(this.lines);
    for (const row of this.lines) this.watch.observe(row);
  }
  look(tree, time, isTimeToTell) {
    const asked = this.when.value === '' ? null : Number(this.when.value);
    const found = lookup(this.desk.store, this.target.value, this.source.value, asked, time, tree);
    this.bars(found, time);
    if (!isTimeToTell) return;
    if (found.spans) this.spans.setAttribute('aria-label', found.spans.map(span => `${span.child} from ${span.from.toFixed(2)} to ${span.to.toFixed(2)} s`).join('; '));
    if (found.error) {
      this.answer.textContent = `${found.error}: ${found.text}`;
      this.answer.className = 'mono bad';
    } else {
      const { p, q } = found.transform, show = values => values.map(value => value.toFixed(3)).join(', ');
      this.answer.textContent = `translation [${show(p)}]  rotation [${show(q)}]  yaw ${yawOf(q).toFixed(3)} rad`;
      this.answer.className = 'mono';
    }
  }
  /* Draw the times for which the buffer has transforms, for each link of the chain, and the requested time. */
  bars(found, time) {
    const spans = found.spans || [], width = this.width - 24, height = spans.length ? 16 * spans.length + 18 : 1;
    const pen = sized(this.spans, width, height);
    if (!spans.length) return;
    const from = Math.min(time - CACHE_S - 0.5, found.asked), to = Math.max(time, found.asked) + 0.5, at = value => 90 + (value - from) / (to - from) * (width - 96);
    pen.font = '11px system-ui, sans-serif';
    spans.forEach((span, i) => {
      pen.fillStyle = this.desk.colours.ink;
      pen.fillText(span.child, 2, 16 * i + 12, 84);
      pen.fillStyle = '#4c8dd6';
      pen.fillRect(at(span.from), 16 * i + 4, Math.max(2, at(span.to) - at(span.from)), 9);
    });
    const close = Math.abs(at(time) - at(found.asked)) < 34;
    for (const [value, colour, text] of [[time, this.desk.colours.soft, close ? '' : 'now'], [found.asked, found.error ? this.desk.colours.bad : this.desk.colours.good, 'asked']]) {
      pen.strokeStyle = pen.fillStyle = colour;
      pen.lineWidth = 1.5;
      line(pen, [[at(value), 0], [at(value), height - 12]]);
      pen.fillText(text, Math.min(at(value) - 10, width - 34), height - 2);
    }
  }
}

class TreeView {
  /* The tf tree, with parents above children. */
  constructor(desk) {
    this.desk = desk;
    this.box = make('div', { class: 'pane scroll' });
  }
  mark(name, time) {
    if (!sayingsOf(this.desk.store, 'frame', name, time).length) return name;
    const mark = make('button', { type: 'button', class: 'field bad', title: 'show the advice on this frame' }, `⚠ ${name}`);
    mark.addEventListener('click', () => this.desk.point('frame', name, time));
    return mark;
  }
  age(link, time) {
    return link.fixed ? '' : `, ${Math.max(0, time - (link.stamp - this.desk.store.start)).toFixed(2)} s old`;
  }
  /* The node that publishes a transform, with the line that created its publisher or, if that is unknown, that launched the node. */
  publisher(link) {
    const { store } = this.desk, index = store.publisherNode.get(link.track.by), node = store.nodes.find(found => found?.index === index);
    const line = store.places.get(link.track.by), launched = store.processes.find(row => row?.name === node?.process)?.place;
    return `${node?.name ?? '?'}${line ? ` (${line})` : launched ? ` (launched at ${launched})` : ''}`;
  }
  draw(time) {
    const { store } = this.desk, tree = this.desk.tree(time);
    const key = store.version + ' ' + tree.names().join() + (store.advice || []).filter(row => row.t <= time).length;
    const rates = link => link.fixed ? 'static' : `${(link.track.c[0].upTo(time) - link.track.c[0].upTo(time - 1)).toFixed(0)} Hz`;
    if (key !== this.key) {
      this.key = key;
      const children = new Map(), roots = tree.names().filter(name => !tree.links.has(name));
      for (const link of tree.links.values()) children.set(link.parent, [...(children.get(link.parent) || []), link]);
      this.said = [];
      const item = (name, link) => {
        const about = make('span', { class: 'soft' });
        if (link) this.said.push([link.child, about]);
        const entry = make('li', {}, make('span', { class: 'box' }, this.mark(name, time)), about);
        const below = (children.get(name) || []).map(next => item(next.child, next));
        if (below.length) entry.append(make('ul', {}, ...below));
        return entry;
      };
      this.box.replaceChildren(roots.length ? make('ul', { class: 'tree' }, ...roots.map(root => item(root))) : 'No transforms have been broadcast yet.');
      if (roots.length > 1) this.box.prepend(make('p', { class: 'bad' }, `${roots.length} separate trees: no transform connects them`));
    }
    for (const [child, about] of this.said || []) {
      const link = tree.links.get(child);
      if (link) about.textContent = ` ${rates(link)}${this.age(link, time)}, by ${this.publisher(link)}`;
      about.classList.toggle('late', Boolean(link && !link.fixed && time - (link.stamp - store.start) > OLD_S));
    }
  }
}
