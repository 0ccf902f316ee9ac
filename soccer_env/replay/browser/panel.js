// The list of events and the record of the robot that was picked. All words are set as text, never as markup.

function element(name, words = "", kind = "") {
  const made = document.createElement(name);
  made.textContent = words;
  if (kind) made.className = kind;
  return made;
}

function facts(pairs) {
  const list = element("dl");
  for (const [name, value] of pairs) list.append(element("dt", name), element("dd", value));
  return list;
}

const NAMES = { stuck: "stuck for", tries: "recoveries tried", left: "of recovery left", wriggle: "wriggles for", back_off: "backs off for" };
const metres = (from, to) => `${Math.hypot(from.x - to.x, from.y - to.y).toFixed(2)} m`;
const yes = (flag) => (flag ? "yes" : "no");

// Return how far a robot's belief is from the truth, as pairs of words.
function beliefOf(recording, thought, time) {
  const moment = recording.at(thought.step), robot = moment.robots[thought.robot];
  const turn = Math.atan2(Math.sin(thought.own.heading - robot.heading), Math.cos(thought.own.heading - robot.heading));
  const pairs = [["itself", `${metres(robot, thought.own)}, ${Math.abs((turn * 180) / Math.PI).toFixed(0)}° off, confidence ${thought.own.confidence.toFixed(0)}`]];
  if (thought.own.spread > 0) pairs.push(["possible poses", `within ${(2 * thought.own.spread).toFixed(2)} m`]);
  const age = thought.ball.age > 300 ? "never seen" : `seen ${thought.ball.age.toFixed(1)} s ago`;
  pairs.push(["ball", `${metres(moment.ball, thought.ball)} off, confidence ${thought.ball.confidence.toFixed(0)}, ${age}`]);
  const mates = thought.players.filter((player) => player.mate).length;
  pairs.push(["players", `${mates} team-mates, ${thought.players.length - mates} opponents`]);
  return pairs;
}

// Return what a field of a team's memory is called.
function called(path) {
  const name = path.split(".").pop();
  return NAMES[name] || name.replaceAll("_", " ");
}

function decision(thought) {
  const words = thought.memory.filter((field) => field.word !== undefined).map((field) => field.word);
  const longer = (word) => words.some((other) => other !== word && other.startsWith(word));
  return [...new Set(words.filter((word) => !longer(word)))].join(", ");
}

function showRecord(panel, recording, r, time, moment) {
  panel.replaceChildren();
  if (r < 0) {
    panel.append(element("p", "Tap a robot to see what it sees, believes and decides."));
    return;
  }
  const robot = moment.robots[r], thought = recording.thought(r, time);
  panel.append(element("h2", recording.name(r)));
  const states = [!robot.active && "off the field", robot.hasBall && "has the ball", robot.fallen && "fallen", robot.kicks && "kicks"];
  panel.append(element("p", states.filter(Boolean).join(", ") || "plays"));
  if (!thought) {
    panel.append(element("p", recording.notes ? "Nothing is known of what it thinks." : "This replay keeps no thoughts: soccer record does."));
    return;
  }
  thought.robot = r;
  const meant = decision(thought);
  panel.append(element("h3", "decides"));
  if (meant) panel.append(element("p", meant, "strong"));
  const numbers = thought.memory.filter((field) => field.word === undefined);
  panel.append(facts([...numbers.map(({ name, number }) => [called(name), String(number)]),
    ["command", thought.command.filter(([, value]) => Math.abs(value) >= 0.05).map(([name, value]) => `${name} ${value.toFixed(1)}`).join(", ") || "stand"]]));
  if (!thought.knows) return;
  panel.append(element("h3", "believes"), facts(beliefOf(recording, thought, time)));
  const { saw, seen } = thought;
  panel.append(element("h3", "sees"), facts([["ball", yes(saw.ball)], ["own goal", yes(saw.own_goal)], ["other goal", yes(saw.opponent_goal)],
    ["players", String(seen.players)], [recording.body.legs ? "landmarks" : "lines", String(seen.marks)],
    ...(recording.body.legs ? [["infrared", seen.infrared > 0 ? `${seen.infrared.toFixed(2)} m` : "nothing"]] : [])]));
  const picture = cameraPicture(recording, robot, moment, thought);
  if (picture) panel.append(picture);
}

// The picture of the camera with a box for each blob in it, or null where nothing of it was noted.
function cameraPicture(recording, robot, moment, thought) {
  if (!thought.more.head || !(recording.image[0] > 0)) return null;
  const canvas = element("canvas"), [width, height] = recording.image, zoom = 2, c = canvas.getContext("2d");
  [canvas.width, canvas.height] = [zoom * width, zoom * height];
  canvas.setAttribute("aria-label", "blobs in the picture of its camera");
  c.fillStyle = "#10161d";
  c.fillRect(0, 0, canvas.width, canvas.height);
  const seen = new Overlays(window.player.pitch, c, moment), tints = seen.tints(robot);
  for (const [name, boxes] of Object.entries(seen.blobs(robot, thought.more)))
    for (const { left, right, high, low } of boxes) {
      c.fillStyle = tints[name];
      c.fillRect(zoom * (width / 2 - left), zoom * (height / 2 - high), Math.max(2, zoom * (left - right)), Math.max(2, zoom * (high - low)));
    }
  return canvas;
}

// What the scorer thought at the last note before a goal.
function scorerThought(recording, [step, kind, , r]) {
  if (kind !== "goal" || r < 0) return "";
  const thought = recording.thought(r, step - 1);
  if (!thought) return "";
  thought.robot = r;
  const meant = decision(thought), moment = recording.at(thought.step);
  const parts = [meant && `decided: ${meant}`, thought.knows && `believed the ball ${metres(moment.ball, thought.ball)} from where it was, itself ${metres(moment.robots[r], thought.own)}`];
  return parts.filter(Boolean).join("; ");
}

function fillEvents(list, recording, withKicks, jump) {
  list.replaceChildren();
  recording.events.forEach((event) => {
    const [step, kind, , , words] = event;
    if (kind === "kick" && !withKicks) return;
    const button = element("button", "", kind), text = element("span", words), item = element("li");
    const belief = scorerThought(recording, event);
    if (belief) text.append(element("small", belief));
    button.append(element("time", minutes(step / recording.rate)), text);
    button.dataset.step = step;
    button.addEventListener("click", () => jump(event));
    item.append(button);
    list.append(item);
  });
  if (!list.children.length) list.append(element("li", "nothing happened"));
}

function markEvents(list, time) {
  let now = null;
  for (const button of list.querySelectorAll("button")) {
    button.classList.remove("now");
    if (Number(button.dataset.step) <= time) now = button;
  }
  if (now) now.classList.add("now");
}
