/* The advice on a run: a list in the header, and a sentence for each mark on a node, a topic or a frame. */

/* The advice to show: the findings of the rules if the user asked for them, otherwise the notes of the engine. */
function sayings(store) {
  if (store.advice) return store.advice;
  const rows = store.notes.filter(row => row.kind === 'incompatible');
  const seen = new Set(), text = row => `${row.process ? row.process + ': ' : ''}${row.text}`;
  return rows.filter(row => !seen.has(text(row)) && seen.add(text(row))).map(row => ({ t: row.t, subject: {}, text: text(row), rule: row.kind }));
}

/* The advice on one subject that is true at a time. */
const sayingsOf = (store, kind, name, time) => (store.advice || []).filter(row => row.t <= time + 1e-7 && row.subject[kind] === name);

const sentences = rows => rows.map(row => make('p', { class: 'bad' }, `⚠ ${row.text}`, make('span', { class: 'soft' }, ` (${row.rule})`)));

class AlertsView {
  constructor(desk) {
    this.desk = desk;
    this.sum = make('summary', {});
    this.list = make('ul', {});
    this.box = make('details', { class: 'alerts', hidden: true }, this.sum, this.list);
    this.ask = button('Look for mistakes', 'check the run so far for common mistakes', () => desk.send({ op: 'advise' }));
    this.ask.hidden = !desk.live;
  }
  update() {
    const rows = sayings(this.desk.store), key = rows.map(row => row.rule + row.text).join('\n');
    if (key === this.key) return;
    this.key = key;
    this.box.hidden = !rows.length;
    this.sum.textContent = `⚠ ${rows.length}`;
    this.sum.setAttribute('aria-label', `${rows.length} problems`);
    this.list.replaceChildren(...rows.map(row => make('li', {}, this.item(row))));
  }
  item(row) {
    const [kind] = Object.keys(row.subject), about = kind ? `${kind} ${row.subject[kind]}` : '';
    const text = [about ? make('b', {}, about + ': ') : '', row.text, make('span', { class: 'soft' }, ` ${row.t.toFixed(2)} s, ${row.rule}`)];
    if (!kind) return make('span', {}, ...text);
    const item = make('button', { type: 'button', class: 'field' }, ...text);
    item.addEventListener('click', () => { this.box.open = false; this.desk.point(kind, row.subject[kind], row.t); });
    return item;
  }
}
