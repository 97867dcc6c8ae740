// How far a compressed clip is from its source, as three.js skins it, and what its mesh looks like.
//
//   node sequence.mjs CLIP.glb POSITIONS VERTICES FPS [--corners]
//
// POSITIONS: single precision, little endian, x y z of every vertex of the source, frame after frame; frame 0 is the bind pose.
// A vertex of the clip belongs to those of the source that it lies on in the bind pose. Prints
// { "rmse_percent", "largest_percent", "unmatched", "corners": [[place, uv or null, normal or null, material], ...] }:
// errors over all vertices of the source and all frames, of the diagonal of frame 0; corners of triangles one after the other.
import fs from 'node:fs/promises';
import { play, read, vertexPositions } from './reader.mjs';

const [file, positionsFile, vertexText, fpsText, ...flags] = process.argv.slice(2);
if (!fpsText) {
  console.error('usage: node sequence.mjs CLIP.glb POSITIONS VERTICES FPS [--corners]');
  process.exit(2);
}
const bytes = await fs.readFile(positionsFile);
const source = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
const vertices = Number(vertexText);
const frames = source.length / (3 * vertices);

function diagonalOf(points) {
  let sum = 0;
  for (let axis = 0; axis < 3; ++axis) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = axis; i < 3 * vertices; i += 3) [low, high] = [Math.min(low, points[i]), Math.max(high, points[i])];
    sum += (high - low) ** 2;
  }
  return Math.sqrt(sum);
}

const size = diagonalOf(source);
const cell = size * 1e-4;
const keyOf = (x, y, z) => `${Math.round(x / cell)},${Math.round(y / cell)},${Math.round(z / cell)}`;
const grid = new Map();
for (let v = 0; v < vertices; ++v) {
  const key = keyOf(source[3 * v], source[3 * v + 1], source[3 * v + 2]);
  if (!grid.has(key)) grid.set(key, []);
  grid.get(key).push(v);
}

// Every vertex of the source at a place: several may lie there.
function sourcesAt(x, y, z) {
  const found = [];
  for (let dx = -1; dx <= 1; ++dx) for (let dy = -1; dy <= 1; ++dy) for (let dz = -1; dz <= 1; ++dz) {
    for (const v of grid.get(keyOf(x + dx * cell, y + dy * cell, z + dz * cell)) ?? []) {
      if (Math.hypot(source[3 * v] - x, source[3 * v + 1] - y, source[3 * v + 2] - z) < 0.5 * cell && !found.includes(v)) found.push(v);
    }
  }
  return found;
}

const model = await read(file);
const owners = []; // the vertices of the source that each vertex of the clip may stand for
for (const { object } of model.meshes) {
  const bind = object.geometry.attributes.position;
  for (let i = 0; i < bind.count; ++i) owners.push(sourcesAt(bind.getX(i), bind.getY(i), bind.getZ(i)));
}
const unmatched = owners.filter((found) => found.length === 0).length;

let frame = 0;
let largest = 0;
let sum = 0;
let counted = 0;
play(model, model.clips[0], Array.from({ length: frames }, (_, k) => k / Number(fpsText)), () => {
  const shown = model.meshes.flatMap(({ object }) => vertexPositions(object));
  const nearest = new Float64Array(vertices).fill(Infinity);
  owners.forEach((found, i) => {
    for (const v of found) {
      const at = 3 * (frame * vertices + v);
      nearest[v] = Math.min(nearest[v], Math.hypot(shown[3 * i] - source[at], shown[3 * i + 1] - source[at + 1], shown[3 * i + 2] - source[at + 2]));
    }
  });
  for (const distance of nearest) {
    if (distance === Infinity) continue;
    sum += distance ** 2;
    largest = Math.max(largest, distance);
    ++counted;
  }
  ++frame;
});

function cornersOf() {
  const json = model.json;
  return model.meshes.flatMap(({ mesh, primitive, object }) => {
    const { position, uv, normal } = object.geometry.attributes;
    const index = object.geometry.index;
    const material = json.materials?.[json.meshes[mesh].primitives[primitive].material]?.name ?? null;
    const vector = (attribute, i) => attribute && Array.from({ length: attribute.itemSize }, (_, c) => attribute.getComponent(i, c));
    return Array.from({ length: index ? index.count : position.count }, (_, n) => {
      const i = index ? index.getX(n) : n;
      return [vector(position, i), vector(uv, i) ?? null, vector(normal, i) ?? null, material];
    });
  });
}

console.log(JSON.stringify({
  rmse_percent: (100 * Math.sqrt(sum / counted)) / size,
  largest_percent: (100 * largest) / size,
  vertices: counted / frames,
  unmatched,
  corners: flags.includes('--corners') ? cornersOf() : [],
}));
