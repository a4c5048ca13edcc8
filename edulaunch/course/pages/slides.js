'use strict';
// One slide at a time: arrows, space, Home, End; N shows the speaker's text, O all slides. The number stands in the address.
const slides = [...document.querySelectorAll('section')];
let now = 0;

function fit(slide) { // a slide that is too full is set smaller, down to six tenths
  for (let size = 100; size >= 60; size -= 5) {
    slide.style.fontSize = `${size}%`;
    if (slide.scrollHeight <= slide.clientHeight) return;
  }
}

function show(number, focus = true) {
  now = Math.max(0, Math.min(slides.length - 1, number));
  slides.forEach((slide, place) => slide.classList.toggle('now', place === now));
  document.getElementById('where').textContent = `${now + 1} / ${slides.length}`;
  history.replaceState(null, '', `#${now + 1}`);
  if (document.body.classList.contains('one')) fit(slides[now]);
  if (focus) slides[now].focus({ preventScroll: document.body.classList.contains('one') });
}

const keys = {
  ArrowRight: () => show(now + 1), PageDown: () => show(now + 1), ' ': () => show(now + 1),
  ArrowLeft: () => show(now - 1), PageUp: () => show(now - 1),
  Home: () => show(0), End: () => show(slides.length - 1),
  n: () => { document.body.classList.toggle('notes'); show(now); },
  o: () => { document.body.classList.toggle('one'); show(now); },
};
document.addEventListener('keydown', event => {
  const key = event.key.length > 1 ? event.key : event.key.toLowerCase();
  const isOnControl = event.target.closest('summary, button, a') && key === ' ';
  if (event.ctrlKey || event.metaKey || event.altKey || isOnControl || !keys[key]) return;
  event.preventDefault();
  keys[key]();
});
document.getElementById('back').onclick = () => show(now - 1, false);
document.getElementById('on').onclick = () => show(now + 1, false);
addEventListener('hashchange', () => show(Number(location.hash.slice(1)) - 1));
addEventListener('resize', () => show(now, false));
document.body.classList.add('one');
show(Number(location.hash.slice(1) || 1) - 1, false);
