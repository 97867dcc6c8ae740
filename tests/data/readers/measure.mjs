// Prints where three.js puts nodes and skinned vertices of a file, as JSON.
//
//   node measure.mjs FILE [--clip NAME|#INDEX] [--times 0,0.5,1] [--nodes NAME,#INDEX] [--vertices STEP]
//
// { "times": [...], "nodes": { "#12 Hand.R": [[x, y, z] a time] }, "vertices": { "#node mesh/primitive": [[x, y, z, ...] a time] } }
import { nodePosition, play, read, vertexPositions } from './reader.mjs';

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

const indexOf = (names, wanted) => (wanted.startsWith('#') ? Number(wanted.slice(1)) : names.indexOf(wanted));

function found(index, list, wanted) {
  if (index < 0 || list[index] === undefined) throw new Error(`there is no '${wanted}'`);
  return index;
}

async function measure({ file, times, nodes, step, clip }) {
  const model = await read(file);
  const clipIndex = clip === null ? -1 : found(indexOf(model.clipNames, clip), model.clips, clip);
  const indices = nodes.map((wanted) => found(indexOf(model.names, wanted), model.nodes, wanted));
  const result = { times, nodes: {}, vertices: {} };
  play(model, clipIndex < 0 ? null : model.clips[clipIndex], times, () => {
    for (const index of indices) (result.nodes[`#${index} ${model.names[index]}`] ??= []).push(nodePosition(model.nodes[index]));
    for (const { mesh, primitive, node, object } of step > 0 ? model.meshes : []) {
      (result.vertices[`#${node} ${mesh}/${primitive}`] ??= []).push(vertexPositions(object, step));
    }
  });
  return result;
}

const parsed = options(process.argv.slice(2));
if (!parsed.file) {
  console.error('usage: node measure.mjs FILE [--clip NAME|#INDEX] [--times 0,0.5,1] [--nodes NAME,#INDEX] [--vertices STEP]');
  process.exit(2);
}
console.log(JSON.stringify(await measure(parsed)));
