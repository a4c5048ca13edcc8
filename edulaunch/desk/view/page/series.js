/* Numbers over time: fields of messages, parts of transforms, and expressions of both. */

const GAP_S = 0.3, OLD_S = 1, MOST_SAMPLES = 2000, AT_ONCE = 300;
const FUNCTIONS = {
  abs: Math.abs, sqrt: Math.sqrt, sin: Math.sin, cos: Math.cos, tan: Math.tan, atan2: Math.atan2, hypot: Math.hypot, min: Math.min, max: Math.max,
  deg: value => value * 180 / Math.PI, rad: value => value * Math.PI / 180,
};
const PARTS = {
  x: ({ p }) => p[0], y: ({ p }) => p[1], z: ({ p }) => p[2], yaw: ({ q }) => yawOf(q), distance: ({ p }) => Math.hypot(...p),
};
const TOKEN = /\s*(?:(tf)\s*\(\s*([^\s,()]+)\s*,\s*([^\s,()]+)\s*\)\s*\.\s*(\w+)|(\d+\.?\d*(?:e[+-]?\d+)?|\.\d+)|([A-Za-z]\w*)|(.))/y;
const FIELD = /\s*(\/\w+(?:\/\w+)*)\.([A-Za-z_][\w.]*(?:\[\d+\])?[\w.]*)/y;

/* An expression as { inputs, value }: `value` gives a number from the values of the inputs. Only numbers, names and the signs below
   are read; nothing that somebody types becomes code. Throws an Error that says what is wrong. */
class Expression {
  constructor(text) {
    Object.assign(this, { text, at: 0, inputs: [] });
    this.next();
    this.value = this.sum();
    if (this.kind !== 'end') throw new Error(`"${this.word}" is not expected here`);
    if (!this.inputs.length) throw new Error('name a field, such as /turtle1/pose.x, or a transform, such as tf(world, turtle1).x');
  }
  /* The next token. Where a value is expected, a slash begins the name of a topic; elsewhere it divides. */
  next(wantsValue = true) {
    if (!this.text.slice(this.at).trim()) { [this.kind, this.word] = ['end', 'the end']; return; }
    FIELD.lastIndex = TOKEN.lastIndex = this.at;
    const field = wantsValue && FIELD.exec(this.text);
    if (field) { this.at = FIELD.lastIndex; [this.kind, this.word, this.input] = ['input', field[0].trim(), { topic: field[1], path: field[2] }]; return; }
    const [whole, tf, target, source, part, number, name, sign] = TOKEN.exec(this.text);
    this.at = TOKEN.lastIndex;
    this.word = whole.trim();
    this.kind = tf ? 'input' : number ? 'number' : name ? 'name' : 'sign';
    if (tf) {
      if (!PARTS[part]) throw new Error(`a transform has ${Object.keys(PARTS).join(', ')}, not ${part}`);
      this.input = { target, source, part };
    }
    if (sign === '/' && wantsValue) throw new Error('a topic is written with its field, such as /turtle1/pose.x');
  }
  takes(sign) {
    if (this.kind !== 'sign' || this.word !== sign) return false;
    this.next();
    return true;
  }
  ends(sign) {
    if (this.kind !== 'sign' || this.word !== sign) throw new Error(`"${sign}" is missing before ${this.word}`);
    this.next(false);
  }
  sum() {
    let left = this.product();
    for (;;) {
      const one = left;
      if (this.takes('+')) { const two = this.product(); left = at => one(at) + two(at); }
      else if (this.takes('-')) { const two = this.product(); left = at => one(at) - two(at); }
      else return left;
    }
  }
  product() {
    let left = this.power();
    for (;;) {
      const one = left;
      if (this.takes('*')) { const two = this.power(); left = at => one(at) * two(at); }
      else if (this.takes('/')) { const two = this.power(); left = at => one(at) / two(at); }
      else return left;
    }
  }
  power() {
    if (this.takes('-')) { const one = this.power(); return at => -one(at); }
    const one = this.atom();
    if (!this.takes('^')) return one;
    const two = this.power();
    return at => one(at) ** two(at);
  }
  atom() {
    const { kind, word, input } = this;
    if (kind === 'number') { this.next(false); return () => Number(word); }
    if (kind === 'input') { const place = this.inputs.push(input) - 1; this.next(false); return at => at[place]; }
    if (kind === 'name' && word === 'pi') { this.next(false); return () => Math.PI; }
    if (kind === 'name') {
      if (!Object.hasOwn(FUNCTIONS, word)) throw new Error(`there is no function ${word}; choose one of ${Object.keys(FUNCTIONS).join(', ')}`);
      this.next(false);
      if (!this.takes('(')) throw new Error(`${word} takes its values in parentheses`);
      const values = [this.sum()];
      while (this.takes(',')) values.push(this.sum());
      this.ends(')');
      return at => FUNCTIONS[word](...values.map(value => value(at)));
    }
    if (this.takes('(')) { const inner = this.sum(); this.ends(')'); return inner; }
    throw new Error(`a value is expected before ${word}`);
  }
}

/* The values of an expression in one run: columns `t` and `v` that grow with the run. NaN is a gap. */
class Series {
  constructor(store, expression) {
    Object.assign(this, { store, expression, t: new Grow(), v: new Grow(), done: -1, gaps: 0, longest: 0 });
    const [only] = expression.inputs;
    if (expression.inputs.length === 1 && only.topic && expression.text.trim() === `${only.topic}.${only.path}`) this.plain = only;
    this.moves = expression.inputs.some(input => input.target);
  }
  /* Add the values since the last call. Return whether there are more: a long run is processed in parts, so that the page stays fast. */
  update() {
    const { store } = this;
    if (this.plain) {
      const topic = this.topic(this.plain);
      if (topic) [this.t, this.v] = [topic.t, topic.column(this.plain.path)];
      return false;
    }
    if (this.t.n && this.t.a[0] < store.from) { const count = this.t.upTo(store.from); this.t.drop(count); this.v.drop(count); }
    const times = this.times(), some = times.slice(0, AT_ONCE);
    for (const time of some) this.add(time);
    if (!some.length && this.moves && this.isLate(store.now)) this.put(this.done + 1e-6, NaN);
    return times.length > some.length;
  }
  topic({ topic, path }) { return this.store.byName(topic).find(found => found.column(path) instanceof Grow); }
  /* The times after the last sample at which an input changed. They are not closer together than a plot can show. */
  times() {
    const { store } = this, columns = [], frames = new Set();
    for (const input of this.expression.inputs) {
      if (input.topic) { const topic = this.topic(input); if (topic) columns.push(topic.t); }
      else for (const name of [input.target, input.source]) frames.add(name);
    }
    const tracks = [...store.tracks.values()], known = new Set();
    for (let size = -1; size !== frames.size;) {
      size = frames.size;
      for (const track of tracks) if (frames.has(track.child)) { frames.add(track.parent); known.add(track); }
    }
    for (const track of known) columns.push(track.c[0]);
    if (this.moves && known.size && [...known].every(track => track.fixed)) columns.push({ a: [store.now], n: 1, upTo: value => Number(store.now <= value) });
    const all = columns.flatMap(column => [...column.a.slice(column.upTo(this.done), column.n)]).sort((a, b) => a - b);
    const least = Math.max((store.now - store.from) / MOST_SAMPLES, 1e-6), found = [];
    let last = this.done;
    for (const time of all) if (time - last >= least || (last < 0 && time >= 0)) { found.push(time); last = time; }
    return found;
  }
  add(time) {
    const { store } = this, at = this.expression.inputs.map(input => {
      if (input.topic) {
        const topic = this.topic(input), number = topic ? topic.at(time) : -1;
        return number < 0 ? NaN : topic.column(input.path).a[number];
      }
      const found = lookup(store, input.target, input.source, null, time);
      return found.error || time - found.asked > OLD_S ? NaN : PARTS[input.part](found.transform);
    });
    const value = this.expression.value(at), since = time - this.done;
    if (this.moves && this.isLate(time)) this.put(this.done + 1e-6, NaN);
    if (this.done >= 0) this.usual = this.usual ? Math.min(this.usual * 1.05, 0.9 * this.usual + 0.1 * since) : since;
    this.put(time, value);
    this.done = time;
  }
  /* Whether no sample has arrived for much longer than usual. */
  isLate(time) {
    const last = this.v.n ? this.v.a[this.v.n - 1] : NaN;
    return last === last && time - this.done > Math.max(GAP_S, 4 * (this.usual || Infinity));
  }
  /* Add a sample. NaN values after a number form a gap until the next number. */
  put(time, value) {
    const isGap = value !== value;
    if (isGap && this.t.n && this.open === undefined && this.seen) this.open = time;
    if (!isGap && this.open !== undefined) {
      this.gaps++;
      this.longest = Math.max(this.longest, time - this.open);
      this.open = undefined;
    }
    this.seen ||= !isGap;
    this.t.push(time);
    this.v.push(value);
  }
  at(time) { const number = this.t.upTo(time + 1e-7) - 1; return number < 0 ? NaN : this.v.a[number]; }
  about() { return this.gaps ? ` ${this.gaps} ${this.gaps > 1 ? 'gaps, the longest' : 'gap of'} ${this.longest.toFixed(2)} s` : ''; }
}
