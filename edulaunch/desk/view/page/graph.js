/* Nodes and topics in layers. Edges light up when messages pass, and a click on a box shows its details. */

const QUIET_TOPICS = new Set(['/rosout', '/parameter_events']);
const NODE_SERVICES = /\/(describe_parameters|get_parameters|get_parameter_types|list_parameters|set_parameters|set_parameters_atomically|get_type_description)$/;
const LIT_S = 0.25;

/* Nodes of commands such as `ros2 topic echo` are hidden, as ROS 2 hides them. */
const hidden = node => node.name.split('/').pop().startsWith('_') && node.name !== '/_desk';

/* Straight lines and S-curves, alternately. */
function wayOf(points, right) {
  return points.map(([x, y], i) => {
    if (!i) return `M${x} ${y}`;
    const [a, b] = points[i - 1];
    if (i % 2) return a === x && b === y ? '' : `L${x} ${y}`;
    return right ? `C${(a + x) / 2} ${b} ${(a + x) / 2} ${y} ${x} ${y}` : `C${a} ${(b + y) / 2} ${x} ${(b + y) / 2} ${x} ${y}`;
  }).join(' ');
}

class GraphView {
  constructor(desk) {
    this.desk = desk;
    this.box = make('div', { class: 'pane' });
    this.unused = make('input', { type: 'checkbox' });
    this.services = make('input', { type: 'checkbox' });
    const bar = make('div', { class: 'tools' }, make('label', {}, this.unused, ' topics with one end'), make('label', {}, this.services, ' services and actions'));
    this.sheet = drawing('svg', { role: 'group' });
    this.told = make('div', { class: 'told', 'aria-live': 'polite' }, 'Click a node or a topic to see its details.');
    this.frame = make('div', { class: 'scroll graph', tabindex: 0, role: 'region', 'aria-label': 'node graph; press plus or minus to zoom, 0 to fit the width' }, this.sheet);
    bar.append(button('+', 'zoom in', () => this.zoomed(1.25)), button('−', 'zoom out', () => this.zoomed(0.8)), button('Fit', 'fit the graph to the width', () => this.zoomed(0)));
    this.box.append(bar, this.frame, this.told);
    this.hand();
    for (const control of [this.unused, this.services]) control.addEventListener('change', () => { this.key = null; desk.redraw(); });
  }
  /* Compute the boxes and arrows at a time. */
  read(time) {
    const { store } = this.desk, alive = store.nodes.filter(node => node && store.alive(node, time) && !hidden(node));
    const names = new Map(), boxes = new Map(), edges = [];
    for (const node of alive) names.set(node.name, (names.get(node.name) || 0) + 1);
    for (const node of alive) {
      boxes.set('n' + node.index, { id: 'n' + node.index, kind: 'node', name: node.name === '/_desk' ? 'you, driving' : node.name, node, mark: names.get(node.name) > 1 ? 'two nodes have this name' : '' });
    }
    const ends = new Map();
    for (const end of store.endpoints) {
      if (end.t > time + 1e-7 || !boxes.has('n' + end.node)) continue;
      const service = end.kind === 'service' || end.kind === 'client';
      if (service ? !this.services.checked || NODE_SERVICES.test(end.name) || end.name.includes('/_action/') : QUIET_TOPICS.has(end.name)) continue;
      const action = !service && end.name.match(/^(.*)\/_action\/(feedback|status)$/);
      if (action && (!this.services.checked || action[2] === 'status')) continue;
      const name = action ? action[1] : end.name, kind = service ? 'service' : action ? 'action' : 'topic', id = kind[0] + kind[1] + name;
      if (!ends.has(id)) ends.set(id, { id, kind, name, from: new Set(), to: new Set(), rows: [] });
      const box = ends.get(id);
      box.rows.push(end);
      const asks = action ? end.kind === 'subscription' : end.kind === 'publisher' || end.kind === 'client';
      (asks ? box.from : box.to).add('n' + end.node);
    }
    for (const box of ends.values()) {
      if (box.kind === 'topic' && !(box.from.size && box.to.size) && !this.unused.checked && !sayingsOf(store, 'topic', box.name, time).length) continue;
      if (box.kind !== 'topic' && !box.from.size) continue;
      box.mark = box.kind !== 'topic' ? (box.to.size ? '' : 'no server')
        : box.name === '/tf_static' && !(box.from.size && box.to.size) ? ''  /* every tf listener subscribes to it, but without static frames it has no publisher */
          : !box.from.size ? 'no publisher' : !box.to.size ? 'no subscriber' : this.misfit(box, time);
      boxes.set(box.id, box);
      for (const node of box.from) edges.push({ from: node, to: box.id, box });
      for (const node of box.to) edges.push({ from: box.id, to: node, box });
    }
    if (store.planned) this.plan(boxes, edges);
    for (const box of boxes.values()) box.mark ||= sayingsOf(store, box.kind, box.name, time)[0]?.rule || '';
    return { boxes, edges };
  }
  /* For a plan: the unknown parts of a node, and the frames. */
  plan(boxes, edges) {
    const { unknown, frames } = this.desk.store.planned;
    for (const box of boxes.values()) {
      if (box.kind === 'node') box.unknown = unknown[box.name];
      else if (box.mark) [box.unknown, box.mark] = [[`${box.mark} known`], ''];
    }
    const frame = name => { const id = 'f' + name; if (!boxes.has(id)) boxes.set(id, { id, kind: 'frame', name, from: new Set(), to: new Set(), by: [] }); return boxes.get(id); };
    for (const [parent, child, fixed, by] of frames) {
      const box = frame(child);
      Object.assign(box, { parent, fixed, by });
      edges.push({ from: frame(parent).id, to: box.id, box });
    }
  }
  misfit(box, time) {
    const found = this.desk.store.notes.find(row => row.kind === 'incompatible' && row.t <= time && row.text.startsWith(box.name + ':'));
    return found ? found.text.match(/because of (.+)$/)?.[1].toLowerCase() + ' does not fit' : '';
  }
  draw(time) {
    const { store } = this.desk, stops = store.nodes.filter(node => node && store.alive(node, time)).map(node => node.index).join();
    const known = store.endpoints.filter(end => end.t <= time + 1e-7).length;
    const key = [stops, known, store.notes.length, (store.advice || []).filter(row => row.t <= time).length, this.unused.checked, this.services.checked].join(';');
    if (key !== this.key) { this.key = key; this.lay(this.read(time)); }
    if (this.frame.clientWidth && this.frame.clientWidth - 2 !== this.room) this.fit();
    for (const { box, path, back } of this.paths) {
      let lit = 0;
      if (box.kind === 'topic') for (const topic of store.byName(box.name)) {
        const number = topic.at(time), age = number < 0 ? Infinity : time - topic.t.a[number];
        lit = Math.max(lit, 1 - age / LIT_S);
      }
      if (box.kind === 'service') lit = store.calls.some(call => call?.service === box.name && call.t <= time && time - call.t < 2 * LIT_S) ? 1 : 0;
      const strength = (lit > 0 ? 'lit' : 'idle') + back;
      if (path.getAttribute('class') !== strength) path.setAttribute('class', strength);
    }
    if (this.chosen) this.tell(time);
  }
  /* Select the box that a piece of advice is about, and show its details. */
  point(kind, name) {
    const { boxes } = this.read(this.desk.time), box = [...boxes.values()].find(found => found.kind === kind && found.name === name);
    if (!box) return;
    this.chosen = box;
    this.tell(this.desk.time, true);
    this.told.scrollIntoView({ block: 'nearest' });
  }
  /* Arrange boxes in layers. Each box is as large as its text (see layout.js). */
  lay({ boxes, edges }) {
    const all = [...boxes.values()], place = new Map(all.map((box, i) => [box.id, i]));
    if (!all.length) { this.sheet.replaceChildren(); this.paths = []; return; }
    for (const box of all) {  /* the namespace is small, above the name, so that a chain of nodes fits in a column */
      const cut = box.name.lastIndexOf('/');
      [box.space, box.base] = cut > 0 ? [box.name.slice(0, cut), box.name.slice(cut)] : ['', box.name];
      box.w = Math.max(box.base.length * 7.3, box.space.length * 6.1, (box.mark || '').length * 6.7 + 14, ...(box.unknown || []).map(text => text.length * 6.3 + 14)) + 20;
      box.h = 26 + (box.space ? 12 : 0) + (box.mark ? 13 : 0) + 12.5 * (box.unknown || []).length;
    }
    const found = layOut(all.map(box => [box.w, box.h]), edges.map(edge => [place.get(edge.from), place.get(edge.to)]), null, Math.max(420, (this.frame.clientWidth || 700) / 0.8));
    all.forEach((box, i) => Object.assign(box, { x: found.corners[i][0] + box.w / 2, y: found.corners[i][1] + box.h / 2 }));
    this.paint(boxes, edges, found);
  }
  paint(boxes, edges, found) {
    const named = ids => [...ids].map(id => boxes.get(id)?.name).join(', ') || 'nobody', all = [...boxes.values()];
    const ways = all.filter(box => box.kind !== 'node' && box.kind !== 'frame').map(box => `${box.name} from ${named(box.from)} to ${named(box.to)}${box.mark ? ` (${box.mark})` : ''}`);
    this.sheet.setAttribute('aria-label', `node graph: ${all.filter(box => box.kind === 'node').map(box => box.name).join(', ')}; ${ways.join('; ')}${all.filter(box => box.parent).map(box => `; frame ${box.name} in ${box.parent} by ${box.by.join(', ')}`).join('')}`);
    const arrow = drawing('marker', { id: 'arrow', viewBox: '0 0 8 8', refX: 7, refY: 4, markerWidth: 9, markerHeight: 9, markerUnits: 'userSpaceOnUse', orient: 'auto-start-reverse' },
      drawing('path', { d: 'M0 0 L8 4 L0 8 z', class: 'tip' }));
    this.sheet.replaceChildren(drawing('defs', {}, arrow));
    this.paths = edges.map((edge, number) => {
      const path = drawing('path', { d: wayOf(found.routes[number], found.direction === 'right'), 'marker-end': 'url(#arrow)' });
      if (found.back.has(number)) path.append(drawing('title', {}, 'this edge closes a loop'));
      this.sheet.append(path);
      return { box: edge.box, path, back: found.back.has(number) ? ' back' : '' };
    });
    for (const box of boxes.values()) this.sheet.append(this.one(box));
    this.size = [found.width, found.height];
    this.sheet.setAttribute('viewBox', `0 0 ${found.width} ${found.height}`);
    this.fit();
  }
  /* The size fits the available width, unless the user has zoomed. */
  fit() {
    if (!this.size) return;
    const [width, height] = this.size, room = this.frame.clientWidth - 2, wide = room / width;
    const scale = this.zoom || Math.min(1.15, wide, Math.max(0.65, (this.frame.clientHeight - 8) / height));
    this.sheet.style.width = `${Math.floor(width * scale)}px`;
    this.room = room;
  }
  zoomed(by) {
    const now = this.sheet.clientWidth / (this.size?.[0] || 1);
    this.zoom = by ? Math.max(0.2, Math.min(4, now * by)) : 0;
    this.fit();
  }
  /* Dragging moves the picture. The keys + and - zoom, and 0 fits the picture to the width. */
  hand() {
    const { frame } = this;
    let from = null;
    frame.addEventListener('pointerdown', event => { if (event.button === 0) from = [event.clientX + frame.scrollLeft, event.clientY + frame.scrollTop]; });
    frame.addEventListener('pointermove', event => { if (from && event.buttons) { frame.scrollLeft = from[0] - event.clientX; frame.scrollTop = from[1] - event.clientY; } });
    frame.addEventListener('pointerup', () => { from = null; });
    frame.addEventListener('wheel', event => { if (event.ctrlKey) { event.preventDefault(); this.zoomed(event.deltaY < 0 ? 1.15 : 1 / 1.15); } }, { passive: false });
    frame.addEventListener('keydown', event => {
      const by = { '+': 1.25, '=': 1.25, '-': 0.8, 0: 0 }[event.key];
      if (by !== undefined && !event.ctrlKey) this.zoomed(by);
      if (by !== undefined || (event.target === frame && event.key.startsWith('Arrow'))) event.stopPropagation();
    });
  }
  one(box) {
    const group = drawing('g', { class: `${box.kind} ${box.mark ? 'marked' : ''}${box.unknown ? 'unknown' : ''}`, tabindex: 0, role: 'button', 'aria-label': `${box.name}${box.mark ? `, ${box.mark}` : ''}${box.unknown ? `, ${box.unknown.join(', ')}; this is not known` : ''}`, transform: `translate(${box.x} ${box.y})` });
    group.append(drawing('rect', { x: -box.w / 2, y: -box.h / 2, width: box.w, height: box.h, rx: box.kind === 'node' ? box.h / 2 : 3 }));
    const lines = [...(box.space ? [[box.space, 'space']] : []), [box.base, ''], ...(box.mark ? [['⚠ ' + box.mark, 'mark']] : []), ...(box.unknown || []).map(text => ['? ' + text, 'space'])];
    lines.forEach(([said, look], i) => {
      const text = drawing('text', { y: 4 + (i - (lines.length - 1) / 2) * 12.5, 'text-anchor': 'middle', class: look });
      text.textContent = said;
      group.append(text);
    });
    const choose = () => { this.chosen = box; this.tell(this.desk.time, true); };
    group.addEventListener('click', choose);
    group.addEventListener('keydown', event => { if (event.key === 'Enter' || event.key === ' ') { event.preventDefault(); event.stopPropagation(); choose(); } });
    return group;
  }
  tell(time, now = false) {
    if (!now && !this.desk.isTimeToTell(this)) return;
    const { store } = this.desk, box = this.chosen, rows = [];
    if (store.planned) { this.told.replaceChildren(...this.planned(box)); return; }
    if (box.kind === 'node') {
      const process = store.processes.find(row => row?.name === box.node.process);
      rows.push(make('b', {}, box.name), ` runs in ${box.node.process}${process ? `, pid ${process.pid}` : ''}`);
      const given = store.parametersAt(time).filter(row => row.node === box.name);
      rows.push(make('p', { class: 'mono' }, given.map(row => `${row.name}: ${written(row)}`).join('   ')));
    }
    for (const topic of box.kind === 'topic' ? store.byName(box.name) : []) {
      const number = topic.at(time);
      rows.push(make('b', {}, box.name), ` ${topic.type}, ${number + 1} messages, ${topic.rate(time).toFixed(1)} Hz`);
      const qos = new Set(box.rows.map(end => `${end.kind} ${store.nodeName(end.node)}: ${end.qos[1]}, ${end.qos[2]}, depth ${end.qos[0]}`));
      rows.push(make('p', {}, [...qos].join(' · ')));
      if (number >= 0) rows.push(this.message(topic, number));
    }
    if (box.kind === 'service' || box.kind === 'action') {
      const calls = store.calls.filter(call => call?.service.startsWith(box.name) && call.t <= time);
      rows.push(make('b', {}, box.name), ` ${box.rows[0].type}, ${calls.length} calls so far`);
      const last = calls[calls.length - 1];
      if (last) rows.push(make('p', { class: 'mono' }, `${last.t.toFixed(3)} s  ${last.client}: ${JSON.stringify(last.request)}  ${last.replied <= time ? 'answered' : 'no answer yet'}`));
    }
    const said = sayingsOf(store, box.kind, box.name, time);
    rows.push(...(said.length || !box.mark ? sentences(said) : [make('p', { class: 'bad' }, `⚠ ${box.mark}`)]));
    this.told.replaceChildren(...rows);
  }
  /* The details of a box in a plan. */
  planned(box) {
    const { store } = this.desk, known = { run: 'known from an earlier run', source: 'read in the source', 'built-in': 'known from edulaunch' };
    if (box.kind === 'frame') return [make('b', {}, box.name), box.parent ? ` is a ${box.fixed ? 'static ' : ''}frame in ${box.parent}, published by ${box.by.join(', ')}` : ' is a root frame'];
    if (box.kind !== 'node') return [make('b', {}, box.name), ` ${box.rows[0].type}: ${box.rows.map(end => `${end.kind} ${store.nodeName(end.node)}`).join(', ')}`];
    const given = store.parametersAt(0).filter(row => row.node === box.name), source = store.planned.source[box.name];
    return [make('b', {}, box.name), ` is ${box.node.process}; endpoints: ${known[source] || 'not known'}`, make('p', { class: 'mono' }, given.map(row => `${row.name}: ${written(row)}`).join('   ')),
      ...(box.unknown || []).map(text => make('p', {}, `not known: ${text}`))];
  }
  /* The fields of a message; a number can be dragged to the plot. */
  message(topic, number) {
    const list = make('div', { class: 'message mono' });
    topic.fields.forEach(([path, how], i) => {
      const column = topic.columns[i], value = how === 'text' ? column[number] : column.a[number];
      const entry = make('button', { type: 'button', class: 'field', draggable: how !== 'text', title: how === 'text' ? '' : 'click or drag to plot' },
        `${path}: ${how === 'float' ? value.toFixed(4) : value}`);
      if (how !== 'text') {
        entry.addEventListener('click', () => this.desk.plot(topic, path));
        entry.addEventListener('dragstart', event => event.dataTransfer.setData('text/plain', `${topic.name} ${path}`));
      }
      list.append(entry);
    });
    return list;
  }
}
