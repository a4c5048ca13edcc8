/* The connection of the page of `edulaunch view`: a web socket to the server of the page. The page asks for each delta. */

const SHOWN_EVERY_MS = 33;

function socketLink() {
  const handlers = [], waiting = [], socket = new WebSocket(location.href.replace(/^http/, 'ws').replace(/[?#].*$/, '') + 'socket');
  const hear = message => handlers.forEach(handler => handler(message));
  const send = words => { if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(words)); else waiting.push(words); };
  socket.addEventListener('open', () => { waiting.splice(0).forEach(send); send({ op: 'next' }); });
  socket.addEventListener('message', event => {
    const message = JSON.parse(event.data);
    hear(message);
    if (message.delta) setTimeout(() => requestAnimationFrame(() => send({ op: 'next' })), SHOWN_EVERY_MS - 8);
  });
  socket.addEventListener('close', () => hear({ ended: 'The machine or the server of this page has ended. The page still shows everything up to then.', machine: { running: false } }));
  return { send, on: handler => handlers.push(handler) };
}
