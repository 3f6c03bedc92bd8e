// What the script waits for to buttons and keys of the page, and these to events.

const SEEN = 700;  // ms that a button shows that it was taken

// Buttons in `place`, and keys, as `link` tells of them.
export function touch(link, place) {
  let keys = new Map(), connected = false, offered = "";
  const told = [];  // what was told last, and when

  function say(kind, text) {
    if (!connected) return false;
    link.say(kind, { text });
    told.push({ kind, text, at: performance.now() });
    if (told.length > 50) told.shift();
    return true;
  }

  link.on("state", ({ state }) => {
    connected = state === "connected";
    for (const button of place.children) button.setAttribute("aria-disabled", String(!connected));
  });
  link.on("figure", ({ touched, keys: waited, language }) => {
    keys = new Map(waited.map((key) => [nameOf(key), key]));
    if (offered === JSON.stringify(touched)) return;
    offered = JSON.stringify(touched);
    place.lang = language;
    place.replaceChildren(...touched.map(buttonOf));
  });

  function buttonOf(text) {
    const button = document.createElement("button");
    Object.assign(button, { type: "button", textContent: text });
    button.addEventListener("click", () => {
      if (!say("touched", text)) return;
      button.classList.add("taken");
      setTimeout(() => button.classList.remove("taken"), SEEN);
    });
    return button;
  }

  // Keys are told apart as the script's texts are: capitals or not.
  const nameOf = (key) => key.toLowerCase();

  document.addEventListener("keydown", (event) => {
    const key = keys.get(nameOf(event.key === " " ? "space" : event.key)) ?? keys.get(nameOf(event.key));
    if (key === undefined || event.repeat || event.ctrlKey || event.altKey || event.metaKey) return;
    if (/^(Enter| |Tab)$/.test(event.key) && event.target.closest("button")) return;
    if (say("key", key)) event.preventDefault();
  });

  return { get told() { return told; } };
}
