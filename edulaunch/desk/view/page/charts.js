/* The timeline of processes, logs and topics. */

class TimelineView {
  constructor(desk) {
    this.desk = desk;
    this.box = make('div', { class: 'pane scroll' });
    this.canvas = make('canvas', { role: 'img', 'aria-label': 'timeline' });
    this.box.append(this.canvas);
    this.canvas.addEventListener('pointerdown', event => this.seek(event));
    this.canvas.addEventListener('pointermove', event => { if (event.buttons) this.seek(event); });
  }
  seek(event) {
    const x = event.clientX - this.canvas.getBoundingClientRect().left;
    this.desk.seek((x - this.left) / (this.width - this.left - 8) * this.to);
  }
  draw(time) {
    const { store, colours } = this.desk, topics = [...store.topics.values()].filter(topic => topic.t.n && !QUIET_TOPICS.has(topic.name));
    const processes = store.processes.filter(Boolean), rows = processes.length + topics.length + store.tracks.size;
    this.width = this.box.clientWidth - 18;
    this.left = Math.min(230, this.width * 0.36);
    this.to = Math.max(store.now, 0.1);
    const height = rows * 17 + 62, pen = sized(this.canvas, this.width, height), at = t => this.left + t / this.to * (this.width - this.left - 8);
    pen.font = '11px ui-monospace, monospace';
    let y = 4;
    const name = text => { pen.fillStyle = colours.ink; pen.fillText(text.length > 30 ? '…' + text.slice(-29) : text, 4, y + 11, this.left - 8); };
    const head = text => { pen.fillStyle = colours.soft; pen.fillText(text, 4, y + 10); y += 16; };
    head('processes and their log lines');
    for (const process of processes) {
      name(process.name);
      const end = Math.min(process.to, this.to);
      pen.fillStyle = process.to <= this.to && process.code ? '#e8a0a0' : colours.bar;
      pen.fillRect(at(process.from), y + 2, Math.max(2, at(end) - at(process.from)), 11);
      for (const log of store.logs) {
        const node = log.process === process.name;
        if (!node || log.t > this.to) continue;
        pen.fillStyle = log.level >= 40 ? colours.bad : log.level >= 30 ? colours.lit : colours.ink;
        pen.fillRect(at(log.t) - 1, log.level >= 30 ? y : y + 4, log.level >= 40 ? 5 : 2, log.level >= 30 ? 15 : 7);
      }
      if (process.to <= this.to) { pen.fillStyle = colours.ink; pen.fillText(process.code ? `✗ ${process.code}` : '✓', Math.min(at(end) + 2, this.width - 24), y + 11); }
      y += 17;
    }
    head('topics: messages over time');
    for (const topic of topics) {
      name(topic.name);
      this.density(pen, topic.t, at, y);
      y += 17;
    }
    if (store.tracks.size) head('tf: age of the newest transform');
    for (const track of store.tracks.values()) {
      name(`${track.fixed ? '(static) ' : ''}${track.parent} → ${track.child}`);
      const number = track.at(time);
      if (number >= 0) {
        const stamp = track.c[1].a[number] - store.start;
        pen.fillStyle = track.fixed ? colours.bar : '#4c8dd6';
        pen.fillRect(at(track.fixed ? track.c[0].a[0] : Math.min(stamp, time)), y + 4, Math.max(2, Math.abs(at(time) - at(track.fixed ? track.c[0].a[0] : stamp))), 7);
      }
      y += 17;
    }
    pen.strokeStyle = colours.mark;
    pen.lineWidth = 1.5;
    line(pen, [[at(time), 0], [at(time), height]]);
    this.canvas.setAttribute('aria-label', `${processes.length} processes (${processes.map(process => process.name + (process.to <= this.to ? ` ended with ${process.code}` : '')).join(', ')}), ${topics.length} topics, ${store.logs.length} log lines over ${this.to.toFixed(1)} seconds; now at ${time.toFixed(2)}`);
  }
  density(pen, stamps, at, y) {
    const bins = 120, most = Math.max(1, stamps.n / bins * 2.5);
    pen.fillStyle = '#2e8c30';
    for (let i = 0; i < bins; i++) {
      const from = i / bins * this.to, to = (i + 1) / bins * this.to, count = stamps.upTo(to) - stamps.upTo(i ? from : -1);
      if (count) pen.fillRect(at(from), y + 14 - Math.max(2, Math.min(12, 12 * count / most)), at(to) - at(from), Math.max(2, Math.min(12, 12 * count / most)));
    }
  }
}
