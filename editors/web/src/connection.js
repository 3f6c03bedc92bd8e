// An address of a WebSocket to the way on which CodeMirror's client of language servers talks; it comes back when it
// was cut off.
const PATIENCE = [500, 1000, 2000, 4000, 8000];  // milliseconds before each further try

const REFUSED = 4404;  // what the server closes with where it cannot help at all (help.py)

// `connect(transport)` is called for each connection, `lost(again, why)` when one ends: whether another will be tried.
export function keepConnected(address, connect, lost) {
  const handlers = new Set();
  let socket, tries = 0, ended = false, timer;

  function open() {
    socket = new WebSocket(address);
    socket.onopen = () => { tries = 0, connect({ send, subscribe, unsubscribe, close }); };
    socket.onmessage = ({ data }) => { for (const handler of handlers) handler(data); };
    socket.onclose = ({ code, reason }) => {
      if (ended) return;
      const again = code !== REFUSED && tries < PATIENCE.length;
      lost(again, reason);
      if (again) timer = setTimeout(open, PATIENCE[tries++]);
    };
  }

  const send = (message) => {
    if (socket.readyState !== WebSocket.OPEN) throw new Error("the language server is not there");
    socket.send(message);
  };
  const subscribe = (handler) => { handlers.add(handler); };
  const unsubscribe = (handler) => { handlers.delete(handler); };

  const close = () => socket.close();

  open();
  return () => { ended = true, clearTimeout(timer), socket.close(); };
}
