// Measures and validates many files in one process: one request per line on stdin, one answer per line on stdout, both JSON.
//
//   { "do": "measure", "file": FILE, "clip": "#0", "times": [0, 0.5], "nodes": ["#3"], "step": 20 }: as measure.mjs prints
//   { "do": "validate", "file": FILE, "source": FILE }: { "worse": ["CODE: 2 instead of 0; first at ..."] }
//
// A file named "keep": true is kept in memory for later requests: one that does not change. Errors: { "error": "..." }.
import readline from 'node:readline';
import { measure, read } from './reader.mjs';
import { issuesOf, worseThan } from './validation.mjs';

const models = new Map();
const issues = new Map();

async function kept(map, file, keep, make) {
  if (map.has(file)) return map.get(file);
  const made = await make(file);
  if (keep) map.set(file, made);
  return made;
}

async function answer(request) {
  if (request.do === 'measure') return measure(await kept(models, request.file, request.keep, read), request);
  const source = await kept(issues, request.source, true, issuesOf);
  return { worse: worseThan(await issuesOf(request.file), source) };
}

for await (const line of readline.createInterface({ input: process.stdin })) {
  let result;
  try {
    result = await answer(JSON.parse(line));
  } catch (problem) {
    result = { error: String(problem?.message ?? problem) };
  }
  process.stdout.write(`${JSON.stringify(result)}\n`);
}
