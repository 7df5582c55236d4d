// Text and lines over the picture: readout, legend, axes, scale bar.

const INK = "#22262b";
const SOFT = "#59616b";

/** Pages narrower than this have the legend below. */
const NARROW = 620;
/** Width of a legend. */
const LEGEND = 216;
/** Between cards. */
const GAP = 8;

/** Draws all of it on a context whose unit is a pixel of the page. */
function drawInk(ink, view, frame, [width, height]) {
  ink.clearRect(0, 0, width, height);
  ink.textBaseline = "middle";
  const narrow = width < NARROW;
  if (!narrow) {
    panel(ink, view.readout(frame), 12, 12);
    drawLegends(ink, view.legends(), [width - LEGEND - 12, 12], view);
  }
  if (narrow) drawAxes(ink, view.camera.axes(), width - 44, 44);
  else drawAxes(ink, view.camera.axes(), 44, height - 44);
  drawScaleBar(ink, view, width, height);
}

/** Legends one below the other. */
function drawLegends(ink, legends, [x, top], view) {
  let y = top;
  for (const legend of legends) {
    const height = legendHeight(legend);
    drawLegend(ink, legend, x, y, height, view);
    y += height + GAP;
  }
}

/** Height of readout and legends below the picture of a narrow page. */
function heightBelow(view, frame) {
  const legends = view.legends().map((legend) => legendHeight(legend) + GAP);
  return panelHeight(view.readout(frame)) + GAP + legends.reduce((sum, one) => sum + one, 0);
}

/** The readout, then the legends. */
function drawBelow(ink, view, frame, [width, height]) {
  ink.clearRect(0, 0, width, height);
  ink.textBaseline = "middle";
  const lines = view.readout(frame);
  panel(ink, lines, 0, 0);
  drawLegends(ink, view.legends(), [0, panelHeight(lines) + GAP], view);
}

function legendHeight(legend) {
  const rows = legend.rods ? 3 : (legend.kinds ? legend.kinds.length : 2) + legend.marked.length;
  return 34 + 21 * rows;
}

function font(ink, size, weight = "") {
  ink.font = `${weight} ${size}px system-ui, "DejaVu Sans", sans-serif`;
}

/** A light card behind text. */
function card(ink, x, y, width, height) {
  ink.fillStyle = "rgba(255,255,255,0.86)";
  ink.beginPath();
  ink.roundRect(x, y, width, height, 6);
  ink.fill();
}

function panelHeight(lines) {
  return 20 * lines.length + 10;
}

function panel(ink, lines, x, y) {
  font(ink, 13);
  const width = Math.max(...lines.map((text) => ink.measureText(text).width)) + 20;
  card(ink, x, y, width, panelHeight(lines));
  ink.fillStyle = INK;
  ink.textAlign = "left";
  lines.forEach((text, k) => ink.fillText(text, x + 10, y + 15 + 20 * k));
}

function drawLegend(ink, legend, left, top, height, view) {
  const wide = LEGEND;
  const title = legend.rods ? "normal force of a contact" : legend.label;
  card(ink, left, top, wide, height);
  font(ink, 13, "600");
  ink.fillStyle = INK;
  ink.textAlign = "left";
  const unit = legend.unit ? ` [${legend.unit}]` : "";
  ink.fillText(title + (legend.rods ? "" : unit), left + 10, top + 16, wide - 20);
  font(ink, 12);
  let y = top + 40;
  if (legend.rods) drawRodLegend(ink, legend, left + 10, y, view);
  else {
    if (legend.kinds) for (const kind of legend.kinds) y = drawKind(ink, kind, left + 10, y);
    else y = drawRamp(ink, legend, left + 10, y, wide - 20);
    for (const kind of legend.marked) y = drawKind(ink, kind, left + 10, y);
  }
}

function drawKind(ink, { name, color }, x, y) {
  ink.fillStyle = color;
  ink.strokeStyle = "#00000055";
  ink.beginPath();
  ink.arc(x + 7, y, 6.5, 0, 7);
  ink.fill();
  ink.stroke();
  ink.fillStyle = INK;
  ink.textAlign = "left";
  ink.fillText(name, x + 21, y);
  return y + 21;
}

function drawRamp(ink, { ramp, scale }, x, y, width) {
  const lengthOf = (text) => ink.measureText(text).width;
  ramp.forEach((color, k) => {
    ink.fillStyle = color;
    ink.fillRect(x + (k * width) / ramp.length, y - 7, width / ramp.length + 0.6, 13);
  });
  const round = (value) => Number(value.toPrecision(2));
  const [low, high] = [round(scale.low), round(scale.high)];
  const middle = round(scale.logarithmic ? Math.sqrt(low * high) : 0.5 * (low + high));
  const shown = (number) => (scale.whole ? String(Math.round(number)) : digits(number));
  const left = (scale.logarithmic ? "≤ " : "") + shown(low);
  const right = (scale.whole ? "" : "≥ ") + shown(high);
  ink.fillStyle = INK;
  ink.textAlign = "left";
  ink.fillText(left, x, y + 18);
  ink.textAlign = "right";
  ink.fillText(right, x + width, y + 18);
  // The number in the middle, where it has room.
  ink.textAlign = "center";
  const [beside, own] = [Math.max(...[left, right].map(lengthOf)), lengthOf(shown(middle))];
  if (!scale.whole && beside + own / 2 + 6 < width / 2) ink.fillText(shown(middle), x + width / 2, y + 18);
  return y + 42;
}

function drawRodLegend(ink, { full, thickness, radius, unit }, x, y, view) {
  const { canvas, camera } = view;
  const ratio = canvas.width / Math.max(1, canvas.clientWidth);
  const pixels = (camera.scale(canvas.width, canvas.height) / ratio) * radius * 2;
  const samples = [["pushes", PUSH, false], ["pulls, with bands", PULL, true]];
  for (const [name, color, bands] of samples) {
    ink.fillStyle = `rgb(${color})`;
    ink.fillRect(x, y - 3.5, 34, 7);
    ink.fillStyle = "rgba(255,255,255,0.55)";
    if (bands) for (const at of [6, 17, 28]) ink.fillRect(x + at, y - 3.5, 4.5, 7);
    ink.fillStyle = INK;
    ink.fillText(name, x + 42, y);
    y += 21;
  }
  ink.fillStyle = SOFT;
  ink.fillRect(x, y - Math.min(pixels, 18) / 2, 34, Math.min(pixels, 18));
  ink.fillStyle = INK;
  ink.fillText(`so thick: ${digits(Number((full / thickness).toPrecision(2)))} ${unit}`, x + 42, y);
}

/** Where x, y and z point. */
function drawAxes(ink, { right, up, toward }, x, y) {
  card(ink, x - 36, y - 36, 72, 72);
  const axes = ["x", "y", "z"].map((name, k) => ({ name, dx: 24 * right[k], dy: -24 * up[k], near: toward[k] }));
  axes.sort((a, b) => a.near - b.near);
  font(ink, 12, "600");
  ink.textAlign = "center";
  for (const { name, dx, dy } of axes) {
    ink.strokeStyle = SOFT;
    ink.lineWidth = 1.8;
    ink.beginPath();
    ink.moveTo(x, y);
    ink.lineTo(x + dx, y + dy);
    ink.stroke();
    const far = Math.hypot(dx, dy) || 1;
    ink.fillStyle = INK;
    ink.fillText(name, x + dx * (1 + 8 / Math.max(far, 8)), y + dy * (1 + 8 / Math.max(far, 8)));
  }
  ink.lineWidth = 1;
}

/** A length of 1, 2 or 5 times a power of ten that is about a seventh of the picture. */
function drawScaleBar(ink, view, width, height) {
  const { canvas, camera, meta } = view;
  const scale = camera.scale(canvas.width, canvas.height) * (width / canvas.width);
  const wanted = width / 7 / scale;
  const decade = 10 ** Math.floor(Math.log10(wanted));
  const length = [5, 2, 1].map((k) => k * decade).find((candidate) => candidate <= wanted) || decade;
  const [x, y] = [width - 24 - length * scale, height - 22];
  card(ink, x - 12, y - 22, length * scale + 24, 34);
  ink.fillStyle = INK;
  ink.fillRect(x, y, length * scale, 2.5);
  ink.fillRect(x, y - 4, 1.5, 10);
  ink.fillRect(x + length * scale - 1.5, y - 4, 1.5, 10);
  font(ink, 12);
  ink.textAlign = "center";
  ink.fillText(`${digits(length)} ${meta.units.length}`, x + (length * scale) / 2, y - 11);
}
