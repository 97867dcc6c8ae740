// Compares two files of one character whose stretch is told in different forms, by skinning of its own over three.js's reading of
// nodes and clips: all sets of influences count.
//
//   node forms.mjs FILE OTHER CLIP HEIGHT TIME...
//
// Prints JSON: the largest distance of a vertex in heights, and the largest angle of a normal in degrees, each file's normals turned
// exactly and by the plain matrix: { "places": D, "at": "mesh/vertex", "normals": { "exact": A, "plain": A } }.
import * as three from 'three';
import { play, read } from './reader.mjs';

// The loader makes the first four weights sum to 1, in the accessor itself.
three.SkinnedMesh.prototype.normalizeSkinWeights = () => {};

async function influencesOf(model, attributes) {
  const sets = [];
  for (let set = 0; attributes[`JOINTS_${set}`] !== undefined; ++set) {
    sets.push(await Promise.all(['JOINTS', 'WEIGHTS'].map((name) => model.parser.getDependency('accessor', attributes[`${name}_${set}`]))));
  }
  return sets;
}

// A vertex's matrix, of all sets.
function matrixOf(matrices, sets, vertex) {
  const sum = new Float64Array(16);
  for (const [joints, weights] of sets) {
    for (let i = 0; i < 4; ++i) {
      const weight = weights.getComponent(vertex, i);
      if (weight > 0) matrices[joints.getComponent(vertex, i)].forEach((number, k) => (sum[k] += weight * number));
    }
  }
  return new three.Matrix4().fromArray(sum);
}

async function partsOf(model) {
  const parts = [];
  for (const { mesh, primitive, node, object } of model.meshes) {
    const json = model.json.meshes[mesh].primitives[primitive];
    const attributes = json.attributes;
    const skinned = model.json.nodes[node].skin !== undefined && attributes.JOINTS_0 !== undefined;
    parts.push({
      key: attributes.POSITION,
      object,
      sets: skinned ? await influencesOf(model, attributes) : null,
      position: object.geometry.attributes.position,
      normal: object.geometry.attributes.normal,
    });
  }
  return parts.sort((a, b) => a.key - b.key);
}

export function placed(part) {
  const object = part.object;
  const matrices = part.sets ? object.skeleton.bones.map((bone, i) => new three.Matrix4().multiplyMatrices(bone.matrixWorld, object.skeleton.boneInverses[i]).elements) : null;
  const result = [];
  for (let v = 0; v < part.position.count; ++v) {
    const matrix = matrices ? matrixOf(matrices, part.sets, v) : object.matrixWorld;
    const place = new three.Vector3().fromBufferAttribute(part.position, v).applyMatrix4(matrix);
    const normal = part.normal && new three.Vector3().fromBufferAttribute(part.normal, v);
    const plain = normal && normal.clone().applyMatrix3(new three.Matrix3().setFromMatrix4(matrix)).normalize();
    const exact = normal && normal.clone().applyMatrix3(new three.Matrix3().getNormalMatrix(matrix)).normalize();
    result.push({ place, plain, exact });
  }
  return result;
}

export async function framesOf(file, clip, times) {
  const model = await read(file);
  const parts = await partsOf(model);
  const frames = [];
  play(model, model.clips[clip], times, () => frames.push(parts.map(placed)));
  return { frames, parts };
}

if (process.argv[1].endsWith('forms.mjs')) {
  const [file, other, clip, height, ...times] = process.argv.slice(2);
  const seconds = times.map(Number);
  const [a, b] = [await framesOf(file, Number(clip), seconds), await framesOf(other, Number(clip), seconds)];
  const worst = { places: 0, at: '', normals: { exact: 0, plain: 0 } };
  const distances = [];
  a.frames.forEach((partsA, t) =>
    partsA.forEach((vertices, p) =>
      vertices.forEach((one, v) => {
        const two = b.frames[t][p][v];
        const distance = one.place.distanceTo(two.place) / Number(height);
        distances.push(distance);
        if (distance > worst.places) Object.assign(worst, { places: distance, at: `${p}/${v} at ${seconds[t]}` });
        for (const way of one.plain ? ['exact', 'plain'] : []) {
          const angle = (one[way].angleTo(two[way]) * 180) / Math.PI;
          if (angle > worst.normals[way]) worst.normals[way] = angle;
        }
      }),
    ),
  );
  console.log(JSON.stringify(worst));
}
