// Elements in one call. Text is always text: what a spec says cannot become markup.

export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

// Change text only where it is another one, so that the browser has nothing to lay out anew.
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
