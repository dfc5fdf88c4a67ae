"use strict";
// Reads, every two seconds, who is in the farm (farm.json), what each replica counts (metrics/NAME,
// as Prometheus reads it) and how far the study is (study.json), and shows it. Rates are made here of
// two readings; a counter that begins anew, as after a restart, counts from there. `?every=S` in the
// address: seconds between readings.

const POLL = 1000 * (Number(new URLSearchParams(location.search).get("every")) || 2); // ms
const PATIENCE = 3000; // ms for an answer
const SPAN = 300;      // s of the charts
const RATE = 12;       // s that a rate is taken over
const WAIT = 30;       // s that waits are taken over
const LATE = 15;       // s without news of a study that runs

const SOURCES = [
  ["memory", "in memory"],
  ["disk", "on the replica's own disk"],
  ["tier", "in the shared store"],
  ["remade", "nowhere: made again"],
];
const COUNTERS = {
  edits: "remeshd_reuse_ratio_count",
  waited: 'remeshd_queue_wait_seconds_sum{lane="computation"}',
  begun: 'remeshd_queue_wait_seconds_count{lane="computation"}',
};
for (const [source] of SOURCES) COUNTERS[source] = `remeshd_cache_requests_total{result="${source}"}`;
const GAUGES = {
  ready: "remeshd_ready", running: "remeshd_computations_running",
  queued: 'remeshd_queue_depth{lane="computation"}', sharing: "remeshd_tier_waiting",
  memory: "remeshd_memory_bytes", budget: "remeshd_memory_budget_bytes",
};

// ---- readings

/** Values of a page of metrics by name with labels; what is no number is left out. */
function parse(text) {
  const values = new Map();
  for (const line of text.split("\n")) {
    const found = /^(\w+(?:\{[^}]*\})?) (\S+)$/.exec(line);
    if (found && Number.isFinite(Number(found[2]))) values.set(found[1], Number(found[2]));
  }
  return values;
}

class Replica {
  constructor(name, workers) {
    this.name = name;
    this.workers = workers;
    this.up = null;      // not known yet
    this.since = null;   // Date since when it is away
    this.gauges = {};
    this.raw = {};       // counters as last read
    this.totals = {};    // counted on through restarts
    this.samples = [];   // {t, totals} without a gap
    this.course = [];    // {t, value}: edits per second; value null: away
  }

  read(t, text) {
    const values = parse(text);
    this.up = true;
    this.since = null;
    for (const [key, name] of Object.entries(COUNTERS)) {
      const now = values.get(name) ?? 0, before = this.raw[key] ?? 0;
      this.totals[key] = (this.totals[key] ?? 0) + (now >= before ? now - before : now);
      this.raw[key] = now;
    }
    for (const [key, name] of Object.entries(GAUGES)) this.gauges[key] = values.get(name);
    this.samples.push({t, totals: {...this.totals}});
    while (this.samples[0].t < t - WAIT - POLL / 1000) this.samples.shift();
  }

  goneAway(now) {
    if (this.up !== false) this.since = now;
    this.up = false;
    this.samples = [];
  }

  /** By how much a counter grew in the last seconds, and in how many; null where that is not known. */
  growth(key, seconds) {
    const last = this.samples.at(-1);
    const first = this.samples.find((each) => last && each.t >= last.t - seconds - 0.5);
    if (!last || first === last) return null;
    return {amount: last.totals[key] - first.totals[key], seconds: last.t - first.t};
  }

  rate(key) {
    const growth = this.growth(key, RATE);
    return growth && growth.amount / growth.seconds;
  }

  note(t) {
    this.course.push({t, value: this.up ? this.rate("edits") : null});
    while (this.course[0].t < t - SPAN - 5) this.course.shift();
  }
}

/** Mean wait in seconds of what began lately; null where nothing did. */
function meanWait(replicas) {
  let waited = 0, begun = 0;
  for (const replica of replicas) {
    waited += replica.growth("waited", WAIT)?.amount ?? 0;
    begun += replica.growth("begun", WAIT)?.amount ?? 0;
  }
  return begun > 0 ? waited / begun : null;
}

/** Designs per second over the time of a study: {t, value} of equal steps. */
function speeds(course, seconds) {
  const doneAt = (t) => {
    let k = course.findIndex((point) => point[0] >= t);
    if (k < 0) return course.at(-1)[1];
    if (k === 0) return course[0][1];
    const [[t0, n0], [t1, n1]] = [course[k - 1], course[k]];
    return t1 > t0 ? n0 + (n1 - n0) * (t - t0) / (t1 - t0) : n1;
  };
  const end = Math.max(course.at(-1)[0], 0), step = Math.max(4, end / 60), points = [];
  for (let t = step; t <= end + 1e-9; t += step)
    points.push({t, value: Math.max(0, doneAt(t) - doneAt(t - step)) / step});
  return points;
}

// ---- words

const NONE = "\u2013";

const number = (value, digits = 0) =>
  value.toLocaleString("en", {minimumFractionDigits: digits, maximumFractionDigits: digits});
const perSecond = (value) => number(value, value < 99.95 ? 1 : 0), mebibytes = (value) => number(value / 2 ** 20);
const seconds = (value) => `${number(value, value < 9.995 ? 2 : 1)} s`;

function duration(value) {
  const whole = Math.round(value), minutes = Math.floor(whole / 60);
  if (whole < 60) return `${whole} s`;
  const [large, small] = minutes < 60 ? [`${minutes} min`, `${whole % 60} s`]
    : [`${Math.floor(minutes / 60)} h`, `${minutes % 60} min`];
  return small.startsWith("0 ") ? large : `${large} ${small}`;
}
const clock = (date) => date.toLocaleTimeString("en-GB");
const plain = (name) => name.replaceAll(/[._]/g, " ");

// ---- the page

const $ = (id) => document.getElementById(id);

function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}
function set(element, value, unit = "") {
  element.replaceChildren(value, ...(unit ? [" ", make("span", {class: "unit"}, unit)] : []));
}
function facts(list, rows) {
  list.replaceChildren(...rows.flatMap(([name, value, key]) =>
    [make("dt", {}, name), make("dd", key ? {"data-figure": key} : {}, value)]));
}

/** How much came from each source, side by side. */
class Shares {
  constructor(element) {
    this.element = element;
    element.replaceChildren(...SOURCES.map(([key]) => make("div", {class: key})));
  }

  show(counts) {
    counts.forEach((count, k) => Object.assign(this.element.children[k].style,
      {flexGrow: count, display: count > 0 ? "" : "none"}));
  }
}
const found = (replica) => SOURCES.map(([key]) => replica.totals[key] ?? 0);

/** A line over time, with its greatest value; a point without value is a gap. */
class Chart {
  constructor(parent, told, axis = true) {
    this.told = told;
    this.svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    for (const [name, value] of Object.entries({
      class: "chart", viewBox: "0 0 100 100", preserveAspectRatio: "none", role: "img"}))
      this.svg.setAttribute(name, value);
    this.top = axis ? make("div", {class: "axis"}) : null;
    this.bottom = axis ? make("div", {class: "axis"}) : null;
    parent.append(...(axis ? [this.top, this.svg, this.bottom] : [this.svg]));
  }

  draw(points, from, to, labels) {
    const known = points.filter((point) => point.value !== null && point.t >= from);
    const most = known.reduce((most, point) => Math.max(most, point.value), 0);
    const scale = Math.max(1, Math.ceil(most * 1.05));
    const x = (t) => (100 * Math.max(0, (t - from) / (to - from))).toFixed(2);
    const y = (value) => (100 - 100 * value / scale).toFixed(2);
    let line = "", area = "", run = [];
    const close = () => {
      if (run.length > 1) {
        const path = run.map((point) => `${x(point.t)},${y(point.value)}`).join("L");
        line += `M${path}`;
        area += `M${x(run[0].t)},100L${path}L${x(run.at(-1).t)},100Z`;
      }
      run = [];
    };
    for (const point of points) {
      if (point.value === null) close();
      else if (point.t >= from) run.push(point);
    }
    close();
    this.svg.innerHTML = `<path class="grid" d="M0,0H100M0,50H100M0,100H100"/>` +
      `<path class="area" d="${area}"/><path class="line" d="${line}"/>`;
    this.svg.setAttribute("aria-label",
      known.length ? `${this.told}: ${perSecond(known.at(-1).value)} now, ${perSecond(most)} at most`
        : `${this.told}: nothing yet`);
    if (!this.top) return;
    this.top.replaceChildren(number(scale));
    this.bottom.replaceChildren(...labels.map((label) => make("span", {}, label)));
  }
}

class Card {
  constructor(replica) {
    this.state = make("span", {class: "state"});
    this.list = make("dl");
    this.shares = new Shares(make("div", {class: "share", title: "Where meshes to start from were found"}));
    this.element = make("article", {class: "card replica", "data-replica": replica.name},
      make("h2", {}, make("span", {}, replica.name), this.state), this.list,
      this.shares.element);
    this.chart = new Chart(this.element, `Edits per second of ${replica.name}`, false);
  }

  show(replica, now, span) {
    const {up, gauges} = replica;
    this.element.classList.toggle("away", up === false);
    const ready = gauges.ready !== 0;
    this.state.className = `state ${up && ready ? "good" : up === null ? "quiet" : "bad"}`;
    this.state.textContent = up === null ? "not known yet" : !up ? `away since ${clock(replica.since)}`
      : ready ? "up" : "up, takes no work";
    const known = (value, words) => (up && value !== null && value !== undefined ? words(value) : NONE);
    facts(this.list, [
      ["Edits", known(replica.rate("edits"), (value) => `${perSecond(value)} per second`), "edits"],
      ["Workers busy", known(gauges.running, (value) => `${number(value)} of ${replica.workers}`), "busy"],
      ["Waiting for a worker", known(gauges.queued, (value) => number(value)), "queued"],
      ["Wait for a worker", known(up ? meanWait([replica]) : null, seconds), "wait"],
      ["Not yet shared", known(gauges.sharing,
        (value) => `${number(value)} ${value === 1 ? "object" : "objects"}`), "sharing"],
      ["Memory", known(gauges.memory, (value) =>
        `${mebibytes(value)} of ${mebibytes(gauges.budget)} MiB`), "memory"],
    ]);
    this.shares.show(found(replica));
    this.chart.draw(replica.course, now - span, now, []);
  }
}

class Page {
  constructor(farm) {
    this.replicas = farm.replicas.map((name) => new Replica(name, farm.workers));
    this.cards = this.replicas.map((replica) => new Card(replica));
    $("replicas").replaceChildren(...this.cards.map((card) => card.element));
    this.edits = new Chart($("edits-chart"), "Edits per second of all replicas");
    this.speed = new Chart($("study-chart"), "Designs per second");
    this.course = [];
    this.begun = performance.now() / 1000;
    $("sources-legend").replaceChildren(...SOURCES.map(([key, words]) => make("li", {},
      make("i", {class: key}), make("span", {"data-source": key}), ` ${words}`)));
    this.shares = new Shares($("sources"));
  }

  async read() {
    const t = performance.now() / 1000, now = new Date();
    const answers = await Promise.all(this.replicas.map((each) => ask(`metrics/${each.name}`)));
    const study = await ask("study.json");
    if (![...answers, study].some((answer) => answer.answered)) {
      status("No connection to the farm", "bad");
      return;
    }
    this.replicas.forEach((replica, k) => {
      if (answers[k].ok) replica.read(t, answers[k].text);
      else replica.goneAway(now);
      replica.note(t);
    });
    const rates = this.here().map((replica) => replica.rate("edits")).filter((rate) => rate !== null);
    const known = rates.length > 0 || this.here().length === 0;
    this.course.push({t, value: known ? rates.reduce((sum, rate) => sum + rate, 0) : null});
    while (this.course[0].t < t - SPAN - 5) this.course.shift();
    $("updated").textContent = `as of ${clock(now)}`;
    this.showFarm(t);
    this.showSources();
    this.cards.forEach((card, k) => card.show(this.replicas[k], t, this.span(t)));
    this.showStudy(study);
  }

  /** Seconds that charts show: whole minutes that this page has seen, up to SPAN. */
  span(t) {
    return Math.min(SPAN, 60 * Math.max(1, Math.ceil((t - this.begun) / 60)));
  }

  here() { return this.replicas.filter((replica) => replica.up); }

  showFarm(t) {
    const here = this.here(), all = this.replicas.length;
    status(here.length === all ? `all ${all} replicas up` : `${here.length} of ${all} replicas up`,
      here.length === all ? "good" : "bad");
    const figure = (name) => document.querySelector(`.tiles [data-figure=${name}]`);
    const sum = (key) => here.reduce((sum, replica) => sum + (replica.gauges[key] ?? 0), 0);
    const edits = this.course.at(-1).value, wait = meanWait(here);
    set(figure("edits"), edits === null ? NONE : perSecond(edits), "per second");
    set(figure("busy"), number(sum("running")),
      `of ${here.reduce((sum, replica) => sum + replica.workers, 0)}`);
    set(figure("wait"), wait === null ? NONE : number(wait, wait < 9.995 ? 2 : 1), "s on average");
    set(figure("sharing"), number(sum("sharing")), sum("sharing") === 1 ? "object" : "objects");
    const span = this.span(t);
    this.edits.draw(this.course, t - span, t, [`${duration(span)} ago`, "now"]);
  }

  showSources() {
    const each = this.replicas.map(found);
    const counts = SOURCES.map((_, k) => each.reduce((sum, counts) => sum + counts[k], 0));
    const all = counts.reduce((sum, count) => sum + count, 0);
    this.shares.show(counts);
    SOURCES.forEach(([key], k) => {
      const share = 100 * counts[k] / all;
      document.querySelector(`[data-source=${key}]`).textContent =
        all === 0 ? NONE : counts[k] > 0 && share < 0.1 ? "under 0.1 %" : `${number(share, 1)} %`;
    });
  }

  showStudy(answer) {
    let study = null;
    try {
      study = answer.ok ? JSON.parse(answer.text) : null;
    } catch { /* told as none */ }
    $("study").dataset.state = study ? study.state : "none";
    for (const part of [$("study").querySelector(".bar"), $("study-facts"), $("study-chart")])
      part.hidden = !study;
    $("study-model").textContent = study ? `of ${study.model}, ${number(study.nodes)} nodes a mesh` : "";
    if (!study) {
      set($("study-done"), "none yet");
      $("study-note").textContent = "It appears here when it begins.";
      return;
    }
    const {designs, done, failed, course, lightest} = study, over = done + failed;
    set($("study-done"), number(done), `of ${number(designs)} designs done`);
    const bar = $("study").querySelector(".bar");
    [["max", designs], ["now", over]].forEach(([what, value]) => bar.setAttribute(`aria-value${what}`, value));
    bar.firstElementChild.style.width = `${100 * over / Math.max(1, designs)}%`;
    const points = speeds(course, study.seconds);
    const running = study.state === "running";
    const speed = running ? points.at(-1)?.value ?? null : over / Math.max(study.seconds, 1e-9);
    facts($("study-facts"), [
      ["Speed", speed === null ? NONE : `${perSecond(speed)} designs per second`, "speed"],
      running ? ["Time left", speed ? `about ${duration((designs - over) / speed)}` : NONE, "left"]
        : ["Time taken", duration(study.seconds), "taken"],
      ["Could not be meshed", number(failed), "failed"],
      ["Kept of the mesh before", study.kept === null ? NONE : `${number(100 * study.kept)} % of the nodes`,
        "kept"],
      [running ? "Lightest so far" : "Lightest", lightest ? `${number(lightest.volume)} ${study.unit}\u00b3` : NONE, "lightest"],
    ]);
    $("study-note").textContent = note(study, answer.date);
    const end = points.at(-1)?.t ?? 4;
    this.speed.draw([{t: 0, value: 0}, ...points], 0, end, ["begin", duration(end)]);
  }
}

/** The sentence below the study's figures. */
function note(study, now) {
  const silent = (now - study.begun * 1000) / 1000 - study.seconds;
  if (study.state === "running" && silent > LATE) return `No news of the study for ${duration(silent)}.`;
  if (study.waiting > 0) return "Some of it waits for a replica.";
  if (!study.lightest) return "";
  return `The lightest has ${Object.entries(study.lightest.values)
    .map(([name, value]) => `${plain(name)} ${number(value, 2).replace(/\.?0+$/, "")}`).join(", ")}.`;
}

function status(words, kind) {
  $("status").textContent = words;
  $("status").className = kind;
}

/** A GET: whether anybody answered, whether with what was asked for, the text, the server's time. */
async function ask(address) {
  try {
    const answer = await fetch(address, {cache: "no-store", signal: AbortSignal.timeout(PATIENCE)});
    const date = Date.parse(answer.headers.get("Date") ?? "") || Date.now();
    return {answered: true, ok: answer.ok, text: await answer.text(), date};
  } catch {
    return {answered: false, ok: false, text: "", date: Date.now()};
  }
}

async function main() {
  let page = null;
  for (;;) {
    if (!page) {
      const answer = await ask("farm.json");
      if (answer.ok) page = new Page(JSON.parse(answer.text));
      else status("No connection to the farm", "bad");
    }
    if (page) await page.read();
    document.documentElement.dataset.readings = Number(document.documentElement.dataset.readings ?? 0) + 1;
    await new Promise((done) => setTimeout(done, POLL));
  }
}

main();
