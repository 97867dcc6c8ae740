// Draco meshes for three's GLTFLoader: its own loader needs a browser's workers, the decoder does not.
import draco from 'draco3dgltf';
import * as three from 'three';

const dracoTypes = new Map([
  ['Float32Array', 'DT_FLOAT32'],
  ['Int8Array', 'DT_INT8'],
  ['Int16Array', 'DT_INT16'],
  ['Uint8Array', 'DT_UINT8'],
  ['Uint16Array', 'DT_UINT16'],
  ['Uint32Array', 'DT_UINT32'],
]);
const arrays = { Float32Array, Int8Array, Int16Array, Uint8Array, Uint16Array, Uint32Array };
const module = await draco.createDecoderModule();

function copied(bytes, Type, fill) {
  const place = module._malloc(bytes);
  fill(place);
  const values = new Type(module.HEAPU8.buffer.slice(place, place + bytes));
  module._free(place);
  return values;
}

function geometryOf(buffer, ids, types) {
  const decoder = new module.Decoder();
  const mesh = new module.Mesh();
  const status = decoder.DecodeArrayToMesh(new Int8Array(buffer), buffer.byteLength, mesh);
  if (!status.ok()) throw new Error(`Draco: ${status.error_msg()}`);
  const geometry = new three.BufferGeometry();
  for (const [name, id] of Object.entries(ids)) {
    const attribute = decoder.GetAttributeByUniqueId(mesh, id);
    const width = attribute.num_components();
    const Type = arrays[types[name]];
    const bytes = mesh.num_points() * width * Type.BYTES_PER_ELEMENT;
    const type = module[dracoTypes.get(types[name])];
    const values = copied(bytes, Type, (place) => decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, type, bytes, place));
    geometry.setAttribute(name, new three.BufferAttribute(values, width));
  }
  const indexBytes = mesh.num_faces() * 12;
  geometry.setIndex(new three.BufferAttribute(copied(indexBytes, Uint32Array, (place) => decoder.GetTrianglesUInt32Array(mesh, indexBytes, place)), 1));
  module.destroy(mesh);
  module.destroy(decoder);
  return geometry;
}

export class DracoMeshes {
  preload() {
    return this;
  }

  decodeDracoFile(buffer, done, ids, types, _space, failed) {
    try {
      done(geometryOf(buffer, ids, types));
    } catch (problem) {
      failed(problem);
    }
  }
}
