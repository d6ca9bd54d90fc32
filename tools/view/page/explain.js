// What `kreda explain` says of a pixel, and its directions drawn at the point.

const COLORS = { n: '#2f7de1', v: '#1d9a52', l: '#e0a000', h: '#c23fb0', r: '#d6452b' };
const SVG = 'http://www.w3.org/2000/svg';

function shape(tag, attributes, text) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (text) made.textContent = text;
  return made;
}

/** Arrows with their letters over a picture of this size; those of several lights have the light's number. */
export function drawVectors(svg, vectors, width, height) {
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  const seen = {};
  const shapes = vectors.filter(({ from, to }) => from && to).flatMap(({ name, of, from, to }) => {
    seen[name] = (seen[name] ?? -1) + 1;
    const letter = of && vectors.filter((v) => v.name === name).length > 1 ? name + seen[name] : name;
    const unit = height / 360;
    const line = { x1: from[0], y1: from[1], x2: to[0], y2: to[1] };
    return [
      shape('line', { ...line, stroke: '#fffc', 'stroke-width': 4 * unit }),
      shape('line', { ...line, stroke: COLORS[name], 'stroke-width': 2 * unit }),
      shape('circle', { cx: to[0], cy: to[1], r: 3 * unit, fill: COLORS[name] }),
      shape('text', { x: to[0] + 5 * unit, y: to[1], fill: COLORS[name], 'font-size': 15 * unit, 'stroke-width': 3 * unit }, letter),
    ];
  });
  svg.replaceChildren(...shapes);
}

/** A cross at a pixel, for whoever chooses it with keys. */
export function drawCross(svg, x, y, width, height) {
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  const arm = height / 40, at = [x + 0.5, y + 0.5];
  svg.replaceChildren(...['#fff', '#000'].flatMap((stroke, i) => [
    shape('line', { x1: at[0] - arm, x2: at[0] + arm, y1: at[1], y2: at[1], stroke, 'stroke-width': (2 - i) * height / 360 }),
    shape('line', { x1: at[0], x2: at[0], y1: at[1] - arm, y2: at[1] + arm, stroke, 'stroke-width': (2 - i) * height / 360 }),
  ]));
}
