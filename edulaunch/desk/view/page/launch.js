/* The launch: its files, includes, groups, actions and processes as a tree, with the state of each one and the reason. Also its
   events, and the buttons that step through it, forwards and backwards. */

const HIDDEN_STEPS = new Set(['PushLaunchConfigurations', 'PopLaunchConfigurations', 'PushEnvironment', 'PopEnvironment', 'ResetEnvironment']);
const PROCESS_KINDS = new Set(['node', 'process']);
const baseName = path => (path || '').split('/').pop();
const place = row => row.file ? `${baseName(row.file)}:${row.line}` : '';
const titled = row => row.kind === 'include' ? `include ${baseName(row.text)}` : row.text;
const shownValue = value => value === null || value === undefined ? 'not set' : typeof value === 'string' ? `'${value}'` : JSON.stringify(value);

class LaunchView {
  constructor(desk) {
    Object.assign(this, { desk, cursor: null, chosen: null, closed: new Set(), items: new Map(), written: 0 });
    this.box = make('div', { class: 'pane launch' });
    this.which = make('select', { 'aria-label': 'launch' });
    this.which.addEventListener('change', () => { this.chosen = this.cursor = null; this.again(); });
    this.backward = button('◀ Back', 'back to the previous action or event', () => this.back());
    this.into = button('Next action ▶', 'to the next action, also into an include or a group', () => this.go('into'));
    this.next = button('Over ↷', 'to the next action after this include or group', () => this.go('next'));
    this.event = button('Next event ⚡', 'to the next event that launch processes', () => this.go('event'));
    this.place = make('input', { type: 'text', class: 'mono line', placeholder: 'file:line', 'aria-label': 'file and line to run to' });
    this.to = button('Run to line', 'run to the next action that this line makes', () => this.run());
    this.place.addEventListener('keydown', event => { event.stopPropagation(); if (event.key === 'Enter') this.run(); });
    this.first = button('Step from the start', 'step through the launch again from its first action', () => this.start());
    this.stops = make('input', { type: 'checkbox' });
    this.stops.addEventListener('change', () => { desk.machine.steps_launches = this.stops.checked; desk.send({ op: 'stops', on: this.stops.checked }); });
    this.stopping = make('label', {}, this.stops, ' stop each new launch before its first action');
    this.where = make('p', { class: 'where', role: 'status' });
    this.tree = make('div', { class: 'scroll steps', role: 'region', 'aria-label': 'actions of the launch', tabindex: 0 });
    this.top = make('ul', {});
    this.told = make('div', { class: 'told step-told', role: 'region', 'aria-label': 'the chosen action' });
    this.events = make('div', { class: 'scroll events', role: 'region', 'aria-label': 'events of the launch', tabindex: 0 });
    this.box.append(make('div', { class: 'tools' }, this.which, this.backward, this.into, this.next, this.event, this.place, this.to, this.first), make('div', { class: 'tools' }, this.stopping),
      this.where, make('div', { class: 'launch-body' }, this.tree, make('div', {}, this.told, this.events)));
  }
  get launch() { return this.desk.store.launches.get(Number(this.which.value)); }
  again() { this.key = null; this.desk.redraw(); }
  start() {
    this.cursor = null;
    if (this.desk.live && this.desk.machine.can_continue) this.desk.send({ op: 'stops', on: true, again: true });
    else { this.cursor = 0; this.go('into'); }
  }

  /* The steps in the order in which launch reached them: actions of launch files, and events. */
  stops_of(launch) { return launch.order.filter(row => row.kind === 'event' || (row.file && !HIDDEN_STEPS.has(row.kind))); }
  /* Whether launch had reached a step at the shown instant. */
  came(row, time) { return row.order > 0 && (this.cursor === null ? row.t <= time + 1e-7 && row.number !== this.launch.at : row.order < this.cursor); }
  here() {
    const { launch } = this;
    if (!launch) return null;
    if (this.cursor !== null) return launch.order.find(row => row.order === this.cursor) || null;
    return this.desk.follow && launch.at !== null ? launch.steps[launch.at] || null : null;
  }
  /* The number of steps that launch had reached at the shown instant. */
  reached() {
    const here = this.here();
    if (this.cursor !== null) return this.cursor;
    if (here) return here.order;
    const past = this.launch.order.filter(row => row.t <= this.desk.time + 1e-7);
    return past.length ? past[past.length - 1].order + 1 : 0;
  }
  go(way) {
    const { launch, desk } = this;
    if (!launch) return;
    const from = this.reached(), here = this.here(), [file, line] = this.wanted() || [];
    let deep = way === 'next' && here && here.kind !== 'event' ? here.depth : Infinity;
    const found = this.stops_of(launch).find(row => {
      if (row.order <= from && !(from === row.order && !here)) return false;
      if (row.kind === 'event') { deep = Infinity; return way === 'event'; }
      return way === 'line' ? baseName(row.file) === baseName(file) && (row.line === line || row.details.some(([kind, , , created]) => kind === 'created' && created === line)) : way !== 'event' && row.depth <= deep;
    });
    if (found && !(launch.at !== null && found.number === launch.at)) { this.show(found); return; }
    if (desk.live && (launch.at !== null || !launch.over)) {
      this.cursor = null;
      desk.follow = true;
      desk.send({ op: 'launch', pid: launch.pid, way, file, line });
      this.again();
    } else if (found) this.show(found);
    else desk.say(way === 'line' ? 'the launch does not reach this line after this instant' : way === 'event' ? 'no event follows' : 'no action follows');
  }
  back() {
    const { launch } = this;
    if (!launch) return;
    const from = this.reached(), before = this.stops_of(launch).filter(row => row.order < from);
    if (before.length) this.show(before[before.length - 1]);
    else this.desk.say('this is the first action of the launch');
  }
  show(row) {
    this.cursor = row.order;
    this.chosen = row.number;
    this.desk.seek(row.t, true);
    this.again();
    this.scrollTo = true;
  }
  /* The slider or the clock has moved, so the order of steps within one instant no longer matters. */
  moved() { if (this.cursor !== null) { this.cursor = null; this.key = null; } }
  wanted() {
    const text = this.place.value.trim().match(/^(.*):(\d+)$/);
    return text ? [text[1], Number(text[2])] : null;
  }
  run() { if (this.wanted()) this.go('line'); else this.desk.say('give a file and a line, such as demo.launch.py:12'); }

  draw(time) {
    if (this.desk.live && this.desk.follow) this.moved();
    const { store, live, machine } = this.desk, launches = [...store.launches.values()];
    const names = launches.map(one => `${one.pid} ${one.name}`).join();
    if (names !== this.names) {
      this.names = names;
      const before = this.which.value;
      this.which.replaceChildren(...launches.map(one => make('option', { value: one.pid }, `${one.name} (pid ${one.pid})`)));
      this.which.value = launches.length ? launches[launches.length - 1].pid : '';  /* the newest launch, which the user has just started */
      if (this.which.value !== before) this.chosen = this.cursor = null;
    }
    this.which.hidden = launches.length < 2;
    this.stopping.hidden = !live;
    if (this.stops.checked !== Boolean(machine.steps_launches)) this.stops.checked = Boolean(machine.steps_launches);
    const { launch } = this;
    if (!launch) {
      if (this.key !== 'nothing') { this.key = 'nothing'; this.tree.replaceChildren(make('p', { class: 'soft' }, live ? 'No launch file runs here yet. Launch one to see its actions.' : 'This recording does not contain the steps of a launch.')); this.told.replaceChildren(); this.events.replaceChildren(); this.where.textContent = ''; }
      return;
    }
    if (!this.key || this.desk.isTimeToTell(this)) this.tell(launch, time);
  }
  tell(launch, time) {
    const states = launch.steps.map(row => row ? this.state(row, time) : null), here = this.here();
    const key = [launch.pid, launch.version, this.cursor, this.chosen, here?.number, [...this.closed].join(' '), states.map(state => state?.[1]).join('|')].join(';');
    this.where.textContent = here ? `${here.kind === 'event' ? 'Before the event' : 'Before'}: ${titled(here)}${place(here) ? `  (${place(here)})` : ''}` : this.desk.live && this.desk.follow ? 'The launch runs.' : `The launch at ${time.toFixed(3)} s.`;
    if (key === this.key) return;
    this.key = key;
    const scrolled = this.tree.scrollTop, focused = this.box.getRootNode().activeElement?.dataset?.step;
    if (this.of !== launch) { this.of = launch; this.items = new Map(); }
    if (this.top.parentNode !== this.tree) this.tree.replaceChildren(this.top);
    this.listed(this.top, this.branch(launch, -1, states, here, time));
    this.tree.scrollTop = scrolled;
    if (focused !== undefined) this.tree.querySelector(`[data-step="${focused}"]`)?.focus({ preventScroll: true });
    if (this.scrollTo || (here && here.number !== this.before)) this.tree.querySelector('.here')?.scrollIntoView({ block: 'nearest' });
    this.before = here?.number;
    this.scrollTo = false;
    const chosen = launch.steps[this.chosen] || here || launch.steps.find(row => row?.file);
    this.told.replaceChildren(...(chosen ? this.about(launch, chosen, states[chosen.number]) : []));
    this.list(launch, time);
  }
  /* The state of a step: a class for its style, and a description. */
  state(row, time) {
    if (!this.came(row, time)) return ['waiting', row.parent >= 0 && !this.cursorBefore(row) && row.order === 0 ? this.waits(row, time) : 'waiting'];
    if (row.state === 'failed') return ['failed', `failed: ${row.error}`];
    if (row.state === 'left out') return ['left', `left out: ${this.reason(row)}`];
    if (row.process && row.runs) {
      const run = [...row.runs].reverse().find(([, from]) => this.started(row, from, time));
      if (!run) return ['taken', 'starts'];
      const [pid, , end, code] = run, again = row.runs.indexOf(run) ? `, run ${row.runs.indexOf(run) + 1}` : '';
      if (end === null || !this.ended(row, end, time)) return ['running', `running, pid ${pid}${again}`];
      return code === 0 ? ['ended', `ended, exit code 0${again}`] : ['failed', `${code < 0 ? `ended by signal ${-code}` : `died, exit code ${code}`}${again}`];
    }
    if (row.due !== undefined) return this.timer(row, time);
    if (row.handlers) {
      const times = (row.fired_at || []).filter(at => this.past(at, time, row)).length;
      return times ? ['taken', `fired ${times === 1 ? 'once' : `${times} times`}`] : ['idle', 'never fired'];
    }
    return ['taken', row.state === 'visiting' ? 'is visited' : 'done'];
  }
  /* Why an action was left out: the launch configurations that its condition reads, or the condition itself. */
  reason(row) {
    const read = (row.values || []).filter(one => one.kind === 'reason');
    return read.length ? read.map(one => `${one.name} is ${shownValue(one.value)}`).join(', ') : `${row.condition} is not true`;
  }
  cursorBefore(row) { return this.cursor !== null && row.order >= this.cursor; }
  waits(row) {
    const parent = this.launch.steps[row.parent];
    return parent?.due !== undefined ? 'waits for the timer' : parent?.handlers ? 'waits for the event' : 'waiting';
  }
  /* The events of a process or timer, and those that fired a handler. */
  events_of(row) { return this.launch.events.get(row.number) || []; }
  past(at, time, row) {
    if (this.cursor === null) return at <= time + 1e-7;
    return this.events_of(row).some(event => event.order < this.cursor && event.t === at);
  }
  started(row, from, time) {
    return this.cursor === null ? from <= time + 1e-7 : this.events_of(row).some(event => event.event === 'ProcessStarted' && event.t === from && event.order < this.cursor);
  }
  ended(row, end, time) {
    return this.cursor === null ? end <= time + 1e-7 : this.events_of(row).some(event => event.event === 'ProcessExited' && event.t === end && event.order < this.cursor);
  }
  timer(row, time) {
    const fired = (row.fired_at || []).find(at => this.past(at, time, row));
    if (fired !== undefined) return ['taken', `ran out at ${fired.toFixed(2)} s`];
    const shutdown = this.launch.order.find(event => event.event === 'Shutdown' && this.came(event, time));
    return shutdown ? ['left', 'cancelled by the shutdown'] : ['waiting', `fires at ${row.due.toFixed(2)} s`];
  }
  /* The elements of the steps below a step, in their order. */
  branch(launch, parent, states, here, time) {
    const shown = [];
    for (const row of launch.below.get(parent) || []) {
      if (row.kind === 'event') continue;
      const inner = this.closed.has(row.number) ? [] : this.branch(launch, row.number, states, here, time);
      if (HIDDEN_STEPS.has(row.kind) || (!row.file && row.kind !== 'include')) shown.push(...inner);
      else if (row.order || parent < 0 || row === here || this.came(launch.steps[parent], time)) shown.push(this.item(launch, row, states[row.number], row === here, inner));
    }
    return shown;
  }
  /* The element of a step. It stays from picture to picture, and only what has changed is written: a launch can have a thousand steps. */
  item(launch, row, [look, words], isNext, inner) {
    if (!this.items.has(row.number)) this.items.set(row.number, this.made(row));
    const one = this.items.get(row.number), isChosen = this.chosen === row.number, isOpen = !this.closed.has(row.number), folds = Boolean(launch.below.get(row.number)?.length);
    const texts = [titled(row), isNext ? `▶ next · ${words}` : words, place(row)], key = [look, isNext, isChosen, isOpen, folds, ...texts].join('\n');
    if (key !== one.key) {
      one.key = key;
      this.written++;
      one.step.className = `step ${look}${isNext ? ' here' : ''}`;
      if (isNext) one.step.setAttribute('aria-current', 'step'); else one.step.removeAttribute('aria-current');
      one.step.setAttribute('aria-pressed', String(isChosen));
      texts.forEach((text, i) => { one.step.children[i].textContent = text; });
      one.fold.hidden = !folds;
      one.fold.textContent = isOpen ? '▾' : '▸';
      one.fold.setAttribute('aria-expanded', String(isOpen));
      one.fold.setAttribute('aria-label', `${isOpen ? 'fold' : 'unfold'} ${row.text}`);
    }
    this.listed(one.list, inner);
    return one.item;
  }
  made(row) {
    const { number } = row, step = make('button', { type: 'button', 'data-step': number }, ...['what', 'state-of', 'at mono'].map(name => make('span', { class: name })));
    step.addEventListener('click', () => { this.chosen = number; if (row.file) this.place.value = place(row); this.again(); });
    const fold = make('button', { type: 'button', class: 'fold' }), list = make('ul', { hidden: true });
    fold.addEventListener('click', () => { if (!this.closed.delete(number)) this.closed.add(number); this.again(); });
    return { step, fold, list, item: make('li', {}, fold, step, list) };
  }
  listed(list, items) {
    if (list.children.length === items.length && items.every((item, i) => list.children[i] === item)) return;
    list.replaceChildren(...items);
    list.hidden = !items.length;
  }
  /* The details of one step. */
  about(launch, row, [look, words]) {
    const rows = [make('p', {}, make('b', {}, row.text), ' ', make('span', { class: 'mono' }, place(row))), make('p', {}, `State: ${words}.`)];
    if (row.condition) rows.push(make('p', {}, `Condition: ${row.condition}`));
    for (const text of row.handlers || []) rows.push(make('p', {}, `Waits for ${text}.`));
    if (row.error) rows.push(make('p', { class: 'bad' }, row.error));
    for (const [, text, file, line] of row.details) rows.push(make('p', { class: 'mono' }, text, file ? make('span', { class: 'soft' }, ` ${baseName(file)}:${line}`) : ''));
    if (row.values?.length) rows.push(make('table', { class: 'small' }, make('tr', {}, ...['name', 'value', 'where it comes from'].map(text => make('th', { scope: 'col' }, text))),
      ...row.values.map(one => make('tr', {}, make('td', { class: 'named' }, one.kind === 'reason' ? '' : make('span', { class: 'soft' }, one.kind + ' '), one.name), make('td', { class: 'mono' }, shownValue(one.value)), make('td', {}, this.chain(one.chain))))));
    if (row.process && this.desk.live && this.desk.follow) rows.push(this.buttons(launch, row, look === 'running'));
    rows.push(this.context(launch, row));
    return rows;
  }
  /* The origins of a value, from the first one to the effective one. */
  chain(steps) {
    if (!steps.length) return make('span', { class: 'soft' }, 'nothing sets it');
    return make('ol', { class: 'chain' }, ...steps.map(step => make('li', { class: step.counts ? 'counts' : 'lost' }, `${shownValue(step.value)} — ${step.origin}`,
      step.file && !step.origin.endsWith(`${baseName(step.file)} line ${step.line}`) ? make('span', { class: 'soft' }, ` ${place(step)}`) : '', step.counts && steps.length > 1 ? ' (counts)' : '', step.argument?.length ? this.chain(step.argument) : '')));
  }
  buttons(launch, row, runs) {
    const ask = what => this.desk.send({ op: 'process', pid: launch.pid, number: row.number, what });
    const ends = [button('Stop', `send SIGINT to ${row.process}, as Ctrl-C does`, () => ask('stop')), button('Kill', `send SIGKILL to ${row.process}`, () => ask('kill'))];
    for (const end of ends) end.disabled = !runs;
    return make('div', { class: 'tools' }, ...ends,
      button('Restart', `start ${row.process} again`, () => ask('restart')), button('Log', `show the log of ${row.process}`, () => this.desk.log(row.process)));
  }
  /* The launch configurations and the environment before a step. */
  context(launch, row) {
    const found = { configurations: new Map(), environment: new Map() }, until = row.order || this.reached();
    for (const step of launch.order) {
      if (step.order > until) break;
      for (const [kind, changes] of Object.entries(step.changes || {})) for (const [name, value] of Object.entries(changes)) {
        if (value === null && kind === 'configurations') found.configurations.delete(name); else found[kind]?.set(name, value);
      }
    }
    const own = { ros_namespace: 'namespace', ros_remaps: 'remappings', global_params: 'parameters for all nodes' }, lines = [];
    for (const [name, text] of Object.entries(own)) {
      const value = found.configurations.get(name);
      if (value !== undefined && String(value).length) lines.push([text, Array.isArray(value) ? value.map(one => Array.isArray(one) ? one.join(' → ') : one).join(', ') : value]);
    }
    for (const [name, value] of found.configurations) if (!(name in own)) lines.push([name, shownValue(value)]);
    for (const [name, value] of found.environment) lines.push([`$${name}`, value === null ? 'unset' : shownValue(value)]);
    return make('details', { class: 'context', open: true }, make('summary', {}, row.order ? 'Context before this action' : 'Context now'),
      lines.length ? make('table', { class: 'small' }, ...lines.map(([name, value]) => make('tr', {}, make('th', { scope: 'row' }, name), make('td', { class: 'mono' }, value)))) : make('p', { class: 'soft' }, 'No launch configuration is set.'));
  }
  list(launch, time) {
    const rows = launch.order.filter(row => row.kind === 'event' && this.came(row, time)).slice(-200).reverse();
    const fired = row => (row.fired || []).map(number => launch.steps[number]).filter(Boolean).map(step => `${step.text} (${place(step)})`).join(', ');
    this.events.replaceChildren(rows.length ? make('table', { class: 'small' }, make('caption', {}, 'Events, the newest first'), make('tr', {}, ...['time', 'event', 'handlers that fired'].map(text => make('th', { scope: 'col' }, text))),
      ...rows.map(row => make('tr', {}, make('td', { class: 'whole' }, row.t.toFixed(3)), make('td', {}, row.text), make('td', {}, fired(row) || '–')))) : make('p', { class: 'soft' }, 'No event yet.'));
  }
}
