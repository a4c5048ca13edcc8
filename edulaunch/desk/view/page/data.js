/* The data of the page: columns that only grow, filled by the deltas of a timeline (edulaunch/desk/view/timeline.py). Times are in seconds. */

const FINE = 10000, KEPT_S = 600;

class Grow {
  /* Numbers in one typed array that grows. */
  constructor() { this.a = new Float64Array(256); this.n = 0; this.whole = 0; }
  push(value) {
    if (this.n === this.a.length) {
      const wider = new Float64Array(this.n * 2);
      wider.set(this.a);
      this.a = wider;
    }
    this.a[this.n++] = value;
  }
  /* Append steps in units of 1/scale; `[n]` means n steps of 0, and null means a value that is not finite. */
  steps(steps, scale) {
    for (const step of steps) {
      if (step === null) { this.push(NaN); continue; }
      if (Array.isArray(step)) {
        for (let i = 0; i < step[0]; i++) this.push(this.whole / scale);
        continue;
      }
      this.whole += step;
      this.push(this.whole / scale);
    }
  }
  drop(count) { this.a.copyWithin(0, count, this.n); this.n -= count; }
  /* Return the number of entries up to and including `value`; the column must ascend. */
  upTo(value) {
    let low = 0, high = this.n;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.a[middle] <= value) low = middle + 1; else high = middle;
    }
    return low;
  }
}

class Topic {
  constructor(name, type, fields) {
    Object.assign(this, { name, type, fields, t: new Grow() });
    this.columns = fields.map(([, how]) => how === 'text' ? [] : new Grow());
    this.place = new Map(fields.map(([path], i) => [path, i]));
  }
  add(delta) {
    this.t.steps(delta.t, 1e6);
    delta.c.forEach((steps, i) => {
      const column = this.columns[i];
      if (this.fields[i][1] === 'float') column.steps(steps, FINE);
      else if (this.fields[i][1] === 'number') column.steps(steps, 1);
      else for (const text of steps) column.push(text === null ? column[column.length - 1] ?? '' : text);
    });
  }
  column(path) { return this.columns[this.place.get(path)]; }
  /* The number of the newest message at a time, or -1 before the first message. */
  at(time) { return this.t.upTo(time + 1e-7) - 1; }
  value(path, number) {
    const column = this.column(path);
    return column instanceof Grow ? column.a[number] : column?.[number];
  }
  forgetBefore(time) {
    const count = Math.max(0, Math.min(this.t.upTo(time), this.t.n - 1));
    this.t.drop(count);
    for (const column of this.columns) if (column instanceof Grow) column.drop(count); else column.splice(0, count);
  }
  rate(time, over = 1) {
    const count = this.t.upTo(time) - this.t.upTo(time - over);
    return count / Math.min(over, Math.max(time, 1e-3));
  }
}

class Track {
  /* All transforms of one child in one parent from one publisher. */
  constructor({ child, parent, by, static: fixed }) {
    Object.assign(this, { child, parent, by, fixed, c: Array.from({ length: 9 }, () => new Grow()) });
  }
  add(delta) {
    delta.c.forEach((steps, i) => this.c[i].steps(steps, i < 2 ? 1e6 : i < 5 ? FINE : FINE * 100));
  }
  /* The number of the newest transform that was published by a time, or -1 if there is no such transform. */
  at(time) { return this.c[0].upTo(time + 1e-7) - 1; }
  forgetBefore(time) {
    const count = Math.max(0, Math.min(this.c[0].upTo(time), this.c[0].n - 1));
    for (const column of this.c) column.drop(count);
  }
  transform(number) {
    const [, , x, y, z, qx, qy, qz, qw] = this.c.map(column => column.a[number]);
    return { p: [x, y, z], q: [qx, qy, qz, qw] };
  }
}

class Store {
  constructor() {
    Object.assign(this, {
      start: 0, now: 0, from: 0, grows: false, topics: new Map(), tracks: new Map(), scans: new Map(), robots: [], launches: new Map(), nodes: [], processes: [], endpoints: [],
      planned: null, parameters: [], defaults: new Map(), places: new Map(), descriptors: new Map(), logs: [], output: [], notes: [], calls: [], advice: null, version: 0, publisherNode: new Map(),
    });
  }
  apply(delta) {
    this.start = (delta.start ?? this.start * 1e6) / 1e6;
    this.now = delta.now / 1e6;
    for (const row of delta.topics || []) {
      const key = row.name + ' ' + row.type;
      if (!this.topics.has(key)) { this.topics.set(key, new Topic(row.name, row.type, row.fields)); this.version++; }
      this.topics.get(key).add(row);
    }
    for (const row of delta.tf || []) {
      const key = `${row.child}\n${row.parent}\n${row.by}\n${row.static}`;
      if (!this.tracks.has(key)) { this.tracks.set(key, new Track(row)); this.version++; }
      this.tracks.get(key).add(row);
    }
    for (const [topic, time, frame, angle, step, ranges] of delta.scans || []) {
      if (!this.scans.has(topic)) this.scans.set(topic, []);
      this.scans.get(topic).push({ time: time / 1e6, frame, angle, step, ranges });
    }
    for (const [time, name, described, parts] of delta.robots || []) { this.robots.push({ t: time / 1e6, name, described, parts }); this.version++; }
    const rows = (name, make) => { for (const row of delta[name] || []) { this[name].push(make(row)); this.version++; } };
    rows('endpoints', ([t, kind, name, type, node, index, qos]) => ({ t: t / 1e6, kind, name, type, node, index, qos }));
    rows('parameters', ([t, node, name, value, origin, double]) => ({ t: t / 1e6, node, name, value, origin, double }));
    for (const [, node, name, value, origin] of delta.parameters || []) if (origin === 'default' && !this.defaults.has(node + ' ' + name)) this.defaults.set(node + ' ' + name, value);
    for (const [, node, name, description, fixed, limits] of delta.descriptors || []) { this.descriptors.set(node + ' ' + name, { description, fixed, limits }); this.version++; }
    rows('logs', ([t, process, logger, level, text]) => ({ t: t / 1e6, process, logger, level, text }));
    rows('output', ([t, process, stream, text]) => ({ t: t / 1e6, process, stream, text }));
    rows('notes', ([t, process, kind, text]) => ({ t: t / 1e6, process, kind, text }));
    const living = (name, make) => { for (const row of delta[name] || []) { this[name][row[0]] = make(row); this.version++; } };
    const seconds = value => value === null ? Infinity : value / 1e6;
    living('nodes', ([, name, process, index, from, to]) => ({ name, process, index, from: from / 1e6, to: seconds(to) }));
    living('processes', ([, name, pid, argv, from, to, code, place]) => ({ name, pid, argv, from: from / 1e6, to: seconds(to), code, place }));
    living('calls', ([, t, service, type, client, request, served, replied]) =>
      ({ t: t / 1e6, service, type, client, request, served, replied: seconds(replied) }));
    for (const told of delta.launches || []) this.launched(told);
    for (const end of delta.endpoints || []) this.publisherNode.set(end[5], end[4]);
    for (const [end, place] of delta.places || []) this.places.set(end, place);
    if (delta.defaults) this.known(delta.defaults);
    if (delta.planned) { this.planned = delta.planned; this.version++; }
    if (delta.advice) { this.advice = delta.advice.map(row => ({ ...row, t: row.time / 1e6 })); this.version++; }
    if (!this.grows) return;
    if (this.from === 0 && delta.topics?.length && this.now > KEPT_S) this.from = Math.max(0, this.first());
    if (this.now - this.from > KEPT_S * 1.5) this.forgetBefore(this.now - KEPT_S);
  }
  /* The defaults of parameters. They come from nodes that declared a parameter without an override, and from the machine. */
  known(rows) {
    for (const [node, name, value] of rows) this.defaults.set(node + ' ' + name, value);
    this.version++;
  }
  /* Store the new and changed steps of a launch by number, in the order in which launch visited them, and by the enclosing step. */
  launched({ pid, at, rows }) {
    if (!this.launches.has(pid)) this.launches.set(pid, { pid, at: null, name: 'launch', steps: [], order: [], below: new Map(), events: new Map(), version: 0 });
    const launch = this.launches.get(pid), seconds = value => value / 1e6;
    launch.at = at ?? null;
    launch.version++;
    for (const row of rows) {
      const before = launch.steps[row.number], step = before || { depth: 0 };
      Object.assign(step, row, { t: row.time === null ? Infinity : seconds(row.time) });
      if (row.due !== undefined) step.due = seconds(row.due);
      if (row.fired_at) step.fired_at = row.fired_at.map(seconds);
      if (row.runs) step.runs = row.runs.map(([pid, from, to, code]) => [pid, seconds(from), to === null ? null : seconds(to), code]);
      if (before) continue;
      launch.steps[row.number] = step;
      step.depth = row.parent < 0 ? 0 : (launch.steps[row.parent]?.depth ?? 0) + 1;
      if (!launch.below.has(row.parent)) launch.below.set(row.parent, []);
      launch.below.get(row.parent).push(step);
      if (row.kind === 'include' && row.parent < 0) launch.name = row.text.split('/').pop();
    }
    launch.order = launch.steps.filter(step => step?.order > 0).sort((a, b) => a.order - b.order);
    launch.events = new Map();
    for (const event of launch.order) for (const number of event.kind === 'event' ? new Set([event.about, ...(event.fired || [])]) : []) launch.events.set(number, [...(launch.events.get(number) || []), event]);
  }
  /* The time of the oldest stored message. */
  first() { return Math.min(this.now, ...[...this.topics.values()].filter(topic => topic.t.n).map(topic => topic.t.a[0])); }
  /* A live view that is open for hours keeps the messages of the last ten minutes, and all of graph, processes and parameters. */
  forgetBefore(time) {
    this.from = time;
    for (const topic of this.topics.values()) topic.forgetBefore(time);
    for (const track of this.tracks.values()) track.forgetBefore(time);
    for (const [topic, scans] of this.scans) this.scans.set(topic, scans.filter(scan => scan.time >= time));
    for (const name of ['logs', 'output']) this[name] = this[name].filter(row => row.t >= time);
    this.version++;
  }
  nodeName(index) { return this.nodes.find(node => node?.index === index)?.name ?? '?'; }
  byName(name) { return [...this.topics.values()].filter(topic => topic.name === name); }
  /* The value of a parameter at a time, with its origin. */
  parameter(node, name, time) {
    let found;
    for (const row of this.parameters) if (row.t <= time + 1e-7 && row.node === node && row.name === name) found = row;
    return found;
  }
  parametersAt(time) {
    const found = new Map();
    for (const row of this.parameters) {
      if (row.t > time + 1e-7) break;
      const key = row.node + ' ' + row.name;
      if (row.value === null) found.delete(key); else found.set(key, row);
    }
    return [...found.values()];
  }
  alive(node, time) { return node.from <= time + 1e-7 && time < node.to; }
}
