// Khronos' validator on every file of a folder. Usage: node check_models.cjs VALIDATOR FOLDER. One line an error; exit code 1 if there are any.
'use strict';
const fs = require('fs');
const path = require('path');

const validator = require(process.argv[2]);
const folder = process.argv[3];

// A file without extension .glb is text. Pictures and buffers beside it are not here: what the file itself says is checked.
async function errorsOf(name) {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(path.join(folder, name))), { maxIssues: 0 });
  return report.issues.messages.filter((issue) => issue.severity === 0).map((issue) => `${name}: ${issue.code} ${issue.pointer || ''}: ${issue.message}`);
}

(async () => {
  const names = fs.readdirSync(folder).sort();
  const errors = (await Promise.all(names.map(errorsOf))).flat();
  for (const error of errors) console.log(error);
  console.log(`${names.length} files, ${errors.length} errors`);
  process.exit(errors.length > 0 || names.length === 0 ? 1 : 0);
})();
