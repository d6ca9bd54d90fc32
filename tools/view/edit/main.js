// The page: a function of a lesson is changed, compiled, run on the assignment's scenes and held against Kreda's own.
import { Editor, complaintsOf } from './editor.js';
import { Helper, loadPart, runProgram } from './helpers.js';

const $ = (id) => document.getElementById(id);
const source = (id) => $(id).textContent;
const lesson = JSON.parse(source('lesson')); // number, assignment, title, stages, start, folder
const texts = { lesson: lesson.start, whole: null };
const page = { which: 'lesson', compiler: null, grader: null, assignment: null, result: null, runs: 0, shown: '',
  limit: 1000 }; // milliseconds that a program may run

function say(line, isWrong = false) {
  $('state').textContent = line;
  $('state').classList.toggle('wrong', isWrong);
}

/** The compiler and the assignment, once. */
async function load() {
  if (page.compiler) return;
  say('Loading the compiler ...');
  const part = (name) => loadPart(lesson.folder, name);
  const assignment = await part(lesson.assignment);
  const grader = new Helper(source('grade-worker'));
  const begun = part('grade').then(async (bytes) => {
    const end = bytes.indexOf(0);
    return grader.call('start', new TextDecoder().decode(bytes.subarray(0, end)), bytes.slice(end + 1), assignment);
  });
  const compiler = new Helper(source('compile-worker'));
  const [module, headers] = await Promise.all([part('clang').then((bytes) => WebAssembly.compile(bytes)), part('headers')]);
  await compiler.call('start', module, headers, assignment);
  Object.assign(page, { compiler, grader, assignment: await begun });
}

/** All tables at once; where that ends early, those functions that have no answer alone, as kreda grade does. */
async function runAll(program) {
  const module = await WebAssembly.compile(program);
  const { inputs } = await page.grader.call('inputs');
  const run = async (stage) => {
    const args = ['program', '/inputs.bin', '/outputs.bin', ...(stage ? [stage] : [])];
    const { outputs, why } = await runProgram(source('run-worker'), module, args, inputs, page.limit);
    const { left } = await page.grader.call('answers', outputs, stage, why ? `your program ${why}` : '');
    return { left, why };
  };
  const whole = await run('');
  for (const stage of whole.left) {
    say(`The program ${whole.why || 'did not answer all'}; trying ${stage} alone ...`, true);
    await run(stage);
  }
  return whole;
}

async function test() {
  if ($('test').disabled) return;
  $('test').disabled = true;
  const begin = performance.now();
  try {
    await load();
    say('Compiling ...');
    const compileBegin = performance.now();
    const { printed, program } = await page.compiler.call('compile', editor.text, page.which === 'whole');
    const compiled = performance.now();
    showComplaints(printed);
    let ended = { why: '' };
    if (program) {
      say('Running ...');
      ended = await runAll(program);
    } else await page.grader.call('inputs');
    const seconds = (performance.now() - begin) / 1000;
    const error = program ? '' : `student.cpp does not compile:\n${printed}`;
    showResult(await page.grader.call('result', page.which === 'whole' ? 'student' : `lesson ${lesson.number}`, error, seconds));
    const times = `${((performance.now() - begin) / 1000).toFixed(1)} s, of it compiling ${((compiled - compileBegin) / 1000).toFixed(1)} s`;
    if (!program) say(`It does not compile: see the marked lines. ${times}.`, true);
    else say(ended.why ? `The program ${ended.why} ${times}.` : `Compiled and tested in ${times}.`, Boolean(ended.why));
    console.info(`loaded ${(compileBegin - begin) | 0} ms, compiled ${(compiled - compileBegin) | 0} ms, all ${(performance.now() - begin) | 0} ms`);
  } catch (error) { say(error.message, true); }
  $('test').disabled = false;
  document.documentElement.dataset.runs = page.runs += 1;
}

// ---- what is shown ---------------------------------------------------------------------------------------------------

function showComplaints(printed) {
  editor.complain(complaintsOf(printed));
  $('complaints').hidden = !printed.trim();
  $('complaints').textContent = printed.replaceAll('/given/reader.cpp', 'student.cpp').replaceAll('/given/', '').trim();
}

/** In a lesson: the tests of its functions and of pictures. */
const isShown = (test) => {
  if (page.which === 'whole') return true;
  const stage = page.assignment.tests.find(({ name }) => name === test.name);
  return stage && (lesson.stages.includes(stage.stage) || stage.picture);
};

function showTest(test) {
  const item = document.createElement('li'), name = document.createElement('span'), mark = document.createElement('b');
  mark.className = test.passed ? 'yes' : 'no';
  mark.textContent = test.passed ? '✓ ' : '✗ ';
  name.textContent = `${test.name}: ${test.teaches} (${test.points} of ${test.max_points})`;
  item.append(mark, name);
  if (test.message) {
    const message = document.createElement('p');
    message.textContent = test.message;
    item.append(message);
  }
  return item;
}

function showResult({ file, pictures }) {
  const result = JSON.parse(file), tests = result.tests.filter(isShown);
  const sum = (key) => tests.reduce((total, test) => total + test[key], 0);
  page.result = { file, pictures };
  $('save-result').disabled = page.which !== 'whole';
  $('tests').replaceChildren(...tests.map(showTest));
  $('verdict').textContent = `${sum('points')} of ${sum('max_points')} points${tests.every(({ passed }) => passed) ? ': all is right' : ''}`;
  $('first').textContent = page.which === 'whole' ? result.diagnosis : '';
  if (pictures.length > 0) showScenes(tests);
}

/** The scenes that there are pictures of; the first wrong one is shown, unless another was chosen. */
function showScenes(tests) {
  const names = [...new Set(page.result.pictures.map(({ test }) => test))];
  $('scene').replaceChildren(...names.map((name) => new Option(name.replace(/^\d+ picture: /, ''), name)));
  const wrong = tests.find(({ name, message }) => names.includes(name) && /pixels/.test(message))?.name;
  $('scene').value = names.includes(page.shown) ? page.shown : wrong ?? names[0] ?? '';
  showPictures();
}

const CAPTION = { student: 'yours', expected: 'expected', difference: 'difference' };
function showPictures() {
  $('shown').replaceChildren(...page.result.pictures.filter(({ test }) => test === $('scene').value).map(({ label, png }) => {
    const figure = document.createElement('figure'), image = new Image(), caption = document.createElement('figcaption');
    image.src = `data:image/png;base64,${png}`;
    image.alt = caption.textContent = CAPTION[label] ?? label;
    figure.append(image, caption);
    return figure;
  }));
}

function save(text, name, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function choose(which) {
  texts[page.which] = editor.text;
  page.which = which;
  editor.text = texts[which] ?? lesson.student;
}

/** Before anything is compiled: what should come out. */
function showGolden() {
  const pictures = Object.entries(lesson.golden).map(([test, png]) => ({ test, label: 'expected', png }));
  page.result = { pictures };
  showScenes([]);
}

const editor = new Editor($('code'), $('lines'), $('marks'), { test });
$('which').append(new Option(`this lesson: ${lesson.stages.join(', ')}`, 'lesson'), new Option(`all of assignment ${lesson.assignment}`, 'whole'));
$('which').onchange = () => choose($('which').value);
$('test').onclick = test;
$('reset').onclick = () => { editor.text = page.which === 'whole' ? lesson.student : lesson.start; };
$('save-code').onclick = () => save(editor.text, 'student.cpp', 'text/x-c++src');
$('save-result').onclick = () => save(page.result.file, 'result.json', 'application/json');
$('scene').onchange = () => { page.shown = $('scene').value; showPictures(); };
editor.text = texts.lesson;
showGolden();
say('The compiler is loaded when you ask for it.');
globalThis.kreda = { page, editor, test }; // for whoever looks with the browser's tools
