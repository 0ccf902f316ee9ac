// The truth, and the thoughts of a robot, at a time; times are control steps.

const JUMP = 0.6; // [m] between two rows: a longer move is a placement, and is not interpolated

class Recording {
  constructor(data, places, thoughts) {
    Object.assign(this, data);
    this.places = places;
    this.notes = thoughts;
    this.last = this.steps;
    this.general = Object.fromEntries(data.columns.general.map((name, at) => [name, at]));
    this.each = Object.fromEntries(data.columns.each.map((name, at) => [name, at]));
    this.noteWidth = thoughts ? thoughts.length / this.robots.length : 0;
    this.pulls = null;
  }

  static async from(data) {
    const width = data.columns.general.length + data.robots.length * data.columns.each.length;
    const places = await unpack(data.tables.places, data.rows, width);
    if (!data.thoughts) return new Recording(data, places, null);
    const { table, track, slots, groups, fields, steps } = data.thoughts;
    const most = Math.max(0, ...fields.map((names) => names.length));
    const more = groups.reduce((sum, [, count, parts]) => sum + count * parts.length, 0);
    const columns = (table.length + track.length * slots + more + most) * data.robots.length;
    const recording = new Recording(data, places, await unpack(data.tables.thoughts, steps.length, columns));
    if (data.fields) recording.pulls = new Fields(data.fields, steps, await unpackBytes(data.tables.fields, Fields.bytes(data.fields, steps)));
    return recording;
  }

  value(name, row) {
    return this.places[this.general[name]][row];
  }

  robotValue(r, name, row) {
    return this.places[this.columns.general.length + r * this.columns.each.length + this.each[name]][row];
  }

  // Return the step of the last note before a step, or -1.
  noteBefore(step) {
    const { steps } = this.thoughts;
    return steps[upTo(steps, step - 1) - 1] ?? -1;
  }

  // Return the last goal of the `steps` control steps before a time, or undefined.
  goalOf(time, steps) {
    return this.events.filter(([step, kind]) => kind === "goal" && step <= time && time - step < steps).pop();
  }

  // Return ball, robots and score at a time, interpolated between two rows.
  at(time) {
    const exact = Math.min(Math.max(time / this.every, 0), this.rows - 1);
    const row = Math.floor(exact), next = Math.min(row + 1, this.rows - 1), share = exact - row;
    const near = share < 0.5 ? row : next;
    const state = (name) => this.value(name, row);
    const ball = between(state("ball_x"), state("ball_y"), this.value("ball_x", next), this.value("ball_y", next), share);
    const robots = this.robots.map(([team, number, keeper], r) => {
      const get = (name, at = row) => this.robotValue(r, name, at);
      const place = between(get("x"), get("y"), get("x", next), get("y", next), share);
      const flags = get("state", near), bits = this.columns.states;
      return {
        r, team, number, keeper, ...place,
        heading: turned(get("heading") / 1e3, get("heading", next) / 1e3, share),
        pan: get("pan") / 1e3,
        active: (flags & bits.active) !== 0, hasBall: (flags & bits.has_ball) !== 0,
        fallen: (flags & bits.fallen) !== 0, kicks: (flags & bits.kicks) !== 0,
      };
    });
    return {
      row, ball, robots, clock: state("clock") / 10, half: state("half"), phase: state("phase"), team: state("team"),
      score: [state("score_home"), state("score_away")], direction: state("direction"), touch: state("touch"),
    };
  }

  // Tell whether robot r was placed elsewhere between two times, or at the first row after them.
  putElsewhere(r, early, late) {
    const from = Math.floor(early / this.every), to = Math.min(Math.ceil(late / this.every), this.rows - 1);
    for (let row = from; row < to; row++) {
      const away = (name) => this.robotValue(r, name, row + 1) - this.robotValue(r, name, row);
      if (Math.hypot(away("x"), away("y")) > JUMP * 1e3 && (row + 1) * this.every <= late) return true;
    }
    return false;
  }

  // Return the thought of robot r at the last note before a time, or null.
  thought(r, time) {
    if (!this.notes) return null;
    const { steps, table, track, slots, groups, fields, sees } = this.thoughts;
    let low = upTo(steps, time);
    if (low === 0) return null;
    const moved = low < steps.length && this.putElsewhere(r, steps[low - 1], time);
    if (moved) low += 1; // a thought from before the placement is out of date: take the next note
    const get = (column) => this.notes[r * this.noteWidth + column][low - 1];
    const span = low < steps.length && !moved ? steps[low] - steps[low - 1] : 0;
    const share = span > 0 ? Math.min(Math.max((time - steps[low - 1]) / span, 0), 1) : 0;
    const late = (column) => this.notes[r * this.noteWidth + column][Math.min(low, steps.length - 1)];
    // A place interpolated between two notes: the early note alone would lag behind things that move.
    const place = (column, same = true) => between(get(column), get(column + 1), late(column), late(column + 1), same ? share : 0);
    const of = Object.fromEntries(table.map((name, at) => [name, get(at)]));
    if ((of.sees & sees.thinks) === 0 && !fields[r].length) return null;
    const players = [];
    for (let slot = 0; slot < slots; slot++) {
      const first = table.length + slot * track.length, age = get(first + 2);
      if (age !== 0) players.push({ ...place(first, Math.sign(late(first + 2)) === Math.sign(age)), mate: age > 0, age: (Math.abs(age) - 1) / 10 });
    }
    const more = {};
    let next = table.length + slots * track.length;
    for (const [name, count, parts] of groups)
      more[name] = Array.from({ length: count }, () => Object.fromEntries(parts.map((part) => [part, get(next++)])));
    const memory = fields[r].map(([name, words, unit], at) => {
      const number = get(next + at);
      return { name, word: words[number], number: number / unit };
    });
    const saw = Object.fromEntries(Object.entries(sees).map(([name, bit]) => [name, (of.sees & bit) !== 0]));
    return {
      step: share > 0 ? time : steps[low - 1], saw, players, memory, more, knows: saw.thinks,
      own: { ...place(0), heading: turned(of.heading / 1e3, late(2) / 1e3, share), confidence: of.confidence / 100,
        spread: of.spread / 1e3, narrow: of.narrow / 1e3, axis: of.axis / 1e3 },
      ball: { ...place(table.indexOf("ball_x")), confidence: of.ball_confidence / 100, age: of.ball_age / 100 },
      seen: { players: of.players, marks: of.marks, infrared: of.infrared / 1e3 },
      command: ["forward", "left", "turn", "kick"].map((name) => [name, of[name] / 100]),
    };
  }

  name(r) {
    const [team, number, keeper] = this.robots[r];
    return `${["red", "blue"][team]} ${number}${keeper ? " (keeper)" : ""}`;
  }
}

// Return the number of sorted steps up to a time.
function upTo(steps, time) {
  let low = 0, high = steps.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (steps[middle] <= time + 1e-6) low = middle + 1; else high = middle;
  }
  return low;
}

function between(x, y, nextX, nextY, share) {
  const jumps = Math.hypot(nextX - x, nextY - y) > JUMP * 1e3;
  const part = jumps ? 0 : share;
  return { x: (x + (nextX - x) * part) / 1e3, y: (y + (nextY - y) * part) / 1e3 };
}

function turned(from, to, share) {
  return from + Math.atan2(Math.sin(to - from), Math.cos(to - from)) * share;
}

function tenths(seconds) {
  const whole = Math.max(0, Math.floor(10 * seconds + 1e-6));
  return `${minutes(Math.floor(whole / 10))}.${whole % 10}`;
}

function minutes(seconds) {
  const whole = Math.max(0, Math.floor(seconds + 1e-6));
  return `${String(Math.floor(whole / 60)).padStart(2, "0")}:${String(whole % 60).padStart(2, "0")}`;
}
