// Functions that make elements. Texts are set as text, so a text of a spec cannot become markup.

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

// Change a text only if it differs, so that the browser need not lay out the page again.
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
