/* The connection of a notebook's widget: messages to the kernel. The code works in any notebook front end.
   The kernel shows what is new by itself, for a while after each `next`: a page that nobody sees costs nothing. */

const ASK_EVERY_MS = 500, MOST_UNANSWERED = 8;

function render({ model, el }) {
  const handlers = [], page = Math.random().toString(36).slice(2), send = words => model.send({ ...words, page });
  let asked = 0;
  const hear = message => handlers.forEach(handler => handler(message));
  const take = message => { if (message.page === page) { asked = 0; hear(message); } };
  model.on('msg:custom', take);
  openDesk(el, { send, on: handler => handlers.push(handler) }, { tab: model.get('tab') });
  /* A restarted kernel never answers, and each request causes an error in the console, so the page stops asking. */
  const ask = () => {
    if (document.hidden || asked > MOST_UNANSWERED) return;
    if (asked++ === MOST_UNANSWERED) hear({ ended: 'The kernel does not answer: wait for the running cell, or run this cell again if the kernel was restarted.', machine: { running: false } });
    else send({ op: 'next' });
  };
  const timer = setInterval(ask, ASK_EVERY_MS);
  ask();
  return () => { clearInterval(timer); model.off('msg:custom', take); send({ op: 'bye' }); };
}

export default { render };
