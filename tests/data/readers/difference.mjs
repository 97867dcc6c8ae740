// The largest distance between the vertices of two files with the same meshes, over all clips, as three.js skins them.
//
//   node difference.mjs OUTPUT SOURCE [TOLERANCE [CLIP...]]
//
// Distances are relative to the height of the source at rest. With a tolerance the status is 1 when it is exceeded; clips
// (by name) limit the comparison to them.
import path from 'node:path';
import { play, read, vertexPositions } from './reader.mjs';

const timesAClip = 9;
const verticesAMesh = 400;

function allVertices(model) {
  const positions = [];
  for (const { object } of model.meshes) {
    positions.push(...vertexPositions(object, Math.max(1, Math.ceil(object.geometry.attributes.position.count / verticesAMesh))));
  }
  return positions;
}

function snapshots(model, clip, times) {
  const taken = [];
  play(model, clip, times, () => taken.push(allVertices(model)));
  return taken;
}

function heightOf(positions) {
  const heights = positions.filter((_, i) => i % 3 === 1);
  return heights.reduce((a, b) => Math.max(a, b), -Infinity) - heights.reduce((a, b) => Math.min(a, b), Infinity);
}

function largestDistance(a, b) {
  if (a.length !== b.length) return Infinity;
  let largest = 0;
  for (let i = 0; i < a.length; i += 3) largest = Math.max(largest, Math.hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]));
  return largest;
}

const [output, source, tolerance = 'Infinity', ...onlyClips] = process.argv.slice(2);
if (!source) {
  console.error('usage: node difference.mjs OUTPUT SOURCE [TOLERANCE [CLIP...]]');
  process.exit(2);
}
const [a, b] = [await read(output), await read(source)];
const restB = snapshots(b, null, [0])[0];
const height = heightOf(restB) || 1;
let worst = { distance: largestDistance(snapshots(a, null, [0])[0], restB) / height, where: 'at rest' };
b.clips.forEach((clip, index) => {
  if (onlyClips.length > 0 && !onlyClips.includes(b.clipNames[index])) return;
  const times = Array.from({ length: timesAClip }, (_, i) => (clip.duration * i) / (timesAClip - 1));
  const [shotsA, shotsB] = [snapshots(a, a.clips[index], times), snapshots(b, clip, times)];
  times.forEach((time, i) => {
    const distance = largestDistance(shotsA[i], shotsB[i]) / height;
    if (distance > worst.distance) worst = { distance, where: `clip '${b.clipNames[index]}' at ${time.toFixed(3)} s` };
  });
});
console.log(`${path.basename(output)}: largest difference ${worst.distance.toExponential(2)} of the height, ${worst.where}`);
process.exit(worst.distance <= Number(tolerance) ? 0 : 1);
