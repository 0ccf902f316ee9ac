// The potential field of a robot, computed by its team: see fields.py. Nothing is computed here.

const WEAK = [126, 190, 140], STRONG = [255, 236, 130]; // colours and lengths of arrows as in the pictures

class Fields {
  constructor(about, steps, bytes) {
    Object.assign(this, about);
    this.steps = steps;
    this.points = about.across * about.up;
    this.starts = [];
    let start = 0;
    for (const every of about.every) {
      this.starts.push(start);
      start += Fields.frames(steps, every) * this.points;
    }
    this.codes = bytes;
  }

  static frames(steps, every) { return Math.ceil(steps.length / every); }

  static bytes({ across, up, every }, steps) {
    return across * up * every.reduce((sum, one) => sum + Fields.frames(steps, one), 0);
  }

  // Return step and bytes of the frame of robot r nearest to a time; null without a frame.
  frame(r, time) {
    const place = this.robots.indexOf(r);
    if (place < 0 || !this.steps.length) return null;
    const every = this.every[place], early = Math.floor(Math.max(0, upTo(this.steps, time) - 1) / every);
    const late = Math.min(early + 1, Fields.frames(this.steps, every) - 1), step = (at) => this.steps[at * every];
    const at = Math.abs(step(late) - time) < Math.abs(step(early) - time) ? late : early;
    const start = this.starts[place] + at * this.points, codes = this.codes.subarray(start, start + this.points);
    return codes.some((code) => code > 0) ? { step: step(at), codes } : null;
  }

  // Return the arrows of robot r at a time: [x, y of the middle, angle, share].
  arrows(r, time, { length, width }) {
    const frame = this.frame(r, time), found = [];
    if (!frame) return found;
    frame.codes.forEach((code, at) => {
      if (code === 0) return;
      const x = ((at % this.across) + 0.5) * (length / this.across) - length / 2;
      const y = (Math.floor(at / this.across) + 0.5) * (width / this.up) - width / 2;
      const direction = Math.floor((code - 1) / this.levels), level = (code - 1) % this.levels;
      found.push([x, y, (2 * Math.PI * direction) / this.directions, (level + 0.5) / this.levels]);
    });
    return found;
  }

  draw(c, pitch, r, time) {
    const field = pitch.recording.pitch, cell = (field.length / this.across) * pitch.scale;
    const thick = Math.min(0.95 * pitch.ratio, 0.05 * cell), inks = new Map();
    for (const [x, y, angle, share] of this.arrows(r, time, field)) {
      const half = 0.5 * cell * (0.25 + 0.7 * share), head = Math.min(5.6 * thick, 1.2 * half);
      const ahead = [Math.cos(angle), -Math.sin(angle)], middle = [pitch.px(x), pitch.py(y)];
      const at = (along, aside) => [middle[0] + along * ahead[0] - aside * ahead[1], middle[1] + along * ahead[1] + aside * ahead[0]];
      if (!inks.has(share)) inks.set(share, new Path2D());
      const neck = half - head, ink = inks.get(share);
      [[-half, thick], [neck, thick], [neck, 0.42 * head], [half, 0], [neck, -0.42 * head], [neck, -thick], [-half, -thick]]
        .forEach(([along, aside], corner) => (corner ? ink.lineTo(...at(along, aside)) : ink.moveTo(...at(along, aside))));
      ink.closePath();
    }
    for (const [share, ink] of inks) {
      c.fillStyle = `rgb(${WEAK.map((weak, part) => Math.round(weak + share * (STRONG[part] - weak))).join()})`;
      c.fill(ink);
    }
  }
}
