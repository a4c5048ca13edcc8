/* Short functions that create elements and canvases. Strings of programs never become markup. */

function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === undefined) continue;
    element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.map(child => child instanceof Node ? child : String(child ?? '')));
  return element;
}

function drawing(tag, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/* Return the drawing context of a canvas with a size in CSS pixels, sharp on any screen. */
function sized(canvas, width, height) {
  const ratio = Math.max(1, window.devicePixelRatio || 1), [w, h] = [width, height].map(side => Math.max(1, Math.round(side * ratio)));
  if (canvas.width !== w || canvas.height !== h) {
    [canvas.width, canvas.height] = [w, h];
    canvas.style.width = width + 'px';
    canvas.style.height = height + 'px';
  }
  const pen = canvas.getContext('2d');
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return pen;
}

function note(pen, text, width, height, colour) {
  pen.font = '13px system-ui, sans-serif';
  pen.fillStyle = colour;
  pen.textAlign = 'center';
  pen.fillText(text, width / 2, height / 2);
  pen.textAlign = 'start';
}
