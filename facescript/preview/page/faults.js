// What is wrong with the script, over the picture: errors keep the last good picture, and say why.

const SHOWN = 6;

export function faults(link, place, jump) {
  link.on("diagnostics", ({ items }) => {
    const told = items.filter((item) => item.severity !== "hint");
    place.replaceChildren(...told.slice(0, SHOWN).map(card));
    if (told.length > SHOWN) place.append(Object.assign(document.createElement("p"), {
      className: "fault", textContent: `and ${told.length - SHOWN} more`,
    }));
  });

  function card(item) {
    const card_ = document.createElement("div"), where = document.createElement("span");
    card_.className = "fault", card_.dataset.severity = item.severity;
    where.className = "place";
    where.textContent = `${item.code}${item.line ? ` ${item.file}:${item.line}` : ""}`;
    card_.append(where, item.message, item.help ? ` ${item.help}` : "");
    if (item.start !== undefined) card_.addEventListener("click", () => jump(item.start, item.end));
    return card_;
  }
}
