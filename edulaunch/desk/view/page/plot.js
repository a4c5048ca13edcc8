/* The tab Plot: lines of this run, and lines of another run for comparison. */

const LINES = ['#2a6fdb', '#b0348f', '#2e8c30', '#9c6ade', '#c97b12', '#128a8a'], DASHES = [[], [6, 3], [9, 3, 2, 3], [4, 4], [12, 4], [1, 3]], OTHER = [1.5, 3];

class PlotView {
  constructor(desk) {
    this.desk = desk;
    this.lines = [];
    this.box = make('div', { class: 'pane scroll' });
    this.choice = make('select', { 'aria-label': 'add a field to the plot' });
    this.span = make('select', { 'aria-label': 'how much time is shown' });
    for (const [value, text] of [['0', 'whole run'], ['10', 'last 10 s'], ['3', 'last 3 s']]) this.span.append(make('option', { value }, text));
    this.keys = make('div', { class: 'keys' });
    this.canvas = make('canvas', { role: 'img', 'aria-label': 'plot' });
    this.wrong = make('p', { class: 'bad', role: 'alert', hidden: true });
    this.box.append(make('div', { class: 'tools' }, this.choice, this.span, ...this.another()), ...this.forms(), this.wrong, this.keys, this.canvas);
    this.choice.addEventListener('change', () => { const text = this.choice.value; this.choice.value = ''; this.write(text); });
    this.span.addEventListener('change', () => desk.redraw());
    this.box.addEventListener('dragover', event => event.preventDefault());
    this.box.addEventListener('drop', event => { event.preventDefault(); this.add(...event.dataTransfer.getData('text/plain').split(' ')); });
  }
  /* A transform is chosen from lists, an expression is typed. */
  forms() {
    this.target = make('select', { 'aria-label': 'plot: seen from the frame' });
    this.source = make('select', { 'aria-label': 'plot: the frame' });
    this.part = make('select', { 'aria-label': 'plot: part of the transform' }, ...Object.keys(PARTS).map(name => make('option', { value: name }, name)));
    const plot = button('Plot it', 'add this transform to the plot', () => this.write(`tf(${this.target.value}, ${this.source.value}).${this.part.value}`));
    this.transforms = make('div', { class: 'tools' }, make('label', {}, 'frame ', this.source), make('label', {}, 'seen from ', this.target), this.part, plot);
    this.text = make('input', { type: 'text', class: 'mono expression', spellcheck: 'false', 'aria-label': 'an expression to plot', placeholder: 'hypot(/turtle1/pose.x - /turtle2/pose.x, 1) * 2' });
    const typed = () => { if (this.write(this.text.value)) this.text.value = ''; };
    this.text.addEventListener('keydown', event => { if (event.key === 'Enter') typed(); });
    return [this.transforms, make('div', { class: 'tools' }, this.text, button('Add', 'add this expression to the plot', typed))];
  }
  /* Another run comes from a page that Export or `edulaunch recording show` has written. */
  another() {
    const file = make('input', { type: 'file', accept: '.html', 'aria-label': 'page of another run to plot over this one' });
    this.away = button('Without the other run', 'take the other run out of the plot', () => this.over(null));
    this.away.hidden = true;
    file.addEventListener('change', async () => {
      const found = (await file.files[0]?.text() ?? '').match(/unpacked\('([zj][A-Za-z0-9+/=]+)'\)/);
      file.value = '';
      if (found) this.over(await unpacked(found[1])); else this.say('this file is not a page of a run: write one with Export, or with edulaunch recording show --html');
    });
    return [make('label', { class: 'file' }, 'other run ', file), this.away];
  }
  /* Plot another run for comparison, or no other run if the argument is null. */
  over(delta) {
    this.other = delta ? new Store() : null;
    this.other?.apply(delta);
    this.away.hidden = !delta;
    this.restart();
  }
  say(text) {
    this.wrong.textContent = text;
    this.wrong.hidden = !text;
  }
  /* Add an expression. Return whether it is valid. */
  write(text) {
    this.say('');
    if (!text.trim()) return false;
    try {
      const expression = new Expression(text.trim()), { store } = this.desk;
      for (const { topic, path, target, source } of expression.inputs) {
        const topics = topic ? store.byName(topic) : [], frames = this.desk.tree(store.now).names();
        if (topic && !topics.length) throw new Error(`there is no topic ${topic}`);
        if (topic && !topics.some(found => found.column(path) instanceof Grow)) throw new Error(`${topic} has no number ${path}; it has ${topics[0].fields.filter(([, how]) => how !== 'text').map(([name]) => name).join(', ')}`);
        for (const frame of topic ? [] : [target, source]) if (!frames.includes(frame)) throw new Error(`there is no frame ${frame}; there are ${frames.join(', ') || 'none'}`);
      }
      this.put(expression);
      return true;
    } catch (error) {
      this.say(error.message);
      return false;
    }
  }
  add(name, path) {
    const topic = this.desk.store.byName(name || '').find(found => found.column(path) instanceof Grow);
    if (topic) this.put(new Expression(`${name}.${path}`));
  }
  put(expression) {
    if (this.lines.some(row => row.expression.text === expression.text)) return;
    this.lines.push({ expression, number: this.lines.reduce((most, row) => Math.max(most, row.number + 1), 0) });
    this.restart();
  }
  /* Compute all lines again, because there is another run, or the machine has started over. */
  restart() {
    for (const row of this.lines) {
      row.mine = new Series(this.desk.store, row.expression);
      row.others = this.other ? new Series(this.other, row.expression) : null;
    }
    this.version = null;
    this.legend();
    this.desk.redraw();
  }
  legend() {
    this.keys.replaceChildren(...this.lines.map(row => {
      const drop = make('button', { type: 'button', title: 'take it out of the plot', 'aria-label': `take ${row.expression.text} out of the plot` }, '✕');
      drop.addEventListener('click', () => { this.lines = this.lines.filter(other => other !== row); this.legend(); this.desk.redraw(); });
      row.told = make('span', { class: 'mono' });
      row.gaps = make('span', { class: 'soft' });
      const key = make('span', { class: 'key' }, make('i', {}), ` ${row.expression.text} `, row.told, row.gaps, ' ', drop);
      key.firstChild.style.borderTop = `3px ${['solid', 'dashed', 'dashed'][row.number % 3]} ${LINES[row.number % LINES.length]}`;
      return key;
    }), ...(this.other && this.lines.length ? [make('span', { class: 'soft' }, 'dotted: the other run')] : []));
  }
  choices() {
    if (this.version === this.desk.store.version) return;
    this.version = this.desk.store.version;
    const { store } = this.desk, fields = [...store.topics.values()].filter(topic => !QUIET_TOPICS.has(topic.name)).flatMap(topic =>
      topic.fields.filter(([, how]) => how !== 'text').map(([path]) => `${topic.name}.${path}`));
    this.choice.replaceChildren(make('option', { value: '' }, fields.length ? 'add a field …' : 'no topic has numbers yet'), ...fields.map(value => make('option', { value }, value)));
    const names = this.desk.tree(store.now).names();
    this.transforms.hidden = !names.length;
    for (const [select, wanted] of [[this.target, names[0]], [this.source, names[1]]]) {
      const before = select.value || wanted;
      select.replaceChildren(...names.map(name => make('option', { value: name }, name)));
      select.value = names.includes(before) ? before : wanted;
    }
  }
  /* Plot the position of a turtle or robot first, because most users want to see it. */
  offer() {
    const topic = [...this.desk.store.topics.values()].find(found => found.place.has('theta') || found.place.has('pose.pose.position.x'));
    if (!topic || this.offered) return;
    this.offered = true;
    if (!this.lines.length) for (const path of ['x', 'y', 'pose.pose.position.x', 'pose.pose.position.y']) if (topic.place.has(path)) this.add(topic.name, path);
  }
  draw(time) {
    this.choices();
    const { colours, store } = this.desk, width = this.box.clientWidth - 4, height = Math.min(360, Math.max(200, width * 0.5));
    const pen = sized(this.canvas, width, height), end = Math.max(store.now, this.other?.now ?? 0, 0.1);
    const span = Number(this.span.value), to = span ? time : end, from = span ? Math.max(0, to - span) : this.desk.from;
    this.offer();
    if (!this.lines.length) { note(pen, 'choose a field or a frame above, type an expression, or drop a field here from the graph', width, height, colours.soft); return; }
    const drawn = this.lines.flatMap(row => [[row.mine, row.number, false], ...(row.others ? [[row.others, row.number, true]] : [])]);
    if (drawn.map(([series]) => series.update()).includes(true)) this.desk.redraw();
    let low = Infinity, high = -Infinity;
    for (const [{ t, v }] of drawn) {
      for (let i = Math.max(0, t.upTo(from) - 1), last = t.upTo(to); i < last; i++) if (Number.isFinite(v.a[i])) { low = Math.min(low, v.a[i]); high = Math.max(high, v.a[i]); }
    }
    this.tell(time);
    if (low === Infinity) { note(pen, 'no value in this time', width, height, colours.soft); return; }
    if (high - low < 1e-9) { low -= 0.5; high += 0.5; }
    const pad = (high - low) * 0.06, x = t => 52 + (t - from) / (to - from) * (width - 62), y = v => height - 24 - (v - low + pad) / (high - low + 2 * pad) * (height - 34);
    this.frame(pen, width, height, { from, to, low: low - pad, high: high + pad, x, y });
    for (const [series, number, other] of drawn) this.curve(pen, series, number, other, from, to, x, y);
    pen.strokeStyle = colours.mark;
    pen.lineWidth = 1;
    if (time <= to) line(pen, [[x(time), 6], [x(time), height - 24]]);
  }
  tell(time) {
    const shown = value => Number.isNaN(value) ? 'none' : String(+value.toFixed(4));
    for (const row of this.lines) {
      row.told.textContent = shown(row.mine.at(time)) + (row.others ? ` (other run: ${shown(row.others.at(time))})` : '');
      row.gaps.textContent = row.mine.about();
    }
    this.canvas.setAttribute('aria-label', this.lines.map(row => `${row.expression.text} is ${row.told.textContent} at ${time.toFixed(2)} s${row.gaps.textContent && `, with${row.gaps.textContent}`}`).join('; '));
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
  curve(pen, { t, v }, number, other, from, to, x, y) {
    const first = Math.max(0, t.upTo(from) - 1), end = t.upTo(to), step = Math.max(1, Math.floor((end - first) / 2000));
    pen.strokeStyle = LINES[number % LINES.length];
    pen.setLineDash(other ? OTHER : DASHES[number % DASHES.length]);
    pen.lineWidth = other ? 2.2 : 1.8;
    pen.beginPath();
    let open = false;
    for (let i = first; i < end; i += step) {
      if (!Number.isFinite(v.a[i])) { open = false; continue; }
      const px = Math.max(x(t.a[i]), 52), py = y(v.a[i]);
      if (open) pen.lineTo(px, py); else { pen.moveTo(px, py); pen.lineTo(px + 0.5, py); }
      open = true;
    }
    pen.stroke();
    pen.setLineDash([]);
  }
}
