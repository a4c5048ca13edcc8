/* The link of a notebook's widget: messages to the kernel. Nothing here knows which notebook it is in. */

const SHOWN_EVERY_MS = 33;

function render({ model, el }) {
  const handlers = [], hear = message => handlers.forEach(handler => handler(message));
  let timer;
  const next = () => { clearTimeout(timer); timer = setTimeout(() => requestAnimationFrame(() => model.send({ op: 'next', page })), SHOWN_EVERY_MS - 8); };
  const page = Math.random().toString(36).slice(2);
  const take = message => {
    if (message.page && message.page !== page) return;
    hear(message);
    if (message.piece) next();
  };
  model.on('msg:custom', take);
  if (model.get('film')) {
    unpacked(model.get('film')).then(film => openDesk(el, null, { tab: model.get('tab') }).load(film));
    return () => model.off('msg:custom', take);
  }
  openDesk(el, { send: words => model.send({ ...words, page }), on: handler => handlers.push(handler) }, { tab: model.get('tab') });
  model.send({ op: 'hello', page });
  return () => { clearTimeout(timer); model.off('msg:custom', take); model.send({ op: 'bye', page }); };
}

export default { render };
