// Compares what the Khronos glTF Validator says of an output with what it says of its source.
//
//   node validate.mjs OUTPUT [SOURCE]
//
// Fails (status 1) when the output has an error or a warning code that the source does not have, or more of one.
import path from 'node:path';
import { issuesOf, worseThan } from './validation.mjs';

const [output, source] = process.argv.slice(2);
if (!output) {
  console.error('usage: node validate.mjs OUTPUT [SOURCE]');
  process.exit(2);
}
const worse = worseThan(await issuesOf(output), source ? await issuesOf(source) : { counts: new Map() });
for (const line of worse) console.log(line);
console.log(`${path.basename(output)}: ${worse.length === 0 ? 'nothing that the source does not have' : 'worse than its source'}`);
process.exit(worse.length === 0 ? 0 : 1);
