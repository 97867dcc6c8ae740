// How far two files with the same meshes, bound in different ways, are apart over all clips, as three.js skins them.
//
//   node skin_difference.mjs BOUND SOURCE HEIGHT
//
// Prints JSON: { "rms", "p99", "largest" in percent of the height, "vertices", "frames", "worst": [[percent of the square sum,
// clip]...] }. Skinned meshes count, all of their vertices, at ten times a second of each clip, 20 times at most.
import { play, read, vertexPositions } from './reader.mjs';

const timesASecond = 10;
const mostTimes = 20;

function skinnedVertices(model) {
  return model.meshes.filter(({ object }) => object.isSkinnedMesh).flatMap(({ object }) => vertexPositions(object));
}

function snapshots(model, clip, times) {
  const taken = [];
  play(model, clip, times, () => taken.push(Float64Array.from(skinnedVertices(model))));
  return taken;
}

const [bound, source, heightText] = process.argv.slice(2);
if (!heightText) {
  console.error('usage: node skin_difference.mjs BOUND SOURCE HEIGHT');
  process.exit(2);
}
const height = Number(heightText);
const [a, b] = [await read(bound), await read(source)];
const distances = [];
const sums = [];
let frames = 0;
let vertices = 0;
b.clips.forEach((clip, index) => {
  const count = Math.min(mostTimes, Math.max(2, Math.floor(clip.duration * timesASecond)));
  const times = Array.from({ length: count }, (_, i) => (clip.duration * i) / (count - 1));
  const [shotsA, shotsB] = [snapshots(a, a.clips[index], times), snapshots(b, clip, times)];
  let sum = 0;
  times.forEach((_, k) => {
    const [p, q] = [shotsA[k], shotsB[k]];
    if (p.length !== q.length) throw new Error('the files have other vertices');
    vertices = q.length / 3;
    for (let i = 0; i < q.length; i += 3) {
      const distance = Math.hypot(p[i] - q[i], p[i + 1] - q[i + 1], p[i + 2] - q[i + 2]) / height;
      sum += distance * distance;
      distances.push(distance);
    }
  });
  frames += count;
  sums.push([sum, b.clipNames[index]]);
});
const total = sums.reduce((all, [sum]) => all + sum, 0);
const sorted = Float64Array.from(distances).sort();
console.log(
  JSON.stringify({
    rms: 100 * Math.sqrt(total / sorted.length),
    p99: 100 * sorted[Math.floor(0.99 * sorted.length)],
    largest: 100 * sorted[sorted.length - 1],
    vertices,
    frames,
    worst: sums.sort((x, y) => y[0] - x[0]).slice(0, 3).map(([sum, name]) => [(100 * sum) / total, name]),
  }),
);
