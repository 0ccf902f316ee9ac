// Beliefs, percepts and plans of robots, drawn over the field.

const TRAVELLED = 6; // [s] of a robot's travelled path
const BEAM = "#ff5496";
const RECOVERIES = /\b(back|sidestep|rotate)\b/; // behaviours of a stuck robot

class Overlays {
  constructor(pitch, context, moment) {
    this.pitch = pitch;
    this.c = context;
    this.moment = moment;
    this.recording = pitch.recording;
    this.ratio = pitch.ratio;
    this.scale = pitch.scale;
    for (const name of ["px", "py", "path", "ring", "disc", "outline", "label"]) this[name] = pitch[name].bind(pitch);
  }

  // The field of view with its blobs, or rays to the percepts of an omnidirectional camera.
  drawSight(robot, thought) {
    const { c, recording } = this, more = thought ? thought.more : {};
    c.save();
    c.beginPath();
    const out = recording.view > 0 ? 0 : recording.pitch.band_side + recording.pitch.goal_depth;
    c.rect(this.px(-recording.pitch.length / 2 - out), this.py(recording.pitch.width / 2 + out),
      (recording.pitch.length + 2 * out) * this.scale, (recording.pitch.width + 2 * out) * this.scale);
    c.clip();
    if (recording.view > 0) this.drawView(robot, more);
    else if (more.players) this.drawSightings(robot, more);
    c.restore();
  }

  drawView(robot, more) {
    const { c, recording } = this, half = recording.view / 2, far = 4 * recording.pitch.length;
    const middle = robot.heading + (more.head ? more.head[0].pan / 100 : robot.pan), neck = recording.neck;
    const [x, y] = [robot.x + neck * Math.cos(robot.heading), robot.y + neck * Math.sin(robot.heading)];
    const sector = (low, high, colour) => {
      const edge = (angle) => [x + far * Math.cos(angle), y + far * Math.sin(angle)];
      this.path(c, [[x, y], edge(low), edge((low + high) / 2), edge(high)], true);
      c.fillStyle = colour;
      c.fill();
    };
    sector(middle - half, middle + half, "rgba(255,246,190,.2)");
    for (const [name, blobs] of Object.entries(this.blobs(robot, more))) {
      const tint = this.tints(robot)[name];
      for (const { left, right } of blobs)
        sector(middle + Math.atan(right / recording.focal), middle + Math.atan(left / recording.focal), `${tint}88`);
    }
  }

  // Return the blobs of the camera, by kind of object.
  blobs(robot, more) {
    const names = ["landmarks", "own_goal", "opponent_goal", "teammates", "opponents", "ball"];
    const there = (boxes) => boxes.filter(({ left, right, high, low }) => left || right || high || low);
    return Object.fromEntries(names.filter((name) => more.head && more[name]).map((name) => [name, there(more[name])]));
  }

  tints(robot) {
    const goals = ["#facc26", "#54b8f0"], own = (this.moment.direction > 0) === (robot.team === 0) ? 0 : 1;
    return { ball: BALL, own_goal: goals[own], opponent_goal: goals[1 - own], teammates: LIGHT[robot.team],
      opponents: LIGHT[1 - robot.team], landmarks: "#ffffff" };
  }

  drawSightings(robot, more) {
    const { c, recording } = this, tints = this.tints(robot);
    const at = (bearing, distance) => [robot.x + distance * Math.cos(robot.heading + bearing), robot.y + distance * Math.sin(robot.heading + bearing)];
    const ray = ({ bearing, distance }, tint) => {
      if (!distance) return;
      const end = at(bearing / 100, Math.abs(distance) / 100);
      this.path(c, [[robot.x, robot.y], end]);
      c.strokeStyle = tint;
      c.lineWidth = 1.5 * this.ratio;
      c.stroke();
      this.disc(c, ...end, (4 * this.ratio) / this.scale, tint);
    };
    (more.lines || []).forEach(({ distance }, i) => {
      if (distance) this.disc(c, ...at((2 * Math.PI * i) / recording.directions, distance / 10), (2.5 * this.ratio) / this.scale, KEEPER);
    });
    for (const player of more.players) ray(player, tints[player.distance > 0 ? "teammates" : "opponents"]);
    for (const name of ["own_goal", "opponent_goal", "ball"]) for (const thing of more[name] || []) ray(thing, tints[name]);
  }

  drawTravelled(robot) {
    const { c, recording, moment } = this, rows = Math.round((TRAVELLED * recording.rate) / recording.every);
    const way = [[robot.x, robot.y]];
    for (let row = moment.row; row >= Math.max(0, moment.row - rows); row--) {
      const [x, y] = [recording.robotValue(robot.r, "x", row) / 1e3, recording.robotValue(robot.r, "y", row) / 1e3];
      if (Math.hypot(x - way.at(-1)[0], y - way.at(-1)[1]) > JUMP) break;
      way.push([x, y]);
    }
    this.path(c, way);
    c.strokeStyle = LIGHT[robot.team];
    c.lineWidth = 2 * this.ratio;
    c.stroke();
  }

  drawPlan(thought) {
    const { c } = this, way = (thought.more.plan || []).map(({ x, y }) => [x / 100, y / 100]);
    if (!way.some(([x, y]) => x || y)) return;
    for (const [colour, width] of [[INK, 4.6], ["#fff", 2.4]]) {
      this.path(c, way);
      c.strokeStyle = colour;
      c.lineWidth = width * this.ratio;
      c.stroke();
    }
    this.ring(c, ...way.at(-1), (6 * this.ratio) / this.scale, "#fff", 2 * this.ratio);
  }

  drawBeams(time) {
    const { c, recording } = this;
    for (const robot of this.moment.robots) {
      const thought = robot.active ? recording.thought(robot.r, time) : null;
      if (!thought || thought.seen.infrared <= 0) continue;
      const gaze = robot.heading + (thought.more.head ? thought.more.head[0].pan / 100 : robot.pan), range = thought.seen.infrared;
      const start = [robot.x + recording.neck * Math.cos(robot.heading), robot.y + recording.neck * Math.sin(robot.heading)];
      const end = [start[0] + range * Math.cos(gaze), start[1] + range * Math.sin(gaze)];
      this.path(c, [start, end]);
      c.strokeStyle = BEAM;
      c.lineWidth = 2 * this.ratio;
      c.stroke();
      this.disc(c, ...end, (3.5 * this.ratio) / this.scale, BEAM);
      this.label(c, { x: end[0], y: end[1] }, `${range.toFixed(2)} m`, BEAM);
    }
  }

  drawRoles(time) {
    const { c, recording } = this;
    for (const robot of this.moment.robots) {
      const thought = robot.active ? recording.thought(robot.r, time) : null;
      const words = thought ? roleOf(thought, robot.keeper) : "";
      const down = 10 + (1.1 * recording.body.reach * this.scale) / this.ratio;
      if (words) this.label(c, robot, words, RECOVERIES.test(words) ? AMBER : LIGHT[robot.team], "center", 0, down);
    }
  }

  // The beliefs of a robot, dashed, with lines to the truth.
  drawBelief(robot, thought) {
    const { c, moment } = this, thin = 1.6 * this.ratio, dash = [5 * this.ratio, 4 * this.ratio], { own, ball } = thought;
    const link = (from, to, colour) => {
      this.path(c, [[from.x, from.y], [to.x, to.y]]);
      c.strokeStyle = colour;
      c.lineWidth = thin;
      c.setLineDash([2 * this.ratio, 3 * this.ratio]);
      c.stroke();
      c.setLineDash([]);
    };
    link(robot, own, BELIEF);
    c.setLineDash(dash);
    for (const [role, points] of this.recording.body.pieces) {
      if (role !== "body") continue;
      this.path(c, this.outline(own, points), true);
      c.strokeStyle = BELIEF;
      c.lineWidth = 2.2 * this.ratio;
      c.stroke();
    }
    c.setLineDash([]);
    if (own.spread > 0) {
      c.beginPath();
      c.ellipse(this.px(own.x), this.py(own.y), 2 * own.spread * this.scale, 2 * own.narrow * this.scale, -own.axis, 0, 7);
      c.fillStyle = "rgba(255,220,30,.16)";
      c.strokeStyle = "rgba(255,220,30,.9)";
      c.lineWidth = thin;
      c.fill();
      c.stroke();
    }
    for (const player of thought.players) {
      const team = player.mate ? robot.team : 1 - robot.team;
      this.ring(c, player.x, player.y, 0.9 * this.recording.body.reach, LIGHT[team], 2 * this.ratio, dash);
      if (player.age >= 0.5) this.label(c, player, `${player.age.toFixed(1)} s`, LIGHT[team]);
    }
    if (ball.confidence > 0 || ball.age < 60) {
      link(moment.ball, ball, "#ffc480");
      this.ring(c, ball.x, ball.y, Math.max(1.5 * this.recording.pitch.ball, (7 * this.ratio) / this.scale), "#ffc480", 2.4 * this.ratio, dash);
    }
  }
}

// What a robot does, in its team's words, or by its rank among the robots that go to the ball.
function roleOf(thought, keeper) {
  const said = decision(thought).split(", ").filter((word) => word && !(keeper && /^(attacker|supporter)$/.test(word)));
  if (said.length) return said.join(", ");
  const rank = thought.memory.find(({ name }) => name.split(".").pop() === "rank");
  return rank === undefined ? "" : keeper ? "goalkeeper" : rank.number === 0 ? "attacker" : "supporter";
}
