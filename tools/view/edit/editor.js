// A field for code: numbers of the lines, and complaints at theirs.

/** The complaints of clang about the reader's file: [{line, column, kind, text}]. */
export function complaintsOf(printed) {
  return [...printed.matchAll(/^\/given\/reader\.cpp:(\d+):(\d+): (fatal error|error|warning): (.*)$/gm)]
    .map(([, line, column, kind, text]) => ({ line: Number(line), column: Number(column), kind, text }));
}

export class Editor {
  constructor(code, lines, marks, actions) {
    Object.assign(this, { code, lines, marks, complaints: [], leaves: false });
    code.addEventListener('input', () => { this.complaints = []; this.show(); });
    code.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) { event.preventDefault(); actions.test(); }
      if (event.key === 'Tab' && !event.shiftKey && !this.leaves) {
        event.preventDefault();
        document.execCommand('insertText', false, '    '); // keeps the field's own undo
      }
      this.leaves = event.key === 'Escape';
    });
  }

  get text() { return this.code.value; }

  set text(text) {
    this.code.value = text;
    this.complaints = [];
    this.show();
  }

  complain(complaints) {
    this.complaints = complaints;
    this.show();
  }

  show() {
    const rows = this.code.value.split('\n');
    const at = new Map(this.complaints.slice().reverse().map((c) => [c.line, c]));
    const bad = (i) => (at.has(i + 1) ? `<span class="bad">${i + 1}</span>` : `${i + 1}`);
    this.lines.innerHTML = rows.map((_, i) => bad(i)).join('\n');
    this.code.rows = rows.length;
    this.code.style.height = `calc(${rows.length} * var(--row) + 16px)`;
    this.code.style.width = `${Math.max(40, ...rows.map((row) => row.length)) + 4}ch`;
    this.marks.replaceChildren(...[...at.values()].map(({ line, text }) => {
      const mark = document.createElement('i'), words = document.createElement('b');
      mark.style.top = `calc(${line - 1} * var(--row) + 8px)`;
      words.style.left = `${(rows[line - 1] ?? '').length + 1}ch`;
      words.textContent = text;
      mark.append(words);
      return mark;
    }));
  }
}
