/* The link of a notebook's widget: messages to the kernel. Nothing here knows which notebook it is in.
   The kernel shows what is new by itself, for a while after each `next`: a page that nobody sees costs nothing. */

const ASK_EVERY_MS = 500;

function render({ model, el }) {
  const handlers = [], page = Math.random().toString(36).slice(2), send = words => model.send({ ...words, page });
  const take = message => { if (message.page === page) handlers.forEach(handler => handler(message)); };
  model.on('msg:custom', take);
  openDesk(el, { send, on: handler => handlers.push(handler) }, { tab: model.get('tab') });
  const ask = () => { if (!document.hidden) send({ op: 'next' }); };
  const timer = setInterval(ask, ASK_EVERY_MS);
  ask();
  return () => { clearInterval(timer); model.off('msg:custom', take); send({ op: 'bye' }); };
}

export default { render };
