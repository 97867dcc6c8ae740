// Prints where three.js puts nodes and skinned vertices of a file, as JSON.
//
//   node measure.mjs FILE [--clip NAME|#INDEX] [--times 0,0.5,1] [--nodes NAME,#INDEX] [--vertices STEP]
//
// { "times": [...], "nodes": { "#12 Hand.R": [[x, y, z] a time] }, "vertices": { "#node mesh/primitive": [[x, y, z, ...] a time] } }
import { measure, read } from './reader.mjs';

function options(list) {
  const [file, ...rest] = list;
  const result = { file, times: [0], nodes: [], step: 0, clip: null };
  for (let i = 0; i < rest.length; i += 2) {
    const value = rest[i + 1];
    if (rest[i] === '--clip') result.clip = value;
    else if (rest[i] === '--times') result.times = value.split(',').map(Number);
    else if (rest[i] === '--nodes') result.nodes = value.split(',');
    else if (rest[i] === '--vertices') result.step = Number(value);
    else throw new Error(`unknown option ${rest[i]}`);
  }
  return result;
}

const parsed = options(process.argv.slice(2));
if (!parsed.file) {
  console.error('usage: node measure.mjs FILE [--clip NAME|#INDEX] [--times 0,0.5,1] [--nodes NAME,#INDEX] [--vertices STEP]');
  process.exit(2);
}
console.log(JSON.stringify(measure(await read(parsed.file), parsed)));
