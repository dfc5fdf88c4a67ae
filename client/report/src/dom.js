// SPDX-License-Identifier: Apache-2.0
// Small helpers to write the page: elements and numbers.

/** An element with attributes (`onclick` and the like are listeners) and children. */
export function el(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(
    ...children.flat(Infinity).filter((child) => child !== null && child !== undefined),
  );
  return element;
}

const whole = new Intl.NumberFormat("en");

export const integer = (value) => whole.format(value);

/** A number in so many significant digits; without an exponent where that is short. */
export function short(value, digits = 4) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e9)) return value.toExponential(digits - 1);
  return new Intl.NumberFormat("en", { maximumSignificantDigits: digits }).format(value);
}

export const percent = (part, all) => (all === 0 ? "–" : `${((100 * part) / all).toFixed(1)} %`);

/** A section of the page with its heading. */
export function section(id, title, ...children) {
  return el(
    "section",
    { id, "aria-labelledby": `${id}-title` },
    el("h2", { id: `${id}-title` }, title),
    ...children,
  );
}

/** A table with a caption; cells that are numbers stand to the right. */
export function table(caption, heads, rows, attributes = {}) {
  const cell = (content, k) => {
    const isNumber = heads[k].number;
    return k === 0
      ? el("th", { scope: "row" }, content)
      : el("td", { class: isNumber ? "number" : null }, content);
  };
  return el(
    "div",
    { class: "table-frame", tabindex: "0", role: "region", "aria-label": caption },
    el(
      "table",
      attributes,
      el("caption", {}, caption),
      el(
        "thead",
        {},
        el(
          "tr",
          {},
          heads.map((head) =>
            el("th", { scope: "col", class: head.number ? "number" : null }, head.title),
          ),
        ),
      ),
      el(
        "tbody",
        {},
        rows.map((row) => el("tr", {}, row.map(cell))),
      ),
    ),
  );
}
