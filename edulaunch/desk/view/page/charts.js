/* What happened when: the timeline of processes, logs and topics; and numbers of topics over time. */

const LINES = ['#2a6fdb', '#b0348f', '#2e8c30', '#9c6ade', '#c97b12', '#128a8a'], DASHES = [[], [6, 3], [2, 2], [9, 3, 2, 3], [4, 4], [1, 3]];

class TimelineView {
  constructor(desk) {
    this.desk = desk;
    this.box = make('div', { class: 'pane scroll' });
    this.canvas = make('canvas', { role: 'img' });
    this.box.append(this.canvas);
    this.canvas.addEventListener('pointerdown', event => this.seek(event));
    this.canvas.addEventListener('pointermove', event => { if (event.buttons) this.seek(event); });
  }
  seek(event) {
    const x = event.clientX - this.canvas.getBoundingClientRect().left;
    this.desk.seek((x - this.left) / (this.width - this.left - 8) * this.to);
  }
  draw(time) {
    const { store, colours } = this.desk, topics = [...store.topics.values()].filter(topic => topic.t.n && !QUIET_TOPICS.has(topic.name));
    const processes = store.processes.filter(Boolean), rows = processes.length + topics.length + store.tracks.size;
    this.width = this.box.clientWidth - 18;
    this.left = Math.min(230, this.width * 0.36);
    this.to = Math.max(store.now, 0.1);
    const height = rows * 17 + 62, pen = sized(this.canvas, this.width, height), at = t => this.left + t / this.to * (this.width - this.left - 8);
    pen.font = '11px ui-monospace, monospace';
    let y = 4;
    const name = text => { pen.fillStyle = colours.ink; pen.fillText(text.length > 30 ? '…' + text.slice(-29) : text, 4, y + 11, this.left - 8); };
    const head = text => { pen.fillStyle = colours.soft; pen.fillText(text, 4, y + 10); y += 16; };
    head('processes and their log lines');
    for (const process of processes) {
      name(process.name);
      const end = Math.min(process.to, this.to);
      pen.fillStyle = process.to <= this.to && process.code ? '#e8a0a0' : colours.bar;
      pen.fillRect(at(process.from), y + 2, Math.max(2, at(end) - at(process.from)), 11);
      for (const log of store.logs) {
        const node = log.process === process.name;
        if (!node || log.t > this.to) continue;
        pen.fillStyle = log.level >= 40 ? '#b3261e' : log.level >= 30 ? '#b46900' : colours.ink;
        pen.fillRect(at(log.t) - 1, log.level >= 30 ? y : y + 4, log.level >= 40 ? 5 : 2, log.level >= 30 ? 15 : 7);
      }
      if (process.to <= this.to) { pen.fillStyle = colours.ink; pen.fillText(process.code ? `✗ ${process.code}` : '✓', Math.min(at(end) + 2, this.width - 24), y + 11); }
      y += 17;
    }
    head('topics: messages in each stretch');
    for (const topic of topics) {
      name(topic.name);
      this.density(pen, topic.t, at, y);
      y += 17;
    }
    if (store.tracks.size) head('tf: from the stamp of the newest transform to now');
    for (const track of store.tracks.values()) {
      name(`${track.fixed ? '(static) ' : ''}${track.parent} → ${track.child}`);
      const number = track.at(time);
      if (number >= 0) {
        const stamp = track.c[1].a[number] - store.start;
        pen.fillStyle = track.fixed ? colours.bar : '#4c8dd6';
        pen.fillRect(at(track.fixed ? track.c[0].a[0] : Math.min(stamp, time)), y + 4, Math.max(2, Math.abs(at(time) - at(track.fixed ? track.c[0].a[0] : stamp))), 7);
      }
      y += 17;
    }
    pen.strokeStyle = colours.mark;
    pen.lineWidth = 1.5;
    line(pen, [[at(time), 0], [at(time), height]]);
    this.canvas.setAttribute('aria-label', `${processes.length} processes (${processes.map(process => process.name + (process.to <= this.to ? ` ended with ${process.code}` : '')).join(', ')}), ${topics.length} topics, ${store.logs.length} log lines over ${this.to.toFixed(1)} seconds; now at ${time.toFixed(2)}`);
  }
  density(pen, stamps, at, y) {
    const bins = 120, most = Math.max(1, stamps.n / bins * 2.5);
    pen.fillStyle = '#2e8c30';
    for (let i = 0; i < bins; i++) {
      const from = i / bins * this.to, to = (i + 1) / bins * this.to, count = stamps.upTo(to) - stamps.upTo(i ? from : -1);
      if (count) pen.fillRect(at(from), y + 14 - Math.max(2, Math.min(12, 12 * count / most)), at(to) - at(from), Math.max(2, Math.min(12, 12 * count / most)));
    }
  }
}

class PlotView {
  constructor(desk) {
    this.desk = desk;
    this.lines = [];
    this.box = make('div', { class: 'pane' });
    this.choice = make('select', { 'aria-label': 'add a field to the plot' });
    this.span = make('select', { 'aria-label': 'how much time is shown' });
    for (const [value, text] of [['0', 'whole run'], ['10', 'last 10 s'], ['3', 'last 3 s']]) this.span.append(make('option', { value }, text));
    this.keys = make('div', { class: 'keys' });
    this.canvas = make('canvas', { role: 'img' });
    this.box.append(make('div', { class: 'tools' }, this.choice, this.span), this.keys, this.canvas);
    this.choice.addEventListener('change', () => { const [name, path] = this.choice.value.split(' '); this.choice.value = ''; this.add(name, path); });
    this.span.addEventListener('change', () => desk.redraw());
    this.box.addEventListener('dragover', event => event.preventDefault());
    this.box.addEventListener('drop', event => { event.preventDefault(); this.add(...event.dataTransfer.getData('text/plain').split(' ')); });
  }
  add(name, path) {
    const topic = this.desk.store.byName(name || '').find(found => found.place.has(path));
    if (!topic || this.lines.some(row => row.topic === topic && row.path === path)) return;
    this.lines.push({ topic, path, column: topic.column(path), number: this.lines.reduce((most, row) => Math.max(most, row.number + 1), 0) });
    this.legend();
    this.desk.redraw();
  }
  legend() {
    this.keys.replaceChildren(...this.lines.map(row => {
      const drop = make('button', { type: 'button', title: 'take it out of the plot', 'aria-label': `take ${row.topic.name} ${row.path} out of the plot` }, '✕');
      drop.addEventListener('click', () => { this.lines = this.lines.filter(other => other !== row); this.legend(); this.desk.redraw(); });
      row.told = make('span', { class: 'mono' });
      const key = make('span', { class: 'key' }, make('i', {}), ` ${row.topic.name} ${row.path} `, row.told, ' ', drop);
      key.firstChild.style.borderTop = `3px ${['solid', 'dashed', 'dotted'][row.number % 3]} ${LINES[row.number % LINES.length]}`;
      return key;
    }));
  }
  choices() {
    if (this.version === this.desk.store.version) return;
    this.version = this.desk.store.version;
    const fields = [...this.desk.store.topics.values()].filter(topic => !QUIET_TOPICS.has(topic.name)).flatMap(topic =>
      topic.fields.filter(([, how]) => how !== 'text').map(([path]) => `${topic.name} ${path}`));
    this.choice.replaceChildren(make('option', { value: '' }, fields.length ? 'add a field …' : 'no topic has numbers yet'), ...fields.map(value => make('option', { value }, value)));
  }
  /* What most people want to see first, once: where somebody is. */
  offer() {
    const topic = [...this.desk.store.topics.values()].find(found => found.place.has('theta') || found.place.has('pose.pose.position.x'));
    if (!topic || this.offered) return;
    this.offered = true;
    if (!this.lines.length) for (const path of ['x', 'y', 'pose.pose.position.x', 'pose.pose.position.y']) if (topic.place.has(path)) this.add(topic.name, path);
  }
  draw(time) {
    this.choices();
    const { colours, store } = this.desk, width = this.box.clientWidth - 4, height = Math.min(360, Math.max(200, width * 0.5));
    const pen = sized(this.canvas, width, height), span = Number(this.span.value), to = span ? time : Math.max(store.now, 0.1), from = span ? Math.max(0, to - span) : 0;
    this.offer();
    if (!this.lines.length) { note(pen, 'choose a field above, or drop one here from the graph', width, height, colours.soft); return; }
    let low = Infinity, high = -Infinity;
    for (const { topic, column } of this.lines) {
      for (let i = Math.max(0, topic.t.upTo(from) - 1), end = topic.t.upTo(to); i < end; i++) if (column.a[i] === column.a[i]) { low = Math.min(low, column.a[i]); high = Math.max(high, column.a[i]); }
    }
    if (low === Infinity) { note(pen, 'no message in this time', width, height, colours.soft); return; }
    if (high - low < 1e-9) { low -= 0.5; high += 0.5; }
    const pad = (high - low) * 0.06, x = t => 52 + (t - from) / (to - from) * (width - 62), y = v => height - 24 - (v - low + pad) / (high - low + 2 * pad) * (height - 34);
    this.frame(pen, width, height, { from, to, low: low - pad, high: high + pad, x, y });
    for (const row of this.lines) this.curve(pen, row, from, to, x, y);
    pen.strokeStyle = colours.mark;
    pen.lineWidth = 1;
    if (time <= to) line(pen, [[x(time), 6], [x(time), height - 24]]);
    for (const row of this.lines) {
      const number = row.topic.at(time);
      row.told.textContent = number < 0 ? '' : String(+row.column.a[number].toFixed(4));
    }
    this.canvas.setAttribute('aria-label', this.lines.map(row => `${row.topic.name} ${row.path} is ${row.told.textContent} at ${time.toFixed(2)} s`).join('; '));
  }
  frame(pen, width, height, { from, to, low, high, x, y }) {
    const { colours } = this.desk, ticks = (a, b, most) => {
      const step = [1, 2, 5, 10].map(m => m * 10 ** Math.floor(Math.log10((b - a) / most))).find(size => (b - a) / size <= most);
      return Array.from({ length: Math.floor(b / step) - Math.ceil(a / step) + 1 }, (_, i) => +((Math.ceil(a / step) + i) * step).toPrecision(10));
    };
    pen.font = '11px system-ui, sans-serif';
    pen.lineWidth = 1;
    for (const value of ticks(low, high, 6)) { pen.strokeStyle = colours.grid; line(pen, [[52, y(value)], [width - 8, y(value)]]); pen.fillStyle = colours.soft; pen.fillText(value, 4, y(value) + 4, 46); }
    for (const value of ticks(from, to, 8)) { pen.strokeStyle = colours.grid; line(pen, [[x(value), 6], [x(value), height - 24]]); pen.fillStyle = colours.soft; pen.fillText(value + ' s', x(value) - 8, height - 8); }
  }
  curve(pen, { topic, column, number }, from, to, x, y) {
    const first = Math.max(0, topic.t.upTo(from) - 1), end = topic.t.upTo(to), step = Math.max(1, Math.floor((end - first) / 2000));
    pen.strokeStyle = LINES[number % LINES.length];
    pen.setLineDash(DASHES[number % DASHES.length]);
    pen.lineWidth = 1.8;
    pen.beginPath();
    let open = false;
    for (let i = first; i < end; i += step) {
      if (column.a[i] !== column.a[i]) { open = false; continue; }
      const px = Math.max(x(topic.t.a[i]), 52), py = y(column.a[i]);
      if (open) pen.lineTo(px, py); else pen.moveTo(px, py);
      open = true;
    }
    pen.stroke();
    pen.setLineDash([]);
  }
}
