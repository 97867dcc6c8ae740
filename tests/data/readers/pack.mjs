// Packs a character by gltf-transform, as exporters do: node pack.mjs FOLDER FILE...
//
// For each FILE.glb writes FILE-draco.glb, FILE-draco-sequential.glb, FILE-meshopt.glb and FILE-quantised.glb into FOLDER.
import path from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { draco, meshopt, quantize } from '@gltf-transform/functions';
import draco3d from 'draco3dgltf';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';

const [folder, ...files] = process.argv.slice(2);
await MeshoptEncoder.ready;
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
  'draco3d.encoder': await draco3d.createEncoderModule(),
  'draco3d.decoder': await draco3d.createDecoderModule(),
  'meshopt.encoder': MeshoptEncoder,
  'meshopt.decoder': MeshoptDecoder,
});
const packings = {
  draco: draco({ method: 'edgebreaker' }),
  'draco-sequential': draco({ method: 'sequential' }),
  meshopt: meshopt({ encoder: MeshoptEncoder, level: 'medium' }),
  quantised: quantize(),
};
for (const file of files) {
  for (const [name, packing] of Object.entries(packings)) {
    const document = await io.read(file);
    await document.transform(packing);
    await io.write(path.join(folder, `${path.basename(file, '.glb')}-${name}.glb`), document);
  }
}
