// The time line: marks of events, the team of the last touch, and the position of the ball along the field.

const MARKS = { goal: "★", penalty: "☆", foul: "▲", restart: "•", half: "‖", kick: "" };
const LANES = { marks: 0.3, possession: 0.18 }; // of the height; the rest is the ball's

class TimeLine {
  constructor(canvas, recording) {
    this.canvas = canvas;
    this.recording = recording;
  }

  resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2.5), box = this.canvas.getBoundingClientRect();
    this.ratio = ratio;
    this.canvas.width = Math.max(1, Math.round(box.width * ratio));
    this.canvas.height = Math.max(1, Math.round(box.height * ratio));
    this.still = document.createElement("canvas");
    this.still.width = this.canvas.width;
    this.still.height = this.canvas.height;
    this.drawStill(this.still.getContext("2d"));
  }

  px(step) { return (step / Math.max(1, this.recording.last)) * this.canvas.width; }

  // Return the time of a pointer.
  time(event) {
    const box = this.canvas.getBoundingClientRect();
    return Math.min(Math.max((event.clientX - box.left) / box.width, 0), 1) * this.recording.last;
  }

  drawStill(c) {
    const style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue(name).trim();
    const high = c.canvas.height, wide = c.canvas.width, top = LANES.marks * high, middle = top + LANES.possession * high;
    const teams = [colour("--home"), colour("--away")], { recording } = this, rows = recording.rows;
    c.clearRect(0, 0, wide, high);
    for (let x = 0; x < wide; x += 2) {
      const row = Math.min(rows - 1, Math.floor((x / wide) * rows)), touch = recording.value("touch", row);
      if (touch >= 0 && touch < recording.robots.length) {
        c.fillStyle = teams[recording.robots[touch][0]];
        c.fillRect(x, top + 0.15 * (middle - top), 2, 0.7 * (middle - top));
      }
    }
    this.drawBall(c, middle, high, colour);
    c.textAlign = "center";
    c.textBaseline = "middle";
    for (const [step, kind, team] of recording.events) {
      const x = Math.min(Math.max(this.px(step), 7 * this.ratio), wide - 7 * this.ratio);
      c.fillStyle = team >= 0 ? teams[team] : colour("--dim");
      if (kind === "kick") c.fillRect(this.px(step), 0.8 * top, Math.max(1, 0.8 * this.ratio), 0.2 * top);
      else {
        c.font = `${(kind === "goal" ? 18 : 12) * this.ratio}px system-ui, sans-serif`;
        c.fillText(MARKS[kind], x, 0.42 * top);
      }
    }
  }

  drawBall(c, top, bottom, colour) {
    const { recording } = this, half = recording.pitch.length / 2, wide = c.canvas.width;
    const py = (x) => (top + bottom) / 2 - Math.min(Math.max(x / half, -1.1), 1.1) * 0.44 * (bottom - top);
    c.strokeStyle = colour("--line");
    c.lineWidth = this.ratio;
    for (const x of [-half, 0, half]) c.strokeRect(0, py(x), wide, 0);
    c.strokeStyle = colour("--ball");
    c.lineWidth = 1.3 * this.ratio;
    c.beginPath();
    for (let x = 0; x <= wide; x++) {
      const row = Math.min(recording.rows - 1, Math.floor((x / wide) * recording.rows));
      c.lineTo(x, py(recording.value("ball_x", row) / 1e3));
    }
    c.stroke();
  }

  draw(time) {
    const c = this.canvas.getContext("2d");
    c.clearRect(0, 0, this.canvas.width, this.canvas.height);
    c.drawImage(this.still, 0, 0);
    c.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--ink");
    c.fillRect(this.px(time) - this.ratio, 0, 2 * this.ratio, this.canvas.height);
  }
}
