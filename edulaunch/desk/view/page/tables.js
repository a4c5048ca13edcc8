/* The log, the parameters, and a terminal. */

const LEVELS = [[50, 'FATAL'], [40, 'ERROR'], [30, 'WARN'], [20, 'INFO'], [10, 'DEBUG']];
const levelName = level => (LEVELS.find(([value]) => level >= value) || [0, 'DEBUG'])[1];

/* A parameter's value in the form of a parameter file: doubles have a decimal point. */
function written({ value, double }) {
  if (Array.isArray(value)) return `[${value.map(entry => written({ value: entry, double })).join(', ')}]`;
  return typeof value === 'string' ? value : double && Number.isInteger(value) ? value.toFixed(1) : JSON.stringify(value);
}

/* A value in a parameter file. Strings are in quotes, so that no string is read as a number or a boolean. */
function inYaml(row) {
  if (Array.isArray(row.value)) return `[${row.value.map(value => inYaml({ ...row, value })).join(', ')}]`;
  return typeof row.value === 'string' ? JSON.stringify(row.value) : written(row);
}

class LogView {
  constructor(desk) {
    this.desk = desk;
    this.box = make('div', { class: 'pane' });
    this.process = make('select', { 'aria-label': 'process' });
    this.level = make('select', { 'aria-label': 'lowest level' }, ...[10, 20, 30, 40, 50].map(value => make('option', { value }, levelName(value))));
    this.word = make('input', { type: 'search', placeholder: 'word', 'aria-label': 'show lines with this word' });
    this.table = make('table', { class: 'small log' });
    this.sheet = make('div', { class: 'scroll tall', tabindex: 0, role: 'region', 'aria-label': 'log lines' }, this.table);
    this.box.append(make('div', { class: 'tools' }, this.process, make('label', {}, 'from ', this.level), this.word), this.sheet);
    for (const control of [this.process, this.level, this.word]) control.addEventListener('input', () => { this.key = null; desk.redraw(); });
  }
  /* Show the lines of one process, even if it has not written a line yet. */
  choose(process) {
    if (![...this.process.options].some(option => option.value === process)) this.process.append(make('option', { value: process }, process));
    this.process.value = process;
    this.key = null;
  }
  draw(time) {
    const { store } = this.desk, all = store.logs, names = [...new Set(all.map(row => row.process))];
    if (names.join() !== this.names) {
      this.names = names.join();
      const before = this.process.value;
      this.process.replaceChildren(make('option', { value: '' }, 'all processes'), ...names.map(name => make('option', { value: name }, name)));
      this.process.value = names.includes(before) ? before : '';
    }
    const word = this.word.value.toLowerCase(), level = Number(this.level.value);
    let count = 0;
    while (count < all.length && all[count].t <= time + 1e-7) count++;
    const key = [count, this.process.value, level, word].join();
    if (key === this.key) return;
    this.key = key;
    const rows = all.slice(0, count).filter(row => row.level >= level && (!this.process.value || row.process === this.process.value) && (!word || row.text.toLowerCase().includes(word)));
    const stays = this.sheet.scrollTop + this.sheet.clientHeight < this.sheet.scrollHeight - 30;
    this.table.replaceChildren(make('tr', {}, ...['time', 'level', 'from', 'message'].map(text => make('th', { scope: 'col' }, text))),
      ...rows.slice(-500).map(row => make('tr', { class: levelName(row.level).toLowerCase() },
        ...[row.t.toFixed(3), levelName(row.level), row.logger, row.text].map((text, i) => make('td', { class: i < 2 ? 'whole' : false }, text)))));
    if (rows.length > 500) this.table.prepend(make('caption', {}, `the last 500 of ${rows.length} lines`));
    if (!stays) this.sheet.scrollTop = this.sheet.scrollHeight;
  }
}

class ParameterView {
  constructor(desk) {
    this.desk = desk;
    this.box = make('div', { class: 'pane scroll' });
    this.table = make('table', { class: 'small params' });
    this.every = make('input', { type: 'checkbox' });
    this.other = make('input', { type: 'checkbox' });
    this.yaml = make('pre', { class: 'mono yaml', tabindex: 0, role: 'region', 'aria-label': 'parameters as YAML', hidden: true });
    this.box.append(make('div', { class: 'tools' }, make('label', {}, this.every, ' all parameters'), make('label', {}, this.other, ' only differences from the defaults'),
      button('Save as YAML', 'save the parameters of this table as a parameter file', () => this.save()),
      make('span', { class: 'soft' }, desk.live ? 'change a value, as ros2 param set does' : '')), this.yaml, this.table);
    for (const box of [this.every, this.other]) box.addEventListener('change', () => { this.key = null; desk.redraw(); });
  }
  /* Whether a value differs from the default, or undefined if the default is unknown. */
  differs(row) {
    const known = this.desk.store.defaults.get(row.node + ' ' + row.name);
    return known !== undefined ? JSON.stringify(known) !== JSON.stringify(row.value) : row.origin === 'default' ? false : undefined;
  }
  rows(time) {
    return this.desk.store.parametersAt(time).filter(row => (this.every.checked || !/^(use_sim_time|start_type_description_service|qos_overrides\.)/.test(row.name))
      && (!this.other.checked || this.differs(row) !== false));
  }
  /* The table as a parameter file. It is also shown, because a page in a frame of a notebook cannot always save files. */
  save() {
    const nodes = new Map();
    for (const row of this.rows(this.desk.time)) nodes.set(row.node, [...(nodes.get(row.node) || []), row]);
    const text = [...nodes].map(([node, rows]) => `${node}:\n  ros__parameters:\n${rows.map(row => `    ${row.name}: ${inYaml(row)}\n`).join('')}`).join('');
    this.yaml.textContent = text || '# no parameters';
    this.yaml.hidden = false;
    this.desk.download(text, 'parameters.yaml', 'application/yaml');
  }
  draw(time) {
    const { store } = this.desk, { desk } = this, rows = this.rows(time);
    const names = store.nodes.filter(node => node && store.alive(node, time)).map(node => node.name).join();
    if (desk.live && names !== this.asked) { this.asked = names; desk.send({ op: 'defaults' }); }
    const key = rows.map(row => row.node + row.name + JSON.stringify(row.value)).join() + desk.live + store.defaults.size;
    const active = document.activeElement?.shadowRoot?.activeElement || document.activeElement, inside = this.table.contains(active);
    if (key === this.key || (inside && !this.sent)) return;
    this.key = key; this.sent = false;
    this.table.replaceChildren(make('tr', {}, ...['node', 'parameter', 'value', 'default', 'where it came from'].map(text => make('th', { scope: 'col' }, text))),
      ...rows.map(row => make('tr', {}, make('td', {}, row.node), make('td', { class: 'named' }, row.name, this.about(row)), make('td', {}, this.value(row)), make('td', {}, ...this.standard(row)), make('td', { class: 'soft' }, row.origin))));
    if (inside) [...this.table.querySelectorAll('input')].find(input => input.type === active.type && input.getAttribute('aria-label') === active.getAttribute('aria-label'))?.focus();
    if (!rows.length) this.table.append(make('tr', {}, make('td', { colspan: 5 }, this.other.checked ? 'no parameter differs from its default' : 'no node has parameters yet')));
  }
  /* The default, and a sign if the value differs from it. */
  standard(row) {
    const differs = this.differs(row);
    if (differs === undefined) return [make('span', { class: 'soft' }, 'not known')];
    const known = this.desk.store.defaults.get(row.node + ' ' + row.name);
    return differs ? [make('b', { class: 'differs' }, `≠ ${written({ ...row, value: known })}`)] : [make('span', { class: 'soft' }, 'the same')];
  }
  about(row) {
    const said = this.desk.store.descriptors.get(row.node + ' ' + row.name);
    return said?.description ? make('span', { class: 'soft about' }, said.description) : '';
  }
  /* The control for a value: a slider for a declared range, a checkbox for a boolean, and otherwise a text field as for `ros2 param set`. */
  value(row) {
    const said = this.desk.store.descriptors.get(row.node + ' ' + row.name) || {}, label = `${row.node} ${row.name}`, text = written(row);
    if (!this.desk.live || said.fixed) return make('span', {}, text, said.fixed ? make('span', { class: 'soft' }, ' read-only') : '');
    let sent = text;
    const set = value => { if (value !== sent) { this.sent = true; this.desk.send({ op: 'param', node: row.node, name: row.name, value: sent = value }); } };
    if (typeof row.value === 'boolean') {
      const box = make('input', { type: 'checkbox', 'aria-label': label });
      box.checked = row.value;
      box.addEventListener('change', () => set(String(box.checked)));
      return box;
    }
    const input = make('input', { type: 'text', 'aria-label': label });
    input.value = text;
    input.addEventListener('change', () => set(input.value));
    input.addEventListener('keydown', event => { if (event.key === 'Enter') set(input.value); });  /* in JupyterLab, Enter brings no change event */
    const [low, high, step] = said.limits || [];
    if (typeof row.value !== 'number' || !(high - low < 1e9)) return input;
    const slider = make('input', { type: 'range', min: low, max: high, step: step || (row.double ? (high - low) / 1000 : 1), 'aria-label': label });
    slider.value = row.value;
    input.className = 'short';
    input.setAttribute('aria-label', `${label} as a number`);
    const now = () => written({ value: Number(slider.value), double: row.double });
    slider.addEventListener('input', () => { input.value = now(); });
    slider.addEventListener('change', () => set(now()));
    return make('span', { class: 'range' }, make('small', { class: 'soft' }, low), slider, make('small', { class: 'soft' }, high), input);
  }
}

const PANES = 2, KEYS = { ArrowUp: '\x1b[A', ArrowDown: '\x1b[B', ArrowRight: '\x1b[C', ArrowLeft: '\x1b[D', Enter: '\r', Escape: '\x1b', Backspace: '\x7f', Tab: '\t' };

/* The terminals of a live machine side by side; for a recording, the output of its programs. */
class TerminalView {
  constructor(desk) {
    this.panes = Array.from({ length: desk.live ? PANES : 1 }, (_, number) => new Pane(desk, number));
    this.box = make('div', { class: 'pane terminals' }, ...this.panes.map(pane => pane.box));
  }
  hear(message) { this.panes[message.pane || 0]?.hear(message); }
  draw(time) { for (const pane of this.panes) pane.draw(time); }
}

class Pane {
  constructor(desk, number) {
    Object.assign(this, { desk, number, past: [], at: 0, shown: 0, runs: false, keys: false });
    const which = `terminal ${number + 1}`;
    this.sheet = make('pre', { class: 'terminal scroll', tabindex: 0, role: 'log', 'aria-live': 'polite', 'aria-label': desk.live ? `output of ${which}` : 'output of the programs' });
    this.sign = make('span', { class: 'mono' }, '$');
    this.line = make('input', { type: 'text', class: 'mono', placeholder: number ? 'ros2 topic echo /turtle1/pose' : 'ros2 topic list', 'aria-label': number ? `command for the machine, ${which}` : 'command for the machine', spellcheck: 'false', autocomplete: 'off' });
    this.stop = button('^C', `Ctrl-C for ${which}`, () => this.send({ op: 'interrupt' }));
    this.tools = make('div', { class: 'tools', hidden: !desk.live }, this.sign, this.line, this.stop);
    this.box = make('div', { class: 'term' }, this.sheet, this.tools);
    this.line.addEventListener('keydown', event => this.key(event));
  }
  send(words) { this.desk.send({ ...words, pane: this.number }); }
  key(event) {
    event.stopPropagation();
    if (event.key === 'c' && event.ctrlKey && this.line.selectionStart === this.line.selectionEnd) this.send({ op: 'interrupt' });
    else if (this.keys) {
      const text = KEYS[event.key] ?? (event.key.length === 1 && !event.ctrlKey && !event.metaKey ? event.key : '');
      if (!text || (event.key === 'Tab' && event.shiftKey)) return;
      event.preventDefault();
      this.send({ op: 'keys', keys: text });
    } else if (event.key === 'Enter' && (this.runs || this.line.value.trim())) {
      this.past.push(this.line.value);
      this.at = this.past.length;
      this.write(`${this.runs ? '' : '$ '}${this.line.value}\n`);
      this.send({ op: 'line', line: this.line.value });
      this.line.value = '';
    } else if (event.key === 'Tab' && !event.shiftKey && this.line.value) {
      event.preventDefault();
      this.send({ op: 'complete', line: this.line.value });
    } else if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
      event.preventDefault();
      this.at = Math.max(0, Math.min(this.past.length, this.at + (event.key === 'ArrowUp' ? -1 : 1)));
      this.line.value = this.past[this.at] || '';
    }
  }
  hear({ text, completed, runs, keys }) {
    if (text) this.write(text);
    if (completed) {
      const [line, choices] = completed;
      if (line) this.line.value = line;
      if (choices.length > 1) this.write(choices.join('  ') + '\n');
    }
    if (runs === undefined) return;
    Object.assign(this, { runs, keys });
    this.sign.textContent = keys ? '⌨' : runs ? '›' : '$';
    this.sign.title = keys ? 'the program receives each key; press Shift-Tab to leave' : runs ? 'the program receives each line' : '';
  }
  write(text) {
    this.sheet.append(text.replace(/\x1b\[[0-9;?]*[A-Za-z]/g, ''));
    while (this.sheet.childNodes.length > 2000) this.sheet.firstChild.remove();
    this.sheet.scrollTop = this.sheet.scrollHeight;
  }
  draw(time) {
    if (this.desk.live) return;
    const { output } = this.desk.store;
    if (this.shown && (this.shown > output.length || output[this.shown - 1].t > time)) { this.sheet.replaceChildren(); this.shown = 0; }
    for (; this.shown < output.length && output[this.shown].t <= time + 1e-7; this.shown++) this.write(output[this.shown].text);
  }
}
