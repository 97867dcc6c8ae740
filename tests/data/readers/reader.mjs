// A glTF file as three.js reads it: an implementation that shares nothing with ours. Textures are left out, since they need
// a browser and move nothing.
import fs from 'node:fs/promises';
import path from 'node:path';
import * as three from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/examples/jsm/libs/meshopt_decoder.module.js';
import { DracoMeshes } from './draco_meshes.mjs';

// three's loaders expect these of a browser.
globalThis.self ??= globalThis;
globalThis.ProgressEvent ??= class extends Event {};

const jsonChunk = 0x4e4f534a;
const binaryChunk = 0x004e4942;

function chunksOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const chunks = new Map();
  for (let offset = 12; offset + 8 <= bytes.byteLength; ) {
    const length = view.getUint32(offset, true);
    const type = view.getUint32(offset + 4, true);
    if (!chunks.has(type)) chunks.set(type, bytes.subarray(offset + 8, offset + 8 + length));
    offset += 8 + length;
  }
  return chunks;
}

function withoutTextures(json) {
  json = structuredClone(json);
  for (const key of ['images', 'textures', 'samplers', 'materials']) delete json[key];
  for (const mesh of json.meshes ?? []) for (const primitive of mesh.primitives) delete primitive.material;
  const left = ['KHR_mesh_quantization', 'EXT_meshopt_compression', 'KHR_draco_mesh_compression'];
  for (const key of ['extensionsUsed', 'extensionsRequired']) if (json[key]) json[key] = json[key].filter((name) => left.includes(name));
  return json;
}

const asDataUri = (bytes) => `data:application/octet-stream;base64,${Buffer.from(bytes).toString('base64')}`;

// JSON with every buffer inside it.
async function selfContained(file) {
  const bytes = await fs.readFile(file);
  const isBinary = bytes.subarray(0, 4).toString('latin1') === 'glTF';
  const chunks = isBinary ? chunksOf(bytes) : null;
  const asWritten = JSON.parse(Buffer.from(isBinary ? chunks.get(jsonChunk) : bytes).toString('utf8'));
  const json = withoutTextures(asWritten);
  for (const buffer of json.buffers ?? []) {
    if (buffer.extensions?.EXT_meshopt_compression?.fallback) continue;
    if (buffer.uri === undefined) buffer.uri = asDataUri(chunks.get(binaryChunk));
    else if (!buffer.uri.startsWith('data:')) buffer.uri = asDataUri(await fs.readFile(path.join(path.dirname(file), decodeURIComponent(buffer.uri))));
  }
  return { json, asWritten };
}

// The primitives of a node: the node itself, or its children that are no nodes.
function primitivesOf(object, nodes) {
  return object.isMesh ? [object] : object.children.filter((child) => child.isMesh && !nodes.includes(child));
}

/// { json: as the file has it, scene, clips, nodes: [object by node index], meshes: [{ mesh, primitive, node, object }] by mesh, primitive, node }
export async function read(file) {
  const { json, asWritten } = await selfContained(file);
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).setDRACOLoader(new DracoMeshes());
  const gltf = await loader.parseAsync(JSON.stringify(json), '');
  // Asked for by index: three.js mixes up the indices of nodes that share a mesh.
  const nodes = await Promise.all((json.nodes ?? []).map((_, index) => gltf.parser.getDependency('node', index)));
  const meshes = nodes.flatMap((nodeObject, node) =>
    json.nodes[node].mesh === undefined
      ? []
      : primitivesOf(nodeObject, nodes).map((object, primitive) => ({ mesh: json.nodes[node].mesh, primitive, node, object })),
  );
  meshes.sort((a, b) => a.mesh - b.mesh || a.primitive - b.primitive || a.node - b.node);
  const names = (json.nodes ?? []).map((node) => node.name ?? '');
  return { json: asWritten, parser: gltf.parser, scene: gltf.scene, clips: gltf.animations, clipNames: (json.animations ?? []).map((clip) => clip.name ?? ''), names, nodes, meshes };
}

/// Calls visit(time) with the scene posed at each time of the clip (null: at rest).
export function play(model, clip, times, visit) {
  const mixer = new three.AnimationMixer(model.scene);
  if (clip) {
    const action = mixer.clipAction(clip);
    action.setLoop(three.LoopOnce, 1);
    action.clampWhenFinished = true;
    action.play();
  }
  for (const time of times) {
    // Played anew for each time: a finished action stays finished.
    if (clip) mixer.clipAction(clip).reset();
    mixer.setTime(time);
    model.scene.updateMatrixWorld(true);
    visit(time);
  }
  mixer.stopAllAction();
  mixer.uncacheRoot(model.scene);
}

export function nodePosition(object) {
  return new three.Vector3().setFromMatrixPosition(object.matrixWorld).toArray();
}

/// World positions of every step-th vertex, skinned and morphed, one after the other.
export function vertexPositions(mesh, step = 1) {
  const count = mesh.geometry.attributes.position.count;
  const positions = [];
  const vertex = new three.Vector3();
  for (let i = 0; i < count; i += step) {
    mesh.getVertexPosition(i, vertex).applyMatrix4(mesh.matrixWorld);
    positions.push(vertex.x, vertex.y, vertex.z);
  }
  return positions;
}

const indexOf = (names, wanted) => (wanted.startsWith('#') ? Number(wanted.slice(1)) : names.indexOf(wanted));

function found(index, list, wanted) {
  if (index < 0 || list[index] === undefined) throw new Error(`there is no '${wanted}'`);
  return index;
}

/// Positions of nodes ("#INDEX" or names), or with `matrices` their world matrices (16 numbers, column by column), and positions of every
/// step-th vertex (0: none), at times of a clip (null: at rest).
export function measure(model, { times, nodes = [], step = 0, clip = null, matrices = false }) {
  const clipIndex = clip === null ? -1 : found(indexOf(model.clipNames, clip), model.clips, clip);
  const indices = nodes.map((wanted) => found(indexOf(model.names, wanted), model.nodes, wanted));
  const result = { times, nodes: {}, vertices: {} };
  play(model, clipIndex < 0 ? null : model.clips[clipIndex], times, () => {
    for (const index of indices) (result.nodes[`#${index} ${model.names[index]}`] ??= []).push(matrices ? model.nodes[index].matrixWorld.toArray() : nodePosition(model.nodes[index]));
    for (const { mesh, primitive, node, object } of step > 0 ? model.meshes : []) {
      (result.vertices[`#${node} ${mesh}/${primitive}`] ??= []).push(vertexPositions(object, step));
    }
  });
  return result;
}
