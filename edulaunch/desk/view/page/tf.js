/* tf as a listener sees it that has received all transforms: the tree at a time, poses in a fixed frame, and lookups with ROS 2's error messages. */

const CACHE_S = 10;

const turned = ([x, y, z, w], [a, b, c]) => {
  const tx = 2 * (y * c - z * b), ty = 2 * (z * a - x * c), tz = 2 * (x * b - y * a);
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
};
const times = ([x, y, z, w], [a, b, c, d]) =>
  [w * a + x * d + y * c - z * b, w * b - x * c + y * d + z * a, w * c + x * b - y * a + z * d, w * d - x * a - y * b - z * c];
const product = (one, two) => {
  const [x, y, z] = turned(one.q, two.p);
  return { p: [one.p[0] + x, one.p[1] + y, one.p[2] + z], q: times(one.q, two.q) };
};
const inverse = ({ p, q }) => {
  const back = [-q[0], -q[1], -q[2], q[3]];
  return { p: turned(back, p).map(value => -value), q: back };
};
const IDENTITY = { p: [0, 0, 0], q: [0, 0, 0, 1] };
const yawOf = ([x, y, z, w]) => Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));

function between(one, two, part) {
  const dot = one.q.reduce((sum, value, i) => sum + value * two.q[i], 0), sign = dot < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(dot))), sine = Math.sin(angle);
  const [a, b] = sine < 1e-6 ? [1 - part, part] : [Math.sin((1 - part) * angle) / sine, Math.sin(part * angle) / sine];
  return { p: one.p.map((value, i) => value + part * (two.p[i] - value)), q: one.q.map((value, i) => a * value + sign * b * two.q[i]) };
}

class Tree {
  /* The newest transform of each child at a time: Map of child to {parent, fixed, stamp, published, transform, track}. */
  constructor(store, time) {
    this.store = store;
    this.time = time;
    this.links = new Map();
    this.placed = new Map();
    for (const track of store.tracks.values()) {
      const number = track.at(time);
      if (number < 0) continue;
      const published = track.c[0].a[number], stamp = track.c[1].a[number];
      const known = this.links.get(track.child);
      if (known && known.published > published) continue;
      this.links.set(track.child, {
        child: track.child, parent: track.parent, fixed: track.fixed, stamp, published, track, transform: track.transform(number),
        parents: known && known.parent !== track.parent && !known.fixed ? known.parents + 1 : 1,
      });
    }
  }
  names() { return this.all ??= [...new Set([...this.links.values()].flatMap(link => [link.parent, link.child]))]; }
  /* The root of a frame, and the pose of the frame relative to it. Each one is computed once, because there may be hundreds of frames below one another. */
  inRoot(frame) {
    const chain = [];
    while (!this.placed.has(frame) && this.links.has(frame) && chain.length < 1000) { chain.push(frame); frame = this.links.get(frame).parent; }
    let found = this.placed.get(frame) || { root: frame, pose: IDENTITY };
    for (const child of chain.reverse()) this.placed.set(child, found = { root: found.root, pose: product(found.pose, this.links.get(child).transform) });
    return found;
  }
  root(frame) { return this.inRoot(frame).root; }
  /* Return the pose of every frame that is connected to `fixed`, relative to `fixed`. */
  seenFrom(fixed) {
    const { root, pose } = this.inRoot(fixed), back = inverse(pose), found = new Map();
    for (const name of this.names()) if (this.root(name) === root) found.set(name, product(back, this.inRoot(name).pose));
    return found;
  }
}

/* Return the numbers of the first and last transform of a track in the buffer at a time. */
function held(track, time) {
  const last = track.at(time);
  let first = 0;
  if (!track.fixed) while (first < last && track.c[1].a[first] < track.c[1].a[last] - CACHE_S) first++;
  return [first, last];
}

/* Return the result of `lookup_transform(target, source, stamp)` at `time`; stamp is in seconds since the start, or null for the latest. */
function lookup(store, target, source, stamp, time, tree = new Tree(store, time)) {
  const known = new Set(tree.names());
  const absolute = value => (store.start + value).toFixed(6);
  for (const [frame, argument] of [[target, 'target_frame'], [source, 'source_frame']]) {
    if (!known.has(frame)) return { error: 'LookupException', text: `"${frame}" passed to lookupTransform argument ${argument} does not exist. ` };
  }
  const chain = frame => {
    const found = [];
    for (let steps = 0; tree.links.has(frame) && steps < 1000; steps++) {
      found.push(tree.links.get(frame));
      frame = tree.links.get(frame).parent;
    }
    return found;
  };
  if (tree.root(target) !== tree.root(source)) {
    return {
      error: 'ConnectivityException',
      text: `Could not find a connection between '${target}' and '${source}' because they are not part of the same tree.Tf has two or more unconnected trees.`,
    };
  }
  let up = chain(source), down = chain(target);
  while (up.length && down.length && up[up.length - 1].child === down[down.length - 1].child) { up.pop(); down.pop(); }
  const links = [...up, ...down], moving = links.filter(link => !link.fixed);
  const spans = moving.map(link => {
    const [first, last] = held(link.track, time), stamps = link.track.c[1].a;
    return { child: link.child, from: stamps[first] - store.start, to: stamps[last] - store.start, count: last - first + 1 };
  });
  const asked = stamp ?? Math.min(time, ...spans.map(span => span.to));
  const pair = `when looking up transform from frame [${source}] to frame [${target}]`;
  for (const span of spans) {
    if (span.count === 1 && Math.abs(asked - span.to) > 1e-6) {
      return { error: 'ExtrapolationException', spans, asked,
        text: `Lookup would require extrapolation at time ${absolute(asked)}, but only time ${absolute(span.to)} is in the buffer, ${pair}` };
    }
    const ahead = asked > span.to + 1e-6;
    if (ahead || asked < span.from - 1e-6) {
      return { error: 'ExtrapolationException', spans, asked,
        text: `Lookup would require extrapolation into the ${ahead ? 'future' : 'past'}.  Requested time ${absolute(asked)} but the ${
          ahead ? 'latest' : 'earliest'} data is at time ${absolute(ahead ? span.to : span.from)}, ${pair}` };
    }
  }
  const step = link => {
    if (link.fixed) return link.transform;
    const [first, last] = held(link.track, time), stamps = link.track.c[1].a;
    let after = first;
    while (after < last && stamps[after] < store.start + asked - 1e-9) after++;
    const before = Math.max(first, after - 1), span = stamps[after] - stamps[before];
    const part = span > 0 ? Math.min(1, Math.max(0, (store.start + asked - stamps[before]) / span)) : 1;
    return between(link.track.transform(before), link.track.transform(after), part);
  };
  const walk = some => some.reduce((found, link) => product(step(link), found), IDENTITY);
  return { transform: product(inverse(walk(down)), walk(up)), spans, asked };
}
