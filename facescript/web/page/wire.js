// The WebSocket to the server, which comes again when it is lost, and its messages to whoever listens.

const QUICKEST = 250, SLOWEST = 4000;  // ms until it is tried again

// The address of a WebSocket that lies beneath the page, whatever way the page was reached by.
export const reached = (name) => new URL(name, location.href).href.replace(/^http/, "ws");

// A wire: `on(kind, act)` calls `act` with each message of a kind, `say(kind, values)` sends one, which listeners on
// "said KIND" hear too; `tell(kind, message)` tells listeners as if the server had said it, `drop()` lets go of the
// socket; `state` is told of "connected" and "lost". A message with numbers has them as `numbers`, a Float32Array.
export function wire(address) {
  const listeners = new Map();
  let socket, pause = QUICKEST;

  const emit = (kind, message) => (listeners.get(kind) || []).forEach((act) => act(message));

  function open() {
    socket = new WebSocket(address);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => { pause = QUICKEST; emit("state", { state: "connected" }); };
    socket.onmessage = ({ data }) => {
      const message = typeof data === "string" ? JSON.parse(data) : withNumbers(data);
      emit(message.kind, message);
    };
    socket.onclose = lost;
  }

  function lost() {
    emit("state", { state: "lost" });
    setTimeout(open, pause);
    pause = Math.min(2 * pause, SLOWEST);
  }

  return {
    open,
    drop() {
      socket.onclose = socket.onmessage = null;  // a server that is gone does not answer that it closes
      socket.close();
      lost();
    },
    on(kind, act) { listeners.set(kind, [...listeners.get(kind) || [], act]); },
    tell: emit,
    say(kind, values = {}) {
      emit(`said ${kind}`, values);
      if (socket && socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify({ kind, ...values }));
    },
  };
}

// messages.py: the length of a head, the head, 32-bit floats.
function withNumbers(data) {
  const length = new DataView(data).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length)));
  return { ...head, numbers: new Float32Array(data, 4 + length) };
}
