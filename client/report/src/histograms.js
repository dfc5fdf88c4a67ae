// SPDX-License-Identifier: Apache-2.0
// Histograms of the two meshes, one over the other.
import uPlot from "uplot";
import { el, section, short } from "./dom.js";
import { theme } from "./theme.js";

const HEIGHT = 260;

/** Edges of the bins and shares in percent; the last share is repeated, as steps need it. */
function shares(bins, most) {
  const all = bins.reduce((sum, count) => sum + count, 0) || 1;
  const values = bins.map((count) => (100 * count) / all);
  return {
    edges: Array.from({ length: bins.length + 1 }, (_, k) => (k * most) / bins.length),
    values: [...values, values.at(-1)],
  };
}

/** Rarer than one in a million is below the axis of a logarithmic scale. */
const LEAST = 1e-4;

function options(chart, sides, width, isLog) {
  const colours = theme();
  const font = `12px ${getComputedStyle(document.body).fontFamily}`;
  const axis = {
    stroke: colours.muted,
    font,
    labelFont: font,
    labelSize: 18,
    grid: { stroke: colours.line, width: 1 },
    ticks: { stroke: colours.line, width: 1 },
  };
  const { stepped } = uPlot.paths;
  const series = sides.map((side, k) => {
    const isBase = sides.length > 1 && k === 0;
    const stroke = colours[isBase ? "base-series" : "modified-series"];
    return {
      label: sides.length === 1 ? side.name : isBase ? `BASE ${side.name}` : `NEW ${side.name}`,
      stroke,
      width: isBase ? 1 : 2,
      fill: isBase ? `${stroke}55` : undefined,
      paths: stepped({ align: 1 }),
      points: { show: false },
      value: (_, value) => (value === null ? "–" : `${short(value, 3)} %`),
    };
  });
  return {
    width,
    height: HEIGHT,
    padding: [10, 12, 0, 0],
    cursor: { drag: { x: true, y: false }, points: { show: false } },
    scales: {
      x: { time: false },
      y: isLog ? { distr: 3 } : { range: (_, __, high) => [0, high * 1.06] },
    },
    axes: [
      { ...axis, label: chart.unit },
      {
        ...axis,
        label: chart.counted,
        size: 56,
        values: (_, ticks) => ticks.map((tick) => (tick === null ? "" : `${short(tick, 2)} %`)),
      },
    ],
    series: [
      { label: chart.short, value: (_, value) => (value === null ? "–" : short(value, 3)) },
      ...series,
    ],
  };
}

class Histogram {
  constructor(chart, sides) {
    this.chart = chart;
    this.sides = sides;
    this.isLog = false;
    this.place = el("div", { class: "chart", role: "img", "aria-label": this.inWords() });
    this.scale = el(
      "button",
      {
        type: "button",
        class: "quiet",
        "aria-pressed": "false",
        onclick: () => {
          this.isLog = !this.isLog;
          this.scale.setAttribute("aria-pressed", String(this.isLog));
          this.draw();
        },
      },
      "Logarithmic",
    );
    this.element = el(
      "figure",
      {},
      el("figcaption", {}, el("strong", {}, chart.title), this.scale),
      this.place,
    );
    new ResizeObserver(() => this.width !== this.place.clientWidth && this.draw()).observe(
      this.place,
    );
  }

  /** For those who do not see the drawing: the bin with most, by mesh. */
  inWords() {
    const texts = this.sides.map((side) => {
      const { edges, values } = shares(side.mesh[this.chart.bins], this.chart.most);
      const k = values.indexOf(Math.max(...values));
      return `${side.name}: most, ${short(values[k], 3)} %, from ${short(edges[k], 3)} to ${short(edges[k + 1], 3)}`;
    });
    return `Histogram of ${this.chart.title}. ${texts.join(". ")}`;
  }

  draw() {
    this.width = this.place.clientWidth;
    if (this.width === 0) return;
    this.plot?.destroy();
    const each = this.sides.map((side) => shares(side.mesh[this.chart.bins], this.chart.most));
    const values = each.map((one) =>
      this.isLog ? one.values.map((v) => (v < LEAST ? null : v)) : one.values,
    );
    this.plot = new uPlot(
      options(this.chart, this.sides, this.width, this.isLog),
      [each[0].edges, ...values],
      this.place,
    );
  }
}

export function histogramsSection(sides) {
  const charts = [
    new Histogram(
      {
        title: "Quality of the tets",
        bins: "qualities",
        most: 1,
        short: "from",
        counted: "of the tets",
        unit: "volume-length (a regular tet has 1)",
      },
      sides,
    ),
    new Histogram(
      {
        title: "Dihedral angles",
        bins: "angles",
        most: 180,
        short: "from",
        counted: "of the angles",
        unit: "degrees (a regular tet has 70.5)",
      },
      sides,
    ),
  ];
  const measure =
    "The volume-length of a tet is 6√2 V / l³, with its volume V and the root mean square l of its six edges.";
  return {
    element: section(
      "quality",
      "Quality",
      el("p", { class: "note" }, measure),
      el(
        "div",
        { class: "charts" },
        charts.map((chart) => chart.element),
      ),
    ),
    redraw: () => charts.forEach((chart) => chart.draw()),
  };
}
