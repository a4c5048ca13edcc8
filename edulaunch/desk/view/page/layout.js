/* Boxes in layers, and paths for the arrows between them that cross no box. `edulaunch/canvas/layout.py` explains the method.
   tests/canvas/layouts.json has cases that both files pass. */

const MARGIN = 12, BETWEEN_LAYERS = 44, BETWEEN_BOXES = 16, JOINT = 10, PORT = 9, SWEEPS = 12, ORDER_SWEEPS = 8;
const range = count => Array.from({ length: count }, (_, i) => i);
const meanOf = numbers => numbers.reduce((a, b) => a + b, 0) / numbers.length;
const put = (map, key, value) => { if (map.has(key)) map.get(key).push(value); else map.set(key, [value]); };

/* Return the numbers of the edges that close a loop. */
function backEdges(count, edges) {
  const following = range(count).map(() => []), entered = new Set(edges.map(([, b]) => b)), state = Array(count).fill(0), back = new Set();
  edges.forEach(([a, b], number) => following[a].push([number, b]));
  for (const root of range(count).sort((a, b) => entered.has(a) - entered.has(b))) {
    const stack = state[root] ? [] : [[root, 0]];
    state[root] ||= 1;
    while (stack.length) {
      const top = stack[stack.length - 1], step = following[top[0]][top[1]++];
      if (!step) { state[top[0]] = 2; stack.pop(); }
      else if (state[step[1]] === 1) back.add(step[0]);
      else if (!state[step[1]]) { state[step[1]] = 1; stack.push([step[1], 0]); }
    }
  }
  return back;
}

/* Return the layer of each item: the length of the longest path to it. */
function ranksOf(count, edges) {
  const rank = Array(count).fill(0), before = range(count).map(() => []), after = range(count).map(() => []);
  for (const [a, b] of edges) { before[b].push(a); after[a].push(b); }
  const waiting = before.map(list => list.length), ready = range(count).filter(item => !waiting[item]);
  for (let i = 0; i < ready.length; i++) for (const step of after[ready[i]]) {
    rank[step] = Math.max(rank[step], rank[ready[i]] + 1);
    if (!--waiting[step]) ready.push(step);
  }
  for (const item of range(count)) if (!before[item].length && after[item].length) rank[item] = Math.min(...after[item].map(step => rank[step])) - 1;
  return rank;
}

function crossingsOf(layers, links) {
  const place = new Map(), layerOf = new Map();
  layers.forEach((layer, number) => layer.forEach((item, i) => { place.set(item, i); layerOf.set(item, number); }));
  let total = 0;
  for (let number = 0; number < layers.length - 1; number++) {
    const ends = links.filter(([a]) => layerOf.get(a) === number).map(([a, b]) => [place.get(a), place.get(b)]).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    ends.forEach(([, b1], i) => { for (const [, b2] of ends.slice(i + 1)) total += b1 > b2; });
  }
  return total;
}

/* Return the layers with the order of items that has the fewest crossing arrows. */
function orderedLayers(layers, chains) {
  const links = chains.flatMap(chain => chain.slice(1).map((b, i) => [chain[i], b])), before = new Map(), after = new Map();
  for (const [a, b] of links) { put(before, b, a); put(after, a, b); }
  const swept = (layers, near) => {
    const found = [layers[0]];
    for (const layer of layers.slice(1)) {
      const place = new Map(found[found.length - 1].map((item, i) => [item, i]));
      const wish = new Map(layer.map((item, i) => { const places = (near.get(item) || []).filter(other => place.has(other)).map(other => place.get(other)); return [item, places.length ? meanOf(places) : i]; }));
      found.push([...layer].sort((a, b) => wish.get(a) - wish.get(b)));
    }
    return found;
  };
  let best = layers, fewest = crossingsOf(layers, links);
  for (let sweep = 0; sweep < ORDER_SWEEPS; sweep++) {
    layers = sweep % 2 ? swept([...layers].reverse(), after).reverse() : swept(layers, before);
    const number = crossingsOf(layers, links);
    if (number < fewest) [best, fewest] = [layers, number];
  }
  return best;
}

/* Return the positions nearest to the desired ones that keep the order and the distances. */
function apart(wishes, layer, breadths, count) {
  const offsets = [0], blocks = [];
  for (let i = 1; i < layer.length; i++) offsets.push(offsets[i - 1] + (breadths[layer[i - 1]] + breadths[layer[i]]) / 2 + (layer[i - 1] < count && layer[i] < count ? BETWEEN_BOXES : BETWEEN_BOXES / 2));
  wishes.forEach((wish, i) => {
    let total = wish - offsets[i], size = 1;
    for (let last; (last = blocks[blocks.length - 1]) && last[0] / last[1] >= total / size;) { total += last[0]; size += last[1]; blocks.pop(); }
    blocks.push([total, size]);
  });
  return blocks.flatMap(([total, size]) => Array(size).fill(total / size)).map((mean, i) => mean + offsets[i]);
}

/* One connected group; sizes and corners are [along, across] the direction of the layers. */
function layGroup(boxSizes, edges) {
  const count = boxSizes.length, back = backEdges(count, edges), forward = edges.map(([a, b], i) => back.has(i) ? [b, a] : [a, b]), rank = ranksOf(count, forward);
  let layers = range(Math.max(0, ...rank) + 1).map(() => []), joint = count;
  for (const item of range(count)) layers[rank[item]].push(item);
  const chains = forward.map(([a, b]) => {
    const chain = [a];
    for (let layer = rank[a] + 1; layer < rank[b]; layer++) { layers[layer].push(joint); chain.push(joint++); }
    return [...chain, b];
  });
  layers = orderedLayers(layers, chains);
  const sizes = [...boxSizes, ...Array(joint - count).fill([0, JOINT])], breadths = sizes.map(size => size[1]), near = sizes.map(() => []), layerOf = [];
  for (const chain of chains) for (let i = 1; i < chain.length; i++) { near[chain[i - 1]].push(chain[i]); near[chain[i]].push(chain[i - 1]); }
  let centres = Array(sizes.length).fill(0);
  const settle = (layer, wishes) => apart(wishes, layer, breadths, count).forEach((centre, i) => { centres[layer[i]] = centre; });
  for (const layer of layers) settle(layer, layer.map(() => 0));
  for (let sweep = 0; sweep < SWEEPS; sweep++) for (const layer of sweep % 2 ? [...layers].reverse() : layers) settle(layer, layer.map(item => near[item].length ? meanOf(near[item].map(other => centres[other])) : centres[item]));
  const top = Math.min(...centres.map((centre, i) => centre - breadths[i] / 2));
  centres = centres.map(centre => centre - top);
  const depths = layers.map(layer => Math.max(0, ...layer.map(item => sizes[item][0]))), starts = [0];
  depths.slice(0, -1).forEach((depth, i) => starts.push(starts[i] + depth + BETWEEN_LAYERS));
  layers.forEach((layer, number) => { for (const item of layer) layerOf[item] = number; });
  const ports = side => {
    const found = Array(chains.length).fill(0), end = chain => side ? chain[chain.length - 1] : chain[0], next = chain => side ? chain[chain.length - 2] : chain[1];
    for (const item of range(count)) {
      const mine = range(chains.length).filter(number => end(chains[number]) === item).sort((a, b) => centres[next(chains[a])] - centres[next(chains[b])]);
      const step = mine.length > 1 ? Math.min(PORT, (sizes[item][1] - 14) / Math.max(1, mine.length - 1)) : 0;
      mine.forEach((number, i) => { found[number] = centres[item] + (i - (mine.length - 1) / 2) * step; });
    }
    return found;
  };
  const out = ports(0), into = ports(1), routes = chains.map((chain, number) => {
    const points = [];
    for (const item of chain) {
      const begin = starts[layerOf[item]], end = begin + depths[layerOf[item]];
      if (item === chain[0]) points.push([(begin + end + sizes[item][0]) / 2, out[number]], [end, out[number]]);
      else if (item === chain[chain.length - 1]) points.push([begin, into[number]], [(begin + end - sizes[item][0]) / 2, into[number]]);
      else points.push([begin, centres[item]], [end, centres[item]]);
    }
    return back.has(number) ? points.reverse() : points;
  });
  const corners = range(count).map(item => [starts[layerOf[item]] + (depths[layerOf[item]] - sizes[item][0]) / 2, centres[item] - sizes[item][1] / 2]);
  return { corners, routes, back, length: starts[starts.length - 1] + depths[depths.length - 1], breadth: Math.max(...centres.map((centre, i) => centre + breadths[i] / 2)) };
}

/* Connected items and the numbers of their edges, largest groups first. */
function groupsOf(count, edges) {
  let group = range(count);
  for (const [a, b] of edges) {
    const [low, high] = [group[a], group[b]].sort((x, y) => x - y);
    group = group.map(name => name === high ? low : name);
  }
  return [...new Set(group)].map(name => [range(count).filter(item => group[item] === name), range(edges.length).filter(number => group[edges[number][0]] === name)]).sort((a, b) => b[0].length - a[0].length);
}

/* Return places for boxes of these [width, height] and arrows between them: the size, the upper left corners, the points of each
   arrow (every second segment, beginning with the first one, is straight), and whether the arrow closes a loop. */
function layOut(sizes, edges, direction = null, widest = 900) {
  const sheet = direction => {
    const right = direction === 'right', turned = (a, c) => right ? [a, c] : [c, a], corners = sizes.map(() => [0, 0]), routes = edges.map(() => []), back = new Set();
    let along = 0, across = MARGIN;
    for (const [items, numbers] of groupsOf(sizes.length, edges)) {
      const own = new Map(items.map((item, i) => [item, i]));
      const group = layGroup(items.map(item => right ? sizes[item] : [sizes[item][1], sizes[item][0]]), numbers.map(number => edges[number].map(item => own.get(item))));
      items.forEach((item, i) => { corners[item] = turned(group.corners[i][0] + MARGIN, group.corners[i][1] + across); });
      numbers.forEach((number, i) => { routes[number] = group.routes[i].map(([a, c]) => turned(a + MARGIN, c + across)); if (group.back.has(i)) back.add(number); });
      [along, across] = [Math.max(along, group.length + 2 * MARGIN), across + group.breadth + BETWEEN_BOXES];
    }
    const [width, height] = turned(along, across - BETWEEN_BOXES + MARGIN);
    return { width, height, corners, routes, back, direction };
  };
  if (direction) return sheet(direction);
  const right = sheet('right'), down = right.width <= widest ? right : sheet('down');
  return down.width < right.width ? down : right;
}
