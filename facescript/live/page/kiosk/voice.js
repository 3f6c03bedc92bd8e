// The lines of the run to sound at its time: each is scheduled so that it is heard when the picture of it is seen.

const FADE = 0.02;  // seconds in which a line that is cut dies away, up to the cut
const RISE = 0.004;  // seconds in which one that begins in its midst rises
const KEPT = 64;  // lines that are held
const LATEST = 0.035;  // seconds that a mouth may be ahead of its sound: what comes later is begun in its midst

// The sound of what `link` tells, at the times of `time`; `changed` is called when it can be heard or cannot any more.
export function voice(link, time, changed) {
  const context = new AudioContext({ latencyHint: "interactive" });
  let lines = new Map(), run = "";

  link.on("figure", (message) => {
    if (message.run !== run) lines.forEach(hush), lines = new Map();
    run = message.run;
  });
  link.on("line", (message) => {
    const held = lines.get(message.number);
    if (held && held.start === message.start && held.sounds) return cut(held, message.cut);
    if (held) hush(held);
    lines.set(message.number, { ...message, buffer: bufferOf(message) });
    for (const number of [...lines.keys()].slice(0, -KEPT)) hush(lines.get(number)), lines.delete(number);
    follow();
  });
  link.on("cut", ({ number, cut: end }) => { if (lines.has(number)) cut(lines.get(number), end); });
  context.onstatechange = () => { changed(context.state === "running"); follow(); };

  function bufferOf({ numbers, samples, rate }) {
    if (!samples) return null;
    const pcm = new Int16Array(numbers.buffer, numbers.byteOffset, samples), buffer = context.createBuffer(1, samples, rate);
    const out = buffer.getChannelData(0);
    for (let at = 0; at < samples; at++) out[at] = pcm[at] / 32768;
    return buffer;
  }

  // When what is shown at a moment of the page (ms) has to be played to be heard then.
  const played = (moment) => context.currentTime + (moment - performance.now()) / 1000 - (context.outputLatency || 0);

  // Begins all lines that do not sound yet, once there is a time and a sound.
  function follow() {
    time.wait(context.outputLatency || 0);
    if (context.state !== "running" || !time.ready) return;
    const now = performance.now();
    time.hold([...lines.values()].some((line) => line.heard < now && now < line.heard + 1000 * (line.duration - line.into)));
    for (const line of lines.values()) if (line.buffer && !line.sounds) begin(line);
  }

  function begin(line) {
    const at = played(time.when(line.start)), from = Math.max(at, context.currentTime);
    const late = from - at, into = Math.max(0, late - LATEST);
    const source = context.createBufferSource(), gain = context.createGain();
    Object.assign(line, { sounds: { source, gain }, into, heard: performance.now() + 1000 * (from - played(performance.now())) });
    time.late(late);
    if (into >= line.buffer.duration) return;
    source.buffer = line.buffer;
    source.connect(gain).connect(context.destination);
    gain.gain.setValueAtTime(into ? 0 : line.volume, from);
    gain.gain.linearRampToValueAtTime(line.volume, from + RISE);
    source.start(from, into);
    if (line.cut !== null) cut(line, line.cut);
  }

  // A line breaks off at a time of the run: it dies away up to there.
  function cut(line, end) {
    line.cut = end;
    if (!line.sounds || end === null) return;
    const { source, gain } = line.sounds, now = context.currentTime;
    const at = Math.max(played(time.when(end)), now + FADE);
    gain.gain.cancelScheduledValues(at - FADE);
    gain.gain.setValueAtTime(line.volume, at - FADE), gain.gain.linearRampToValueAtTime(0, at);
    source.stop(at + FADE);
  }

  function hush({ sounds }) {
    if (sounds) sounds.source.disconnect(), sounds.gain.disconnect();
  }

  // All lines die away: the run is gone. Those that still sound when it comes back are told of again.
  function still() {
    for (const { sounds } of lines.values()) if (sounds) sounds.gain.gain.setTargetAtTime(0, context.currentTime, 0.1);
    lines = new Map();
  }

  return {
    follow, still,
    begin() { if (context.state !== "running") context.resume(); },
    context,
    get heard() { return context.state === "running"; },
    get lines() { return [...lines.values()]; },
  };
}
