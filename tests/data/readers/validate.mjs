// Compares what the Khronos glTF Validator says of an output with what it says of its source.
//
//   node validate.mjs OUTPUT [SOURCE]
//
// Fails (status 1) when the output has an error or a warning code that the source does not have, or more of one.
import fs from 'node:fs/promises';
import path from 'node:path';
import validator from 'gltf-validator';

const lowestWarning = 1; // severities: 0 error, 1 warning, 2 information, 3 hint

async function issuesOf(file) {
  const folder = path.dirname(file);
  const report = await validator.validateBytes(new Uint8Array(await fs.readFile(file)), {
    uri: path.basename(file),
    maxIssues: 0,
    externalResourceFunction: async (uri) => new Uint8Array(await fs.readFile(path.join(folder, decodeURIComponent(uri)))),
  });
  const counts = new Map();
  const firstPlaces = new Map();
  for (const message of report.issues.messages) {
    if (message.severity <= lowestWarning) {
      counts.set(message.code, (counts.get(message.code) ?? 0) + 1);
      firstPlaces.set(message.code, firstPlaces.get(message.code) ?? `${message.pointer}: ${message.message}`);
    }
  }
  return { counts, firstPlaces };
}

const [output, source] = process.argv.slice(2);
if (!output) {
  console.error('usage: node validate.mjs OUTPUT [SOURCE]');
  process.exit(2);
}
const found = await issuesOf(output);
const allowed = source ? (await issuesOf(source)).counts : new Map();
const added = [...found.counts].filter(([code, count]) => count > (allowed.get(code) ?? 0));
for (const [code, count] of added) {
  console.log(`${code}: ${count} instead of ${allowed.get(code) ?? 0}; first at ${found.firstPlaces.get(code)}`);
}
console.log(`${path.basename(output)}: ${added.length === 0 ? 'nothing that the source does not have' : 'worse than its source'}`);
process.exit(added.length === 0 ? 0 : 1);
