// Buttons, keys and the running clock.

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16];
const LEAD = 1.5; // [s] before a goal or foul, at which its event begins to play
const GOAL_SHOWN = 4; // [s] for which the page announces a goal
const SWITCHES = ["belief", "sight", "field", "path", "roles", "infrared", "trail"];
const byId = (id) => document.getElementById(id);

class Player {
  constructor(recording) {
    this.recording = recording;
    this.pitch = new Pitch(byId("pitch"), recording);
    this.line = new TimeLine(byId("line"), recording);
    this.time = 0; // control steps
    this.playing = false;
    this.speed = 3;
    this.shown = { belief: true, sight: true, field: false, path: false, roles: false, infrared: false, trail: true, ...recording.shown, picked: -1 };
    this.stale = true;
    this.told = { second: -1, picked: -2 };
    this.fill();
    this.listen();
    this.resize();
    requestAnimationFrame((now) => this.tick(now, now));
  }

  fill() {
    const { recording } = this;
    byId("home").textContent = recording.teams[0];
    byId("away").textContent = recording.teams[1];
    const made = recording.recorded && recording.recorded !== recording.version ? `, recorded by ${recording.recorded}` : "";
    byId("about").textContent = `${recording.league}, ${recording.rate} control steps a second; soccer_env ${recording.version}${made}`;
    SPEEDS.forEach((speed, at) => byId("speed").append(new Option(`${speed}×`, String(at), false, at === this.speed)));
    byId("scrub").max = String(recording.last);
    recording.robots.forEach(([team, number, keeper], r) => {
      const chip = element("button", `${number}${keeper ? " K" : ""}`, `team${team}`);
      chip.setAttribute("aria-label", recording.name(r));
      chip.addEventListener("click", () => this.pick(this.shown.picked === r ? -1 : r));
      byId("chips").append(chip);
    });
    for (const id of SWITCHES) byId(id).setAttribute("aria-pressed", String(this.shown[id]));
    byId("infrared").hidden = !recording.body.legs;
    byId("field").hidden = !recording.pulls;
    this.pick(this.asked());
    const end = recording.rows - 1;
    const penalties = recording.events.filter(([, kind]) => kind === "penalty").map(([, , , , , score]) => score.join(" : ")).pop();
    byId("final").textContent = `final score ${recording.value("score_home", end)} : ${recording.value("score_away", end)}${penalties ? `, penalty kicks ${penalties}` : ""}`;
    fillScorers([byId("scorers0"), byId("scorers1")], recording, (event) => this.jump(event));
    byId("listed").value = recording.events.some(([, kind]) => kind === "goal" || kind === "penalty") ? "goals" : "calls";
    this.fillEvents();
  }

  // Return the robot that the flags name, else the robot nearest to the ball if an overlay needs one, or -1.
  asked() {
    const { shown, robots } = this.recording;
    if (!shown) return -1;
    if (shown.robot) return robots.findIndex(([team, number]) => `${["home", "away"][team]}_${number}` === shown.robot);
    if (!(shown.belief || shown.sight || shown.field || shown.path)) return -1;
    const { ball, robots: there } = this.recording.at(0), away = ({ x, y }) => Math.hypot(x - ball.x, y - ball.y);
    return there.filter(({ active }) => active).reduce((best, one) => (!best || away(one) < away(best) ? one : best), null)?.r ?? -1;
  }

  fillEvents() {
    fillEvents(byId("events"), this.recording, byId("listed").value, (event) => this.jump(event));
    this.told.second = -1;
    this.stale = true;
  }

  listen() {
    const press = (id, act) => byId(id).addEventListener("click", act);
    press("play", () => this.toggle());
    press("back", () => this.step(-1));
    press("forth", () => this.step(1));
    press("before", () => this.toEvent(-1));
    press("after", () => this.toEvent(1));
    press("theme", () => this.turnTheme());
    press("ask", () => byId("help").showModal());
    for (const id of SWITCHES) press(id, () => this.flip(id));
    byId("speed").addEventListener("change", (event) => this.setSpeed(Number(event.target.value)));
    byId("listed").addEventListener("change", () => this.fillEvents());
    byId("scrub").addEventListener("input", (event) => this.seek(Number(event.target.value)));
    byId("pitch").addEventListener("pointerup", (event) => this.pick(this.pitch.robotAt(this.time, this.pitch.place(event))));
    const drag = (event) => {
      if (event.type === "pointerdown") byId("line").setPointerCapture(event.pointerId);
      if (event.buttons) this.seek(this.line.time(event));
    };
    byId("line").addEventListener("pointerdown", drag);
    byId("line").addEventListener("pointermove", drag);
    document.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.resize()).observe(byId("stage"));
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || byId("help").open) return;
    const typing = event.target.matches("select, input");
    const second = this.recording.rate * (event.shiftKey ? 5 : 1);
    const keys = {
      " ": () => this.toggle(), ArrowLeft: () => this.seek(this.time - second), ArrowRight: () => this.seek(this.time + second),
      ArrowUp: () => this.setSpeed(this.speed + 1), ArrowDown: () => this.setSpeed(this.speed - 1),
      ",": () => this.step(-1), ".": () => this.step(1), p: () => this.toEvent(-1), n: () => this.toEvent(1),
      r: () => this.pick((this.shown.picked + 1) % this.recording.robots.length), Escape: () => this.pick(-1),
      b: () => this.flip("belief"), v: () => this.flip("sight"), f: () => this.flip("field"), w: () => this.flip("path"), o: () => this.flip("roles"),
      i: () => this.flip("infrared"), t: () => this.flip("trail"), d: () => this.turnTheme(),
      "?": () => byId("help").showModal(),
    };
    if (!(event.key in keys) || (typing && event.target.matches("select"))) return;
    if (event.key === " " && event.target.matches("button:not(#play)")) event.target.blur();
    event.preventDefault();
    keys[event.key]();
  }

  toggle() {
    if (!this.playing && this.time >= this.recording.last) this.time = 0;
    this.playing = !this.playing;
    byId("play").textContent = this.playing ? "❚❚" : "▶";
    this.stale = true;
  }

  setSpeed(at) {
    this.speed = Math.min(Math.max(at, 0), SPEEDS.length - 1);
    byId("speed").value = String(this.speed);
  }

  seek(time) {
    this.time = Math.min(Math.max(time, 0), this.recording.last);
    this.stale = true;
  }

  step(steps) {
    if (this.playing) this.toggle();
    this.seek(Math.round(this.time / this.recording.every + steps) * this.recording.every);
  }

  jump(event) {
    if (event[3] >= 0) this.pick(event[3]);
    this.seek(this.start(event));
  }

  // Return the time at which an event begins to play: for a goal, before the scorer played the ball.
  start([step, kind, , , , goal]) {
    const lead = LEAD * this.recording.rate;
    if (kind === "goal") return Math.max(0, Math.min(goal.played - lead / 2, step - lead));
    return Math.max(0, kind === "foul" || kind === "penalty" ? step - lead : step);
  }

  // Go to the next (way 1) or previous (way -1) event.
  toEvent(way) {
    const events = this.recording.events.filter(([, kind]) => kind !== "kick");
    const times = events.map((event) => this.start(event));
    const order = way > 0 ? events.map((_, at) => at) : events.map((_, at) => events.length - 1 - at);
    const found = order.find((at) => way * (times[at] - this.time) > 1);
    if (found !== undefined) this.jump(events[found]);
  }

  pick(r) {
    this.shown.picked = r;
    this.told.picked = -2;
    [...byId("chips").children].forEach((chip, at) => chip.setAttribute("aria-pressed", String(at === r)));
    this.stale = true;
  }

  flip(name) {
    this.shown[name] = !this.shown[name];
    byId(name).setAttribute("aria-pressed", String(this.shown[name]));
    this.stale = true;
  }

  turnTheme() {
    const root = document.documentElement;
    root.dataset.theme = root.dataset.theme === "dark" ? "light" : "dark";
    this.resize();
  }

  resize() {
    this.pitch.resize();
    this.line.resize();
    this.stale = true;
  }

  tick(now, before) {
    if (this.playing) {
      this.time += (Math.min(now - before, 250) / 1e3) * this.recording.rate * SPEEDS[this.speed];
      if (this.time >= this.recording.last) {
        this.time = this.recording.last;
        this.toggle();
      }
      this.stale = true;
    }
    if (this.stale) this.show(now);
    requestAnimationFrame((next) => this.tick(next, now));
  }

  show(now) {
    this.stale = false;
    const { recording } = this, moment = this.pitch.draw(this.time, this.shown);
    this.line.draw(this.time);
    byId("scrub").value = String(Math.round(this.time));
    byId("score").textContent = moment.score.join(" : ");
    const half = recording.half_length === null ? "" : `, ${["1st", "2nd"][moment.half] || ""} half`;
    byId("clock").textContent = `${minutes(moment.clock)}${half}`;
    const whose = moment.phase > 0 && moment.team >= 0 ? ` ${["red", "blue"][moment.team]}` : "";
    const goal = recording.goalOf(this.time, GOAL_SHOWN * recording.rate);
    byId("phase").textContent = goal ? `GOAL: ${goal[4]}` : `${recording.phases[moment.phase] || ""}${whose}`;
    byId("phase").classList.toggle("goal", Boolean(goal));
    byId("time").textContent = `${tenths(this.time / recording.rate)} / ${minutes(recording.last / recording.rate)}`;
    if (!this.playing || now - (this.told.at || 0) > 100 || this.told.picked !== this.shown.picked) {
      this.told = { at: now, picked: this.shown.picked };
      showRecord(byId("record"), recording, this.shown.picked, this.time, moment);
      markEvents(byId("events"), this.time);
    }
  }
}

async function begin() {
  if (window.matchMedia("(prefers-color-scheme: dark)").matches) document.documentElement.dataset.theme = "dark";
  try {
    const recording = await Recording.from(JSON.parse(byId("data").textContent));
    window.player = new Player(recording);
    document.documentElement.dataset.ready = "yes";
  } catch (error) {
    byId("failed").hidden = false;
    byId("failed").textContent = typeof DecompressionStream === "undefined" ? "This page needs a browser of 2023 or later." : `This page cannot be shown: ${error.message}`;
    throw error;
  }
}

begin();
