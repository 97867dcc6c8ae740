// How far from upright three.js turns the normals of a clip's vertices that a stretch moves, by its own skinning.
//
//   node shading.mjs FILE CLIP TIME...
//
// What three.js's shader does to a normal is what `applyBoneTransform` does to a direction; upright it is by the inverse transpose of the
// same matrix. A stretch moves what follows a joint that scales unequally, or one below it; bends alone turn normals a little too. Prints JSON, an entry for each time: { "worst": DEGREES, "over": [vertices over 19, 20 and 21 degrees] }.
import * as three from 'three';
import { play, read } from './reader.mjs';

const limits = [19, 20, 21];

// The linear part of what three.js does to a vertex, without the mesh's own matrix.
function skinning(object, vertex) {
  const origin = object.applyBoneTransform(vertex, new three.Vector3());
  const columns = [0, 1, 2].map((axis) => object.applyBoneTransform(vertex, new three.Vector3().setComponent(axis, 1)).sub(origin));
  return new three.Matrix3().fromArray(columns.flatMap((column) => column.toArray()));
}

function degreesOff(object, vertex, normal) {
  const world = new three.Matrix3().setFromMatrix4(object.matrixWorld);
  const linear = skinning(object, vertex);
  const shaded = normal.clone().applyMatrix3(linear).applyMatrix3(new three.Matrix3().getNormalMatrix(object.matrixWorld));
  const upright = normal.clone().applyMatrix3(world.clone().multiply(linear).invert().transpose());
  return (shaded.angleTo(upright) * 180) / Math.PI;
}

// Whether the columns are not as long as each other, or do not stand upright on each other.
function scalesUnequally(matrix) {
  const columns = [0, 1, 2].map((axis) => new three.Vector3().setFromMatrixColumn(matrix, axis));
  const mean = columns.reduce((sum, column) => sum + column.lengthSq(), 0) / 3;
  return columns.some((a, i) => columns.some((b, k) => Math.abs(a.dot(b) - (i === k ? mean : 0)) > 0.02 * mean));
}

// The bones of a mesh that are stretched, or are below one that is.
function stretchedBones(object) {
  const { bones, boneInverses } = object.skeleton;
  const stretched = new Set();
  bones.forEach((bone, i) => {
    if (scalesUnequally(bone.matrixWorld.clone().multiply(boneInverses[i]))) bone.traverse((below) => stretched.add(below));
  });
  return bones.map((bone) => stretched.has(bone));
}

function isMoved(object, stretched, vertex) {
  const { skinIndex, skinWeight } = object.geometry.attributes;
  return [0, 1, 2, 3].some((i) => skinWeight.getComponent(vertex, i) > 0 && stretched[skinIndex.getComponent(vertex, i)]);
}

const [file, clip, ...times] = process.argv.slice(2);
const model = await read(file);
const frames = [];
play(model, model.clips[Number(clip)], times.map(Number), () => {
  const frame = { worst: 0, over: limits.map(() => 0) };
  for (const { object } of model.meshes) {
    const normals = object.geometry.attributes.normal;
    if (!object.isSkinnedMesh || !normals) continue;
    const stretched = stretchedBones(object);
    for (let vertex = 0; vertex < normals.count; ++vertex) {
      if (!isMoved(object, stretched, vertex)) continue;
      const degrees = degreesOff(object, vertex, new three.Vector3().fromBufferAttribute(normals, vertex));
      if (degrees > frame.worst) frame.worst = degrees;
      limits.forEach((limit, i) => (frame.over[i] += degrees > limit));
    }
  }
  frames.push(frame);
});
console.log(JSON.stringify(frames));
