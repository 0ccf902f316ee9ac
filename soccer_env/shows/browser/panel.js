// The list of events and the record of the selected robot. All words are set as text, never as markup.

function element(name, words = "", kind = "") {
  const made = document.createElement(name);
  made.textContent = words;
  if (kind) made.className = kind;
  return made;
}

// Keep a number and its unit on one line.
const tied = (words) => words.replace(/(\d) (?=(m|s|%)(?![a-z]))/g, "$1\u00a0");

function facts(pairs) {
  const list = element("dl");
  for (const [name, value] of pairs) list.append(element("dt", name), element("dd", tied(value)));
  return list;
}

const NAMES = { stuck: "stuck for", tries: "recoveries tried", left: "of recovery left", wriggle: "wriggles for", back_off: "backs off for" };
const metres = (from, to) => `${Math.hypot(from.x - to.x, from.y - to.y).toFixed(2)} m`;
const yes = (flag) => (flag ? "yes" : "no");
const NEVER = 300; // [s] a ball that was not seen for longer was never seen
const sureOf = (belief) => `${belief.confidence.toFixed(0)} % sure`;
const offBy = (truth, belief) => `wrong by ${metres(truth, belief)}`;
const agoOf = (age) => (age < 0.05 ? "just then" : `${age.toFixed(1)} s before`);
const COMMANDS = { forward: ["forward", "back"], left: ["to the left", "to the right"], turn: ["turn left", "turn right"], kick: ["kick", ""] };

// Return the distance and direction of a thing from a pose.
function placeOf(thing, pose) {
  const angle = Math.atan2(thing.y - pose.y, thing.x - pose.x) - pose.heading, turns = Math.round((2 * angle) / Math.PI);
  return `${metres(thing, pose)} ${["ahead", "to its left", "behind it", "to its right"][((turns % 4) + 4) % 4]}`;
}

// Return the error of a believed heading in degrees, or "" if it is small.
function turnedBy(truth, belief) {
  const turn = Math.atan2(Math.sin(belief.heading - truth.heading), Math.cos(belief.heading - truth.heading));
  const degrees = Math.abs((turn * 180) / Math.PI);
  return degrees < 5 ? "" : ` and ${degrees.toFixed(0)}°`;
}

// Return the command of a robot, in shares of its top speeds and of its strongest kick.
function commandOf(thought) {
  const said = thought.command.filter(([, value]) => Math.abs(value) >= 0.05).map(([name, value]) => {
    const word = COMMANDS[name][value > 0 ? 0 : 1];
    return word && `${word} ${Math.abs(100 * value).toFixed(0)} %`;
  });
  return said.filter(Boolean).join(", ") || "stand";
}

// Return a robot's beliefs and their errors, as pairs of words.
function beliefOf(recording, thought) {
  const moment = recording.at(thought.step), robot = moment.robots[thought.robot], { own, ball } = thought;
  const pairs = [["itself", `${sureOf(own)}, ${offBy(robot, own)}${turnedBy(robot, own)}`]];
  if (own.spread > 0) pairs.push(["possible poses", `within ${(2 * own.spread).toFixed(2)} m`]);
  pairs.push(["ball", ball.age > NEVER ? "never seen" : `${sureOf(ball)}, ${offBy(moment.ball, ball)}, sensed ${ball.age < 0.05 ? "now" : `${ball.age.toFixed(1)} s ago`}`]);
  const mates = thought.players.filter((player) => player.mate).length;
  pairs.push(["players", `${mates} team-mates, ${thought.players.length - mates} opponents`]);
  return pairs;
}

// Return the name of a field of a team's memory.
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
  if (!robot.active) return;
  if (!thought) {
    panel.append(element("p", recording.notes ? "Nothing is known of what it thinks." : "This replay keeps no thoughts: soccer record does."));
    return;
  }
  thought.robot = r;
  const meant = decision(thought);
  panel.append(element("h3", "decides"));
  if (meant) panel.append(element("p", meant, "strong"));
  const numbers = thought.memory.filter((field) => field.word === undefined && field.number !== 0);
  panel.append(facts([...numbers.map(({ name, number }) => [called(name), String(number)]), ["command", commandOf(thought)], ...fieldOf(recording, r, time)]));
  if (!thought.knows) return;
  panel.append(element("h3", "believes"), facts(beliefOf(recording, thought)));
  const { saw, seen } = thought;
  panel.append(element("h3", "sees"), facts([["ball", saw.ball || recording.body.legs || thought.ball.age >= 0.05 ? yes(saw.ball) : "no: it is at the kicker's light barrier"], ["own goal", yes(saw.own_goal)], ["other goal", yes(saw.opponent_goal)],
    ["players", String(seen.players)], [recording.body.legs ? "landmarks" : "lines", String(seen.marks)],
    ...(recording.body.legs ? [["infrared", seen.infrared > 0 ? `${seen.infrared.toFixed(2)} m` : "nothing"]] : [])]));
  const picture = cameraPicture(recording, robot, moment, thought);
  if (picture) panel.append(picture);
}

// Return why there are no forces to draw for a robot, as a pair of words; nothing where there are.
function fieldOf(recording, r, time) {
  const fields = recording.pulls;
  if (!fields || fields.frame(r, time)) return [];
  return [["field", fields.robots.includes(r) ? "none now: it plans no way" : "its team computes no forces"]];
}

// Return the picture of the camera with a box for each blob, or null if it was not noted.
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

// Return beliefs and decision of a goal's scorer at the last note before it played the ball, as pairs of words.
function scorerThought(recording, [, , team, r, , goal]) {
  if (r < 0 || !recording.notes) return [];
  const thought = recording.thought(r, recording.noteBefore(goal.played));
  if (!thought) return [["belief", "none: it is not known what it thinks"]];
  const moment = recording.at(thought.step), robot = moment.robots[r], { own, ball } = thought, pairs = [];
  if (thought.knows) {
    const side = (moment.direction > 0) === (team === 0) ? 1 : -1, which = robot.team === team ? "the goal" : "its own goal";
    const away = Math.hypot((side * recording.pitch.length) / 2 - own.x, own.y);
    pairs.push(["ball", ball.age > NEVER ? "never seen" : `${placeOf(ball, own)} (${offBy(moment.ball, ball)}), ${sureOf(ball)}, sensed ${agoOf(ball.age)}`]);
    pairs.push(["itself", `${away.toFixed(1)} m from ${which} (${offBy(robot, own)}${turnedBy(robot, own)}), ${sureOf(own)}`]);
  } else pairs.push(["belief", "none: it is played from outside"]);
  pairs.push(["decided", [roleOf(thought, robot.keeper), commandOf(thought)].filter(Boolean).join("; ")]);
  if (goal.kick !== null) pairs.push(["then", `kick ${(100 * goal.kick).toFixed(0)} %`]);
  return pairs;
}

// Return the time of a scorer's beliefs, in words.
function askedWhen(recording, { how, played }) {
  const verb = /kick/.test(how) ? "it kicked" : "it played the ball";
  if (!recording.notes) return "what it believed is not in this replay";
  return `${((played - recording.noteBefore(played)) / recording.rate).toFixed(2)} s before ${verb} it believed`;
}

// A goal: the score after it, the scorer, how it fell, and the scorer's beliefs.
function goalWords(recording, event) {
  const [step, , , r, words, goal] = event, text = element("span");
  const first = element("span", "", "headline"), score = element("b", goal.score.join(" : "));
  const named = r >= 0 ? recording.name(r) : "", at = named ? words.indexOf(named) : -1;
  first.append(score);
  if (at < 0) first.append(` ${words}`);
  else first.append(` ${words.slice(0, at)}`, element("b", named, `of${recording.robots[r][0]}`), words.slice(at + named.length));
  const before = (step - goal.played) / recording.rate;
  text.append(first, element("small", tied(`${goal.how}${before >= 0.15 ? `; in after ${before.toFixed(1)} s` : ""}`)));
  if (r < 0) return text;
  const list = facts(scorerThought(recording, event));
  list.className = "belief";
  text.append(element("small", askedWhen(recording, goal), "asit"), list);
  return text;
}

// The events of the selected kinds: goals, goals and calls, or all with kicks.
function fillEvents(list, recording, asked, jump) {
  const kinds = { goals: ["goal", "penalty", "half"], calls: ["goal", "penalty", "half", "foul", "restart"] }[asked];
  list.replaceChildren();
  recording.events.forEach((event) => {
    const [step, kind, , , words] = event;
    if (kinds && !kinds.includes(kind)) return;
    const button = element("button", "", kind), item = element("li");
    button.append(element("time", minutes(step / recording.rate)), kind === "goal" ? goalWords(recording, event) : element("span", words));
    button.dataset.step = step;
    button.addEventListener("click", () => jump(event));
    item.append(button);
    list.append(item);
  });
  if (!list.children.length) list.append(element("li", "nothing happened"));
}

// Scorers and times of goals, below the name of each team.
function fillScorers(places, recording, jump) {
  places.forEach((place, team) => {
    const goals = recording.events.filter(([, kind, whose]) => kind === "goal" && whose === team);
    for (const scorer of new Set(goals.map(([, , , r]) => r))) {
      const own = scorer >= 0 && recording.robots[scorer][0] !== team;
      const line = element("span", scorer < 0 ? "?" : `${recording.name(scorer)}${own ? ", own goal" : ""}`);
      for (const event of goals.filter(([, , , r]) => r === scorer)) {
        const button = element("button", minutes(event[0] / recording.rate));
        button.addEventListener("click", () => jump(event));
        line.append(" ", button);
      }
      place.append(line);
    }
  });
}

function markEvents(list, time) {
  let now = null;
  for (const button of list.querySelectorAll("button")) {
    button.classList.remove("now");
    if (Number(button.dataset.step) <= time) now = button;
  }
  if (!now) return;
  now.classList.add("now");
  if (list.dataset.now !== now.dataset.step && list.scrollHeight > list.clientHeight) list.scrollTop = now.offsetTop - 4;
  list.dataset.now = now.dataset.step;
}
