/* The live view: its layout, the time bar, the keyboard, and the requests to the machine. */

const TICK_S = 0.016, SLOW_MS = [40, 90, Infinity], SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8, 0];

/* On a busy computer, some pictures leave out the open tab, the trails and the names. The page always handles input. */
class Effort {
  constructor() { this.mean = 0; this.level = 0; this.count = 0; }
  /* `spent` is the time in milliseconds from the request of a picture to its end. The average of some pictures is used. */
  took(spent) {
    this.mean += (Math.min(spent, 500) - this.mean) / 8;
    if (this.mean > SLOW_MS[this.level]) this.level = Math.min(2, this.level + 1);
    else if (this.level && this.mean < SLOW_MS[this.level - 1] * 0.6) this.level--;
  }
  /* Whether to draw details in this picture: in each picture, in every second one, or in every fourth one. */
  get isTurn() { return this.count++ % (1 << this.level) === 0; }
}

class Desk {
  /* `link` is null for a recording, and {send(request), on(handler)} for a live machine. */
  constructor(root, link, options = {}) {
    Object.assign(this, { root, link, live: Boolean(link), store: new Store(), time: 0, playing: false, follow: Boolean(link), speed: 1, effort: new Effort() });
    this.store.grows = this.live;
    this.machine = { running: true, speed: 1 };
    this.options = { axes: false, colours: true, whole: Boolean(options.whole) };
    this.box = make('section', { class: options.whole ? 'desk whole' : 'desk', 'aria-label': link ? 'live view of the machine' : 'replay of a run' });
    root.append(this.box);
    this.head();
    this.stage();
    this.side(options.tab);
    this.bar();
    this.follows(options.theme);
    new ResizeObserver(() => { if (!this.colours.field) this.theme(this.box.dataset.theme); this.redraw(); }).observe(this.box);
    if (link) link.on(message => this.hear(message));
    this.box.addEventListener('keydown', event => this.key(event));
    this.beat = this.beat.bind(this);
    this.redraw();
  }
  head() {
    this.title = make(this.options.whole ? 'h1' : 'strong', {}, 'edulaunch');
    this.state = make('span', { class: 'state', role: 'status' });
    this.alerts = new AlertsView(this);
    this.save = button('Export', 'save the run so far as a page that replays it, from disk and without a network', () => this.send({ op: 'export' }));
    this.save.hidden = !this.live;
    this.net = button('Network', 'join the real ROS 2 network, or leave it', () => this.send({ op: 'network', on: !this.machine.network }));
    this.net.hidden = true;
    this.dark = button('◐', 'switch between dark and light', () => { this.own = true; this.theme(this.box.dataset.theme === 'dark' ? 'light' : 'dark'); });
    this.box.append(make('header', {}, this.title, this.state, this.alerts.box, this.alerts.ask, this.net, this.save, this.dark));
  }
  stage() {
    this.worlds = make('div', { class: 'worlds' });
    this.empty = make('p', { class: 'soft' }, 'Nothing to draw yet: no turtle or robot has published a position.');
    const toggle = (text, name) => {
      const box = make('input', { type: 'checkbox' });
      box.checked = this.options[name];
      box.addEventListener('change', () => { this.options[name] = box.checked; this.redraw(); });
      return make('label', {}, box, ' ' + text);
    };
    this.drivebar = make('div', { class: 'drive', hidden: !this.live });
    this.pad();
    this.left = make('div', { class: 'left' }, this.worlds, this.empty,
      make('div', { class: 'tools' }, toggle('tf axes', 'axes'), toggle('a colour for each trail', 'colours')), this.drivebar);
  }
  side(first) {
    this.views = {
      launch: [new LaunchView(this), 'Launch'], frames: [new FramesView(this), 'Frames'], tree: [new TreeView(this), 'tf tree'], graph: [new GraphView(this), 'Graph'],
      timeline: [new TimelineView(this), 'Timeline'], plot: [new PlotView(this), 'Plot'], log: [new LogView(this), 'Log'],
      parameters: [new ParameterView(this), 'Parameters'], terminal: [new TerminalView(this), this.live ? 'Terminal' : 'Output'],
    };
    this.tabs = make('div', { class: 'tabs', role: 'tablist' });
    this.panel = make('div', { class: 'panel', role: 'tabpanel' });
    for (const [name, [, text]] of Object.entries(this.views)) {
      const tab = make('button', { type: 'button', role: 'tab', id: 'tab-' + name, 'data-tab': name }, text);
      tab.addEventListener('click', () => this.open(name));
      this.tabs.append(tab);
    }
    this.tabs.addEventListener('keydown', event => {
      const names = Object.keys(this.views), way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!way) return;
      event.stopPropagation();
      this.open(names[(names.indexOf(this.tab) + way + names.length) % names.length]);
      this.tabs.querySelector('[aria-selected=true]').focus();
    });
    this.box.append(make('div', { class: 'body' }, this.left, make('div', { class: 'right' }, this.tabs, this.panel)));
    this.open(this.views[first] ? first : 'graph');
  }
  bar() {
    this.play = button('', 'play or pause (space bar)', () => this.toggle());
    this.what = make('select', { 'aria-label': 'size of a step' }, ...[['tick', 'one tick'], ['message', 'one message'], ...(this.live ? [['callback', 'one callback']] : [])].map(([value, text]) => make('option', { value }, text)));
    this.pace = make('select', { 'aria-label': 'speed' }, ...SPEEDS.map(value => make('option', { value }, value ? `${value}×` : 'fastest')));
    this.pace.value = 1;
    this.pace.addEventListener('change', () => { this.speed = Number(this.pace.value); if (this.live) this.send({ op: 'speed', speed: this.speed }); });
    this.slider = make('input', { type: 'range', min: 0, max: 1000000, step: 1, value: 0, 'aria-label': 'time in the run' });
    this.slider.addEventListener('input', () => this.seek(this.from + Number(this.slider.value) / 1e6 * (this.store.now - this.from)));
    this.clock = make('output', { class: 'clock mono' });
    this.now = button('● Live', 'return to the present', () => { this.follow = true; this.redraw(); });
    this.again = button('Continue from here', 'run the launch again with the same seed and inputs up to this instant, and continue from there', () => this.send({ op: 'continue', time: this.time }));
    for (const control of [this.now, this.again]) control.hidden = true;
    this.box.append(make('footer', { role: 'group', 'aria-label': 'time' }, this.play, button('⇤', 'one step back', () => this.step(-1)),
      button('⇥', 'one step forward', () => this.step(1)), this.what, make('label', {}, 'speed ', this.pace), this.slider, this.clock, this.now, this.again));
  }
  pad() {
    const ways = [['↺', 0, 2, 'turn left'], ['↑', 2, 0, 'forward'], ['↓', -2, 0, 'backward'], ['↻', 0, -2, 'turn right']];
    this.who = make('select', { 'aria-label': 'turtle or robot to drive' });
    const stick = make('div', { class: 'stick', role: 'img', 'aria-label': 'joystick: drag to drive' }, make('i', {}));
    const drive = event => {
      const box = stick.getBoundingClientRect(), part = (value, size) => Math.max(-1, Math.min(1, value / size * 2 - 1));
      const across = part(event.clientX - box.left, box.width), down = part(event.clientY - box.top, box.height);
      stick.firstChild.style.transform = `translate(${across * 22}px, ${down * 22}px)`;
      this.wanted = [-down * 2, -across * 2];
    };
    stick.addEventListener('pointerdown', event => {
      stick.setPointerCapture(event.pointerId);
      drive(event);
      this.driving = setInterval(() => this.drive(...this.wanted), 100);
      this.drive(...this.wanted);
    });
    stick.addEventListener('pointermove', event => { if (event.buttons) drive(event); });
    for (const end of ['pointerup', 'pointercancel']) stick.addEventListener(end, () => { clearInterval(this.driving); stick.firstChild.style.transform = ''; this.drive(0, 0); });
    this.drivebar.append(make('label', {}, 'drive ', this.who), ...ways.map(([text, linear, angular, title]) => button(text, title, () => this.drive(linear, angular))), stick,
      make('span', { class: 'soft' }, 'or click the picture and use the arrow keys'));
  }
  /* A recording is complete; a machine that has run for long has dropped its oldest messages. */
  get from() { return this.live ? this.store.from : 0; }
  get shown() { return this.views[this.tab][0]; }
  open(name) {
    this.tab = name;
    for (const tab of this.tabs.children) {
      tab.setAttribute('aria-selected', tab.dataset.tab === name);
      tab.tabIndex = tab.dataset.tab === name ? 0 : -1;
    }
    this.panel.setAttribute('aria-labelledby', 'tab-' + name);
    this.panel.replaceChildren(this.shown.box);
    this.redraw();
  }
  /* The page uses the theme of JupyterLab or, elsewhere, of the system. The button ◐ overrides the theme. */
  follows(given) {
    const system = matchMedia('(prefers-color-scheme: dark)'), { body } = document;
    const wanted = () => given || (body?.dataset.jpThemeLight ? (body.dataset.jpThemeLight === 'false' ? 'dark' : 'light') : system.matches ? 'dark' : 'light');
    const change = () => { if (!this.own && this.box.dataset.theme !== wanted()) this.theme(wanted()); };
    this.theme(wanted());
    system.addEventListener('change', change);
    if (body) new MutationObserver(change).observe(body, { attributes: true, attributeFilter: ['data-jp-theme-light'] });
  }
  theme(name) {
    this.box.dataset.theme = name;
    const of = name => getComputedStyle(this.box).getPropertyValue('--' + name).trim();
    this.colours = Object.fromEntries(['ink', 'soft', 'field', 'grid', 'plate', 'bar', 'x', 'y', 'z', 'mark', 'bad', 'good', 'lit'].map(name => [name, of(name)]));
    this.redraw();
  }
  tree(time) {
    if (this.known?.time !== time || this.known.store !== this.store || this.known.now !== this.store.now) this.known = Object.assign(new Tree(this.store, time), { now: this.store.now });
    return this.known;
  }
  log(process) { this.views.log[0].choose(process); this.open('log'); }
  plot(topic, path) { this.views.plot[0].add(topic.name, path); this.open('plot'); }
  /* Show the subject of a piece of advice. */
  point(kind, name, time) {
    if (!this.live && this.time < time) this.seek(time);
    const tab = kind === 'frame' ? 'frames' : 'graph';
    this.open(tab);
    this.views[tab][0].point(kind, name);
  }
  select(mover) { if (mover) this.who.value = mover.path; }
  canMove(mover) { return this.live && !this.machine.running && this.follow && mover.world.kind === 'turtlesim'; }
  drive(linear, angular) {
    if (this.live && !this.machine.running && (linear || angular)) this.say('Time is paused, so nothing moves. Press Play or the space bar, then drive.');
    if (this.live) this.send({ op: 'drive', turtle: this.who.value, linear, angular }); }
  send(words) { this.link?.send(words); }

  /* Handle a message of the machine: a timeline delta, its state, output of the terminal, or a notice. */
  hear(message) {
    if (message.reset) { this.store = new Store(); this.store.grows = true; this.worldKey = null; this.views.graph[0].key = null; this.views.plot[0].restart(); this.follow = true; }
    if (message.delta) this.store.apply(message.delta);
    if (message.defaults) this.store.known(message.defaults);
    if (message.machine) Object.assign(this.machine, message.machine);
    if (message.pane !== undefined) this.views.terminal[0].hear(message);
    if (message.export) this.download(message.export, message.name);
    if ('ended' in message) this.ended = message.ended;
    else if (message.delta) this.ended = null;
    if (message.said) this.say(message.said);
    this.redraw();
  }
  download(text, name, type = 'text/html') {
    const place = URL.createObjectURL(new Blob([text], { type })), link = make('a', { href: place, download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(place), 60_000);
    this.say(`saved as ${name}`);
  }
  say(text) { this.state.textContent = text; this.saidAt = performance.now(); }
  /* A plan has a graph and parameters, but nothing moves in it. */
  showPlan() {
    this.box.setAttribute('aria-label', 'plan of a launch file');
    for (const tab of [...this.tabs.children]) if (!['graph', 'parameters'].includes(tab.dataset.tab)) { delete this.views[tab.dataset.tab]; tab.remove(); }
    this.left.hidden = true;
    this.left.parentElement.style.gridTemplateColumns = 'minmax(0, 1fr)';
    this.box.querySelector('footer').hidden = true;
    this.title.textContent = document.title;
    this.views.graph[0].unused.checked = true;
    this.open('graph');
  }
  load(delta, seen) { this.store.apply(delta); if (delta.planned) this.showPlan(); if (delta.other) this.views.plot[0].over(delta.other); this.time = 0; if (seen) seen.desk = this; this.redraw(); }

  toggle() {
    if (this.live) { if (this.follow) this.send({ op: this.machine.running ? 'pause' : 'play' }); else { this.playing = !this.playing; } }
    else {
      this.playing = !this.playing;
      if (this.playing && this.time >= this.store.now) this.time = 0;
    }
    this.redraw();
  }
  step(way) {
    if (this.live && this.follow && way > 0) { this.send({ op: 'step', what: this.what.value }); return; }
    this.playing = false;
    if (this.what.value === 'message') {
      const stamps = [...this.store.topics.values()].map(topic => topic.t);
      const next = way > 0 ? stamps.map(t => t.a[t.upTo(this.time + 1e-7)] ?? Infinity).filter((_, i) => stamps[i].upTo(this.time + 1e-7) < stamps[i].n)
        : stamps.map(t => t.upTo(this.time - 1e-6)).map((count, i) => count ? stamps[i].a[count - 1] : -Infinity);
      const found = way > 0 ? Math.min(...next, Infinity) : Math.max(...next, 0);
      if (Number.isFinite(found)) this.seek(found);
    } else this.seek(Math.round(this.time / TICK_S + way) * TICK_S);
  }
  seek(time, isStep = false) {
    this.follow = false;
    if (!isStep) this.views.launch[0].moved();
    this.time = Math.max(this.from, Math.min(this.store.now, time));
    if (!this.live || !this.playing) this.playing = false;
    this.redraw();
  }
  key(event) {
    const inside = event.composedPath()[0];
    if (['SELECT', 'INPUT', 'TEXTAREA'].includes(inside.tagName) && inside.type !== 'range' && inside.type !== 'checkbox') return;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (inside.closest('.scroll') && inside.tabIndex === 0 && event.key.startsWith('Arrow')) return;
    const picture = inside.tagName === 'CANVAS' && this.live && this.follow;
    const ways = { ArrowUp: [2, 0], ArrowDown: [-2, 0], ArrowLeft: [0, 2], ArrowRight: [0, -2] };
    if (picture && event.key in ways) this.drive(...ways[event.key]);
    else if (event.key === ' ' && inside.tagName !== 'BUTTON' && inside.tagName !== 'SUMMARY') this.toggle();
    else if (event.key === 'ArrowLeft' || event.key === 'ArrowRight') {
      const way = event.key === 'ArrowRight' ? 1 : -1;
      if (event.shiftKey) this.seek(this.time + way); else this.step(way);
    } else if (event.key === 'Home') this.seek(this.from);
    else if (event.key === 'End') { this.seek(this.store.now); this.follow = this.live; }
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
  /* People cannot read tables faster than five times a second; while time is paused, each change is shown. */
  get moves() { return this.playing || (this.live && this.follow && this.machine.running && !this.ended); }
  isTimeToTell(view) {
    const now = performance.now();
    if (this.moves && now - (view.toldAt || 0) < 200) return false;
    view.toldAt = now;
    return true;
  }
  redraw() {
    if (!this.beat || this.asked) return;
    this.asked = performance.now();
    requestAnimationFrame(stamp => {
      const { asked } = this;
      this.asked = 0;
      this.beat(stamp);
      this.effort.took(this.moves ? performance.now() - asked : 0);
    });
  }
  beat(stamp) {
    const passed = Math.min(0.1, (stamp - (this.before || stamp)) / 1000);
    this.before = stamp;
    if (this.live && this.follow) this.time = this.store.now;
    else if (this.playing) {
      this.time = Math.min(this.store.now, this.time + passed * (this.speed || 50));
      if (this.time >= this.store.now) { this.playing = false; this.follow = this.live; }
    }
    if (!this.colours || !this.views) return;
    this.time = Math.max(this.time, this.from);
    this.layout();
    this.hurry = this.moves ? this.effort.level : 0;
    this.isTurn = this.effort.isTurn || !this.hurry;
    for (const view of this.worldViews || []) if (!this.fold(view)) view.draw(this.time);
    if (this.isTurn) this.shown.draw(this.time);
    this.marks();
    if (this.playing) this.redraw(); else this.before = 0;
  }
  /* The window of a turtlesim that has ended is collapsed to one line; a click opens it again. */
  fold(view) {
    const { world } = view, { store } = this, last = world.kind === 'turtlesim' ? store.nodes.filter(node => node?.name === world.node && node.from <= this.time + 1e-7).pop() : null;
    const gone = Boolean(last && last.to <= this.time + 1e-7) && (this.worldViews.length > 1 || this.live);
    view.folded(gone ? last.to : null);
    return gone && !view.open;
  }
  layout() {
    const key = this.store.version;
    if (key !== this.worldKey || !this.worldViews) {
      this.worldKey = key;
      const worlds = readWorlds(this.store), same = this.worldViews && worlds.length === this.worldViews.length && worlds.every((world, i) => world.title === this.worldViews[i].world.title);
      if (same) worlds.forEach((world, i) => { this.worldViews[i].world = world; });
      else {
        this.worldViews = worlds.map(world => new WorldView(this, world));
        this.worlds.replaceChildren(...this.worldViews.map(view => view.figure));
      }
      this.empty.hidden = worlds.length > 0;
      const movers = worlds.flatMap(world => world.movers), before = this.who.value;
      this.who.replaceChildren(...movers.map(mover => make('option', { value: mover.path }, mover.path)));
      if (movers.some(mover => mover.path === before)) this.who.value = before;
      this.alerts.update();
    }
    const room = this.left.clientWidth, count = this.worldViews.length;
    if (room) for (const view of this.worldViews) view.resize(Math.floor(Math.max(180, Math.min(count > 1 ? (room - 14) / 2 : room - 4, count > 1 ? 360 : 560))));
  }
  /* Whether programs have run, and all of them have ended. */
  stopped() {
    const programs = this.store.processes.filter(Boolean);
    return programs.length > 0 && programs.every(process => process.to <= this.time + 1e-7);
  }
  marks() {
    const { store } = this, running = this.live && this.follow ? this.machine.running && !this.ended : this.playing;
    this.play.disabled = Boolean(this.ended) && this.follow;
    this.play.textContent = running ? '❚❚ Pause' : '▶ Play';
    this.clock.textContent = `${this.time.toFixed(3)} s`;
    this.slider.value = store.now > this.from ? Math.round((this.time - this.from) / (store.now - this.from) * 1e6) : 0;
    this.slider.setAttribute('aria-valuetext', `${this.time.toFixed(2)} of ${store.now.toFixed(2)} seconds`);
    this.now.hidden = !this.live || this.follow;
    this.net.hidden = !this.live || typeof this.machine.network !== 'boolean';
    this.net.setAttribute('aria-pressed', this.machine.network === true);
    this.net.textContent = this.machine.network ? 'Leave the network' : 'Network';
    this.again.hidden = !this.live || this.follow || !this.machine.can_continue;
    this.box.classList.toggle('over', Boolean(this.ended));
    if (!this.ended && this.saidAt && performance.now() - this.saidAt < 6000) return;
    this.state.textContent = this.ended || (store.planned ? 'planned; nothing runs' : !this.live ? `${store.now.toFixed(2)} s recorded` : !this.follow ? 'looking back; the machine ' + (this.machine.running ? 'continues' : 'is paused')
      : (!this.machine.running ? 'paused' : this.stopped() ? 'stopped: every program has ended' : 'running') + (this.from ? `, shown from ${this.from.toFixed(0)} s: older messages are dropped` : ''));
  }
}

function button(text, title, action) {
  const names = /\w/.test(text) && !title.toLowerCase().startsWith(text.toLowerCase());
  const element = make('button', { type: 'button', title, 'aria-label': names ? `${text}: ${title}` : title }, text);
  element.addEventListener('click', action);
  return element;
}

/* A live view in its own shadow root, so that neither page changes the style of the other. */
function openDesk(host, link, options) {
  host.setAttribute('data-lm-suppress-shortcuts', 'true');  /* the notebook's keyboard shortcuts are off while the live view has the focus */
  const root = host.shadowRoot || host.attachShadow({ mode: 'open' });
  root.replaceChildren(make('style', {}, STYLE));
  return new Desk(root, link, options);
}

/* Read a timeline that `packed` (page.py) has written: a letter that shows whether it is compressed, then base64. */
async function unpacked(text) {
  let stream = new Blob([Uint8Array.from(atob(text.slice(1)), letter => letter.charCodeAt(0))]).stream();
  if (text[0] === 'z') stream = stream.pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(stream).text());
}
