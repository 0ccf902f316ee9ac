// Draws the field and everything on it, in the colours of the pictures.

const TEAM = ["#d0262c", "#2450c4"], LIGHT = ["#ff9a94", "#9cc0ff"], INK = "#101318", AMBER = "#ffbe28";
const BALL = "#ff7a10", KEEPER = "#ffdc1e", STEEL = "#ced2d8", BELIEF = "#fff6be";
const TRAIL = 2.5; // [s] of the ball's trail

class Pitch {
  constructor(canvas, recording) {
    this.canvas = canvas;
    this.recording = recording;
    this.context = canvas.getContext("2d");
    const { length, width, goal_depth, band_end, band_side } = recording.pitch;
    this.half = [length / 2 + Math.max(goal_depth, band_end) + 0.06 * width, width / 2 + band_side + 0.13 * width];
    document.documentElement.style.setProperty("--aspect", String(this.half[0] / this.half[1]));
  }

  // Fit the field into the canvas.
  resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2.5), box = this.canvas.getBoundingClientRect();
    this.canvas.width = Math.max(1, Math.round(box.width * ratio));
    this.canvas.height = Math.max(1, Math.round(box.height * ratio));
    this.ratio = ratio;
    this.scale = Math.min(this.canvas.width / 2 / this.half[0], this.canvas.height / 2 / this.half[1]);
    this.ground = document.createElement("canvas");
    this.ground.width = this.canvas.width;
    this.ground.height = this.canvas.height;
    this.drawGround(this.ground.getContext("2d"));
  }

  // Return the place on the field [m] of a pointer.
  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return {
      x: ((event.clientX - box.left) * this.ratio - this.canvas.width / 2) / this.scale,
      y: (this.canvas.height / 2 - (event.clientY - box.top) * this.ratio) / this.scale,
    };
  }

  px(x) { return this.canvas.width / 2 + this.scale * x; }
  py(y) { return this.canvas.height / 2 - this.scale * y; }

  drawGround(c) {
    const p = this.recording.pitch, x = p.length / 2, y = p.width / 2;
    const box = (left, bottom, right, top, colour) => {
      c.fillStyle = colour;
      c.fillRect(this.px(left), this.py(top), this.scale * (right - left), this.scale * (top - bottom));
    };
    const frame = (left, bottom, right, top) =>
      c.strokeRect(this.px(left), this.py(top), this.scale * (right - left), this.scale * (top - bottom));
    c.fillStyle = "#262b33";
    c.fillRect(0, 0, c.canvas.width, c.canvas.height);
    if (p.walled) box(-x - 0.05, -y - 0.05, x + 0.05, y + 0.05, "#dededa");
    else box(-x - p.band_end, -y - p.band_side, x + p.band_end, y + p.band_side, "#266e3e");
    for (let stripe = 0; stripe < 13; stripe++) {
      const left = -x + (stripe * p.length) / 13;
      box(left, -y, left + p.length / 13, y, stripe % 2 ? "#30834b" : "#2c7c46");
    }
    for (const [side, colour] of [[-1, "#facc26"], [1, "#54b8f0"]]) {
      const ends = [side * x, side * (x + p.goal_depth)].sort((a, b) => a - b);
      box(ends[0], -p.goal_width / 2, ends[1], p.goal_width / 2, colour);
    }
    c.strokeStyle = "#f0f4f0";
    c.lineWidth = Math.max(1.2, p.line * this.scale);
    frame(-x, -y, x, y);
    c.beginPath();
    c.moveTo(this.px(0), this.py(-y));
    c.lineTo(this.px(0), this.py(y));
    c.stroke();
    for (const side of [-1, 1])
      for (const [depth, width] of [[p.penalty_depth, p.penalty_width], [p.goal_area_depth, p.goal_area_width]])
        if (depth > 0 && width > 0) frame(side > 0 ? x - depth : -x, -width / 2, side > 0 ? x : depth - x, width / 2);
    this.ring(c, 0, 0, p.circle, "#f0f4f0", c.lineWidth);
  }

  ring(c, x, y, radius, colour, width, dash = []) {
    c.beginPath();
    c.setLineDash(dash);
    c.arc(this.px(x), this.py(y), Math.max(0.5, radius * this.scale), 0, 7);
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.stroke();
    c.setLineDash([]);
  }

  disc(c, x, y, radius, colour) {
    c.beginPath();
    c.arc(this.px(x), this.py(y), radius * this.scale, 0, 7);
    c.fillStyle = colour;
    c.fill();
  }

  path(c, points, closed) {
    c.beginPath();
    points.forEach(([x, y], at) => (at ? c.lineTo(this.px(x), this.py(y)) : c.moveTo(this.px(x), this.py(y))));
    if (closed) c.closePath();
  }

  draw(time, shown) {
    const c = this.context, moment = this.recording.at(time);
    c.drawImage(this.ground, 0, 0);
    const picked = shown.picked >= 0 ? moment.robots[shown.picked] : null;
    const thought = picked ? this.recording.thought(shown.picked, time) : null;
    const over = new Overlays(this, c, moment);
    if (picked && picked.active && shown.field && this.recording.pulls) this.recording.pulls.draw(c, this, picked.r, time);
    if (picked && picked.active && shown.sight) over.drawSight(picked, thought);
    if (shown.trail) this.drawTrail(c, moment);
    if (picked && shown.path) over.drawTravelled(picked);
    for (const robot of moment.robots) if (robot.active) this.drawRobot(c, robot, robot === picked);
    this.drawBall(c, moment.ball);
    if (thought && shown.path) over.drawPlan(thought);
    if (shown.infrared) over.drawBeams(time);
    if (thought && thought.knows && shown.belief) over.drawBelief(picked, thought);
    if (shown.roles) over.drawRoles(time);
    this.drawDirections(c, moment.direction);
    return moment;
  }

  drawDirections(c, direction) {
    const y = this.recording.pitch.width / 2 + this.recording.pitch.band_side, size = 0.05 * this.recording.pitch.width;
    c.font = `${Math.max(11 * this.ratio, 0.6 * size * this.scale)}px system-ui, sans-serif`;
    c.textAlign = "center";
    c.textBaseline = "middle";
    for (const [team, ahead] of [[0, direction], [1, -direction]]) {
      c.fillStyle = LIGHT[team];
      const words = `${["red", "blue"][team]} attacks`;
      c.fillText(ahead > 0 ? `${words} ›››` : `‹‹‹ ${words}`, this.px((-ahead * this.recording.pitch.length) / 4), this.py(y + 1.4 * size));
    }
  }

  drawTrail(c, moment) {
    const rows = Math.round((TRAIL * this.recording.rate) / this.recording.every);
    c.lineCap = "round";
    for (let row = Math.max(1, moment.row - rows + 1); row <= moment.row; row++) {
      const get = (name, at) => this.recording.value(name, at) / 1e3;
      const [x, y, oldX, oldY] = [get("ball_x", row), get("ball_y", row), get("ball_x", row - 1), get("ball_y", row - 1)];
      if (Math.hypot(x - oldX, y - oldY) > JUMP) continue;
      this.path(c, [[oldX, oldY], [x, y]]);
      c.strokeStyle = `rgba(255,178,96,${0.75 * (1 - (moment.row - row) / rows)})`;
      c.lineWidth = Math.max(2 * this.ratio, this.recording.pitch.ball * this.scale);
      c.stroke();
    }
  }

  drawBall(c, ball) {
    const radius = Math.max(this.recording.pitch.ball, (3.5 * this.ratio) / this.scale);
    this.disc(c, ball.x, ball.y, radius + (1 * this.ratio) / this.scale, "#783000");
    this.disc(c, ball.x, ball.y, radius, BALL);
  }

  outline(robot, points) {
    const cosine = Math.cos(robot.heading), sine = Math.sin(robot.heading);
    return points.map(([u, v]) => [robot.x + cosine * u - sine * v, robot.y + sine * u + cosine * v]);
  }

  drawRobot(c, robot, picked) {
    const body = this.recording.body, rim = 1.2 * this.ratio;
    const fills = { tip: robot.kicks ? AMBER : body.legs ? "#e8e9ec" : STEEL, leg: TEAM[robot.team], body: TEAM[robot.team] };
    if (picked) this.ring(c, robot.x, robot.y, 1.45 * body.reach, "#fff", 2.5 * this.ratio);
    if (robot.hasBall) this.ring(c, robot.x, robot.y, 1.2 * body.reach, BALL, 2 * this.ratio);
    for (const [role, points] of body.pieces) {
      this.path(c, this.outline(robot, points), true);
      c.fillStyle = fills[role];
      c.strokeStyle = role === "body" && robot.keeper ? KEEPER : INK;
      c.lineWidth = role === "body" && robot.keeper ? 2.4 * rim : rim;
      c.stroke();
      c.fill();
    }
    if (!body.legs) {
      this.disc(c, ...this.outline(robot, [[body.disc[0], 0]])[0], body.disc[1], robot.keeper ? KEEPER : INK);
      this.disc(c, ...this.outline(robot, [[body.disc[0], 0]])[0], 0.82 * body.disc[1], TEAM[robot.team]);
    }
    const gaze = robot.heading + (body.legs ? robot.pan : 0), ahead = body.legs ? 0.55 : 0.5;
    const nose = [robot.x + ahead * body.reach * Math.cos(robot.heading), robot.y + ahead * body.reach * Math.sin(robot.heading)];
    this.path(c, [nose, [nose[0] + 0.4 * body.reach * Math.cos(gaze), nose[1] + 0.4 * body.reach * Math.sin(gaze)]]);
    c.strokeStyle = "#fff";
    c.lineWidth = Math.max(2 * this.ratio, 0.12 * body.reach * this.scale);
    c.stroke();
    c.fillStyle = "#fff";
    c.font = `700 ${Math.max(9 * this.ratio, 0.75 * body.reach * this.scale)}px system-ui, sans-serif`;
    c.textAlign = "center";
    c.textBaseline = "middle";
    c.fillText(robot.fallen ? `${robot.number}↯` : String(robot.number), this.px(robot.x), this.py(robot.y));
  }

  label(c, at, words, colour, align = "left", right = 8, down = -8) {
    c.font = `${11 * this.ratio}px system-ui, sans-serif`;
    c.textAlign = align;
    c.lineWidth = 3 * this.ratio;
    c.strokeStyle = INK;
    c.fillStyle = colour;
    const x = this.px(at.x) + right * this.ratio, y = this.py(at.y) + down * this.ratio;
    c.strokeText(words, x, y);
    c.fillText(words, x, y);
  }

  // Return the robot under a place of the field, or -1.
  robotAt(time, { x, y }) {
    const near = Math.max(1.6 * this.recording.body.reach, (22 * this.ratio) / this.scale);
    let found = -1, least = near;
    for (const robot of this.recording.at(time).robots) {
      const away = Math.hypot(robot.x - x, robot.y - y);
      if (robot.active && away < least) [found, least] = [robot.r, away];
    }
    return found;
  }
}
