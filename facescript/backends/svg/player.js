// Keeps the picture to the sound's clock; a click or a key starts it where the browser will not start sound by itself
// or the viewer wants no motion.
(function () {
  var svg = document.currentScript ? document.currentScript.closest("svg") : document.documentElement;
  var audio = svg.querySelector("audio");
  var button = svg.querySelector(".play");
  var length = parseFloat(svg.getAttribute("data-duration"));

  function follow() {
    svg.setCurrentTime(audio.ended ? length : audio.currentTime);
    if (!audio.paused && !audio.ended) requestAnimationFrame(follow);
  }
  function playing() {
    button.setAttribute("visibility", "hidden");
    follow();
  }
  function offer() {
    button.setAttribute("visibility", "visible");
  }
  function start() {
    var promise = audio.play();
    if (promise) promise.catch(offer);
  }
  function toggle() {
    svg.classList.add("asked");
    if (audio.paused) start();
    else audio.pause();
  }

  svg.pauseAnimations();
  svg.setCurrentTime(0);
  audio.addEventListener("playing", playing);
  audio.addEventListener("pause", function () { if (!audio.ended) offer(); });
  audio.addEventListener("ended", function () { follow(); offer(); });
  audio.addEventListener("seeked", function () { svg.setCurrentTime(audio.currentTime); });
  svg.addEventListener("click", toggle);
  button.addEventListener("keydown", function (event) {
    if (event.key === "Enter" || event.key === " ") { event.preventDefault(); toggle(); }
  });
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) offer();
  else start();
})();
