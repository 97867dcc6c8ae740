// What the Khronos glTF Validator says of a file.
import fs from 'node:fs/promises';
import path from 'node:path';
import validator from 'gltf-validator';

const lowestWarning = 1; // severities: 0 error, 1 warning, 2 information, 3 hint

/// Errors and warnings by code: how many, and where the first one is.
export async function issuesOf(file) {
  const folder = path.dirname(file);
  const report = await validator.validateBytes(new Uint8Array(await fs.readFile(file)), {
    uri: path.basename(file),
    maxIssues: 0,
    externalResourceFunction: async (uri) => new Uint8Array(await fs.readFile(path.join(folder, decodeURIComponent(uri)))),
  });
  const counts = new Map();
  const firstPlaces = new Map();
  for (const message of report.issues.messages) {
    if (message.severity <= lowestWarning) {
      counts.set(message.code, (counts.get(message.code) ?? 0) + 1);
      firstPlaces.set(message.code, firstPlaces.get(message.code) ?? `${message.pointer}: ${message.message}`);
    }
  }
  return { counts, firstPlaces };
}

/// One line for each code of which `found` has more than `allowed`.
export function worseThan(found, allowed) {
  return [...found.counts]
    .filter(([code, count]) => count > (allowed.counts.get(code) ?? 0))
    .map(([code, count]) => `${code}: ${count} instead of ${allowed.counts.get(code) ?? 0}; first at ${found.firstPlaces.get(code)}`);
}
