// How far joints and vertices of a foreign file (FBX, BVH, Collada) as three.js reads it are from those of the glTF that the program made
// of it: foreign.mjs FILE GLB [z-up]. Prints JSON, distances as shares of the height:
// foreign.mjs --places GLB RATE prints where its nodes are in each frame of the first clip: { nodes, frames: [[[x, y, z]]] }.
//   { clips: [{ name, frames, worst, joint, frame }], rest: { worst, joint }, vertices, joints, missing: [names], scale }
import { writeSync } from 'node:fs';
import fs from 'node:fs/promises';
import path from 'node:path';
import * as three from 'three';
import { FBXLoader } from 'three/examples/jsm/loaders/FBXLoader.js';
import { BVHLoader } from 'three/examples/jsm/loaders/BVHLoader.js';
import { nodePosition, play, read, vertexPositions } from './reader.mjs';

// Pictures need a browser and move nothing.
globalThis.document ??= { createElementNS: () => ({ addEventListener() {}, removeEventListener() {} }) };
globalThis.window ??= globalThis;
for (const level of ['warn', 'log']) console[level] = () => {};

const [file, glb, upAxis] = process.argv.slice(2);
if (file === '--places') {
  await printPlaces(glb, Number(upAxis));
  process.exit(0);
}
// All of it, before the process ends.
function writeAll(text) {
  for (let rest = Buffer.from(text); rest.length > 0; ) rest = rest.subarray(writeSync(1, rest));
}

async function printPlaces(glb, rate) {
  const model = await read(glb);
  const count = Math.round(model.clips[0].duration * rate) + 1;
  const frames = [];
  play(model, model.clips[0], [...Array(count).keys()].map((frame) => frame / rate), () => frames.push(model.nodes.map(nodePosition)));
  writeAll(JSON.stringify({ nodes: model.names, frames }));
}
const bytes = await fs.readFile(file);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const isBvh = path.extname(file) === '.bvh';

function foreignScene() {
  if (!isBvh) {
    const scene = new FBXLoader().parse(buffer, '');
    return { scene, clips: scene.animations, scale: (scene.userData.unitScaleFactor ?? 1) / 100 };
  }
  const { skeleton, clip } = new BVHLoader().parse(bytes.toString('latin1'));
  const scene = new three.Group().add(skeleton.bones[0]);
  return { scene, clips: [clip], scale: null };
}

const foreign = foreignScene();
const made = await read(glb);
const sanitized = (name) => three.PropertyBinding.sanitizeNodeName(name);

// The first node of a name on either side. Ends of BVH chains have no names of their own in three.js.
const own = new Map();
made.names.forEach((name, index) => own.has(sanitized(name)) || own.set(sanitized(name), made.nodes[index]));
const pairs = [];
const missing = [];
foreign.scene.traverse((object) => {
  // A skinned mesh follows its joints, wherever its node is.
  if (object === foreign.scene || object.isSkinnedMesh || object.name === '' || object.name === 'ENDSITE') return;
  const other = own.get(sanitized(object.name));
  if (other === undefined) missing.push(object.name);
  else if (!pairs.some((pair) => pair.own === other)) pairs.push({ name: object.name, other: object, own: other });
});

const upright = ([x, y, z]) => (upAxis === 'z-up' ? [x, z, -y] : [x, y, z]);
const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const placesOf = (which, scale = 1) => pairs.map((pair) => (which === 'own' ? nodePosition(pair.own) : upright(nodePosition(pair.other)).map((value) => value * scale)));
const spread = (points) => Math.max(...[0, 1, 2].map((axis) => Math.max(...points.map((p) => p[axis])) - Math.min(...points.map((p) => p[axis]))), 0);

foreign.scene.updateMatrixWorld(true);
made.scene.updateMatrixWorld(true);
const scale = foreign.scale ?? spread(placesOf('own')) / spread(placesOf('other'));
const meshes = [];
foreign.scene.traverse((object) => object.isMesh && meshes.push(object));

function pointsOf(list, turn) {
  const points = [];
  for (const object of list) {
    const flat = vertexPositions(object);
    for (let i = 0; i < flat.length; i += 3) points.push(turn(flat.slice(i, i + 3)));
  }
  return points;
}
const ownPoints = () => pointsOf(made.meshes.map((mesh) => mesh.object), (p) => p);
const otherPoints = () => pointsOf(meshes, (p) => upright(p).map((value) => value * scale));
const height = Math.max(spread(placesOf('own')), spread(ownPoints())) || 1;

function worstJoint(a, b) {
  let worst = { worst: 0, joint: '' };
  a.forEach((place, i) => {
    const share = apart(place, b[i]) / height;
    if (share > worst.worst) worst = { worst: share, joint: pairs[i].name };
  });
  return worst;
}

// Sets of points, since three.js writes each corner of a face by itself.
function worstVertex(a, b) {
  if (a.length === 0 || b.length === 0 || a.length > 6000) return null;
  let worst = 0;
  for (const p of b) {
    let nearest = Infinity;
    for (const q of a) nearest = Math.min(nearest, (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 + (p[2] - q[2]) ** 2);
    worst = Math.max(worst, nearest);
  }
  return Math.sqrt(worst) / height;
}

function framesOf(clip) {
  const times = [...new Set(clip.tracks.flatMap((track) => [...track.times]))].sort((a, b) => a - b);
  return times;
}

// At rest a BVH is stood on the floor that its motion is over.
const atRest = { own: placesOf('own'), other: placesOf('other', scale) };
const lift = isBvh ? atRest.own[0][1] - atRest.other[0][1] : 0;
const rest = worstJoint(atRest.own, atRest.other.map(([x, y, z]) => [x, y + lift, z]));
const vertices = [worstVertex(ownPoints(), otherPoints())];
const clips = [];
for (const [index, clip] of foreign.clips.entries()) {
  const at = made.clipNames.indexOf(clip.name) >= 0 ? made.clipNames.indexOf(clip.name) : index;
  if (made.clips[at] === undefined || clip.tracks.length === 0) continue;
  const times = framesOf(clip);
  const theirs = [];
  const theirPoints = [];
  const looked = new Set([0, times.length >> 1, times.length - 1]);
  let k = 0;
  play({ scene: foreign.scene }, clip, times, () => {
    theirs.push(placesOf('other', scale));
    if (looked.has(k++)) theirPoints.push(otherPoints());
  });
  let worst = { worst: 0, joint: '', frame: 0 };
  k = 0;
  // Ours begins where the file says that the take begins.
  const first = (one) => Math.min(...one.tracks.map((track) => track.times[0]));
  const shift = made.clips[at].tracks.length ? first(clip) - first(made.clips[at]) : 0;
  play(made, made.clips[at], times.map((time) => time - shift), () => {
    const one = worstJoint(placesOf('own'), theirs[k]);
    if (one.worst > worst.worst) worst = { ...one, frame: k };
    if (looked.has(k)) vertices.push(worstVertex(ownPoints(), theirPoints.shift()));
    ++k;
  });
  clips.push({ name: clip.name, frames: times.length, ...worst });
}
const known = vertices.filter((value) => value !== null);
process.stdout.write(JSON.stringify({ clips, rest, vertices: known.length ? Math.max(...known) : null, joints: pairs.length, missing, scale, height }));
