// Search and sliders. Everything else of the site works without a script.
'use strict';
(() => {
  const form = document.querySelector('form.search');
  const root = document.querySelector('script[src$="site.js"]').getAttribute('src').replace('site.js', '');
  const fold = (text) => text.normalize('NFD').replace(/[\u0300-\u036f]/g, '').toLowerCase();

  if (form && window.kredaIndex) {
    form.hidden = false;
    const input = form.querySelector('input');
    const hits = form.querySelector('.hits');
    const entries = window.kredaIndex.map((e) => ({ ...e, ft: fold(e.t), fx: fold(e.x) }));
    const score = (entry, word) =>
      entry.ft === word ? 9 : entry.ft.startsWith(word) ? 6 : entry.ft.includes(word) ? 4 : entry.fx.includes(word) ? 1 : 0;
    const search = () => {
      const words = fold(input.value).split(/\s+/).filter(Boolean);
      const found = words.length === 0 ? [] : entries
        .map((entry) => ({ entry, points: words.map((w) => score(entry, w)) }))
        .filter(({ points }) => points.every((p) => p > 0))
        .map(({ entry, points }) => ({ entry, sum: points.reduce((a, b) => a + b, 0) }))
        .sort((a, b) => b.sum - a.sum).slice(0, 12);
      hits.replaceChildren(...found.map(({ entry }) => {
        const item = document.createElement('li');
        const link = document.createElement('a');
        const kind = document.createElement('span');
        link.href = root + entry.u;
        link.textContent = entry.t;
        kind.textContent = entry.k;
        link.append(' ', kind);
        item.append(link);
        return item;
      }));
      hits.hidden = found.length === 0;
    };
    hits.hidden = true;
    input.addEventListener('input', search);
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      const first = hits.querySelector('a');
      if (first) location.href = first.href;
    });
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') hits.hidden = true;
      if (event.key === '/' && !/^(INPUT|TEXTAREA)$/.test(document.activeElement.tagName)) {
        event.preventDefault();
        input.focus();
      }
    });
    document.addEventListener('click', (event) => { if (!form.contains(event.target)) hits.hidden = true; });
  }

  // A live figure stands open, and is loaded when it is nearly seen.
  const load = (frame) => { if (!frame.src) frame.src = frame.dataset.src; };
  const near = new IntersectionObserver((seen) => {
    for (const { isIntersecting, target } of seen) if (isIntersecting) load(target);
  }, { rootMargin: '200px' });
  for (const figure of document.querySelectorAll('details.live')) {
    figure.open = true;
    near.observe(figure.querySelector('iframe'));
  }

  // Two pictures side by side become one with a handle.
  for (const pair of document.querySelectorAll('.pair')) {
    const [before, after] = pair.querySelectorAll('figure');
    const range = document.createElement('input');
    range.type = 'range';
    range.value = 50;
    range.setAttribute('aria-label', `left: ${before.textContent.trim()}, right: ${after.textContent.trim()}`);
    const place = () => pair.style.setProperty('--cut', `${range.value}%`);
    range.addEventListener('input', place);
    pair.classList.add('slider');
    pair.append(range);
    place();
  }
})();
