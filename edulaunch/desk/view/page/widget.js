/* The connection of a notebook's widget: messages to the kernel. The code works in any notebook front end.
   The kernel shows what is new by itself, for a while after each `next`: a page that nobody sees costs nothing. */

const ASK_EVERY_MS = 500, MOST_UNANSWERED = 8;

function render({ model, el }) {
  const handlers = [], page = Math.random().toString(36).slice(2);
  let asked = 0, isLive = true;
  const send = words => { if (isLive) model.send({ ...words, page }); };
  const hear = message => handlers.forEach(handler => handler(message));
  const take = message => { if (message.page === page) { asked = 0; hear(message); } };
  model.on('msg:custom', take);
  openDesk(el, { send, on: handler => handlers.push(handler) }, { tab: model.get('tab') });
  /* JupyterLab tells the widget that its kernel was restarted. Each message to the new kernel would cause an error in the console. */
  function change() {
    isLive = this?.model?.comm_live !== false;
    if (!isLive) hear({ ended: 'The kernel was restarted: run this cell again.', machine: { running: false } });
  }
  model.on('comm_live_update', change);
  /* Other front ends do not do this, so the page stops asking a kernel that does not answer. */
  const ask = () => {
    if (document.hidden || !isLive || asked > MOST_UNANSWERED) return;
    if (asked++ === MOST_UNANSWERED) hear({ ended: 'The kernel does not answer: wait for the running cell, or run this cell again if the kernel was restarted.', machine: { running: false } });
    else send({ op: 'next' });
  };
  const timer = setInterval(ask, ASK_EVERY_MS);
  ask();
  return () => { clearInterval(timer); model.off('msg:custom', take); model.off('comm_live_update', change); send({ op: 'bye' }); };
}

export default { render };
