// Pictures of files that three.js draws in a browser (Chromium, with no screen), through the first camera of each.
//
//   node pictures.mjs BROWSER < JOBS
//
// JOBS is JSON: [{ file, clip, time, width, height, normals, output }]. With `normals` a pixel is the normal as the camera sees it
// (MeshNormalMaterial), else lit. What no mesh covers is transparent. The page asks this process for files and sends its pictures back.
import { spawn } from 'node:child_process';
import fs from 'node:fs/promises';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const mostMilliseconds = 300000;
const types = { '.js': 'text/javascript', '.mjs': 'text/javascript', '.html': 'text/html' };

async function bodyOf(request) {
  const parts = [];
  for await (const part of request) parts.push(part);
  return Buffer.concat(parts);
}

// Files under this folder by their paths, those of the jobs by number, and pictures in the other direction.
async function answer(jobs, request, response, done) {
  const [, kind, number] = request.url.split('/');
  if (kind === 'jobs') return response.end(JSON.stringify(jobs));
  if (kind === 'model') return response.end(await fs.readFile(jobs[Number(number)].file));
  if (kind === 'picture') {
    await fs.writeFile(jobs[Number(number)].output, await bodyOf(request));
    return response.end();
  }
  if (kind === 'end' || kind === 'problem') {
    const problem = (await bodyOf(request)).toString();
    response.end();
    return done(problem);
  }
  const name = path.join(here, path.normalize(request.url));
  response.setHeader('Content-Type', types[path.extname(name)] ?? 'application/octet-stream');
  return response.end(await fs.readFile(name));
}

const jobs = JSON.parse(await fs.readFile('/dev/stdin', 'utf8'));
const profile = await fs.mkdtemp(path.join(os.tmpdir(), 'pictures-'));
const problem = await new Promise((done) => {
  const server = http.createServer((request, response) =>
    answer(jobs, request, response, done).catch(() => {
      response.statusCode = 404;
      response.end();
    }),
  );
  server.listen(0, '127.0.0.1', () => {
    const flags = ['--headless', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage'];
    const page = `http://127.0.0.1:${server.address().port}/pictures.html`;
    const browser = spawn(process.argv[2], [...flags, `--user-data-dir=${profile}`, '--remote-debugging-port=0', page], { stdio: 'ignore', detached: true });
    const stop = () => process.kill(-browser.pid, 'SIGKILL');
    process.on('exit', () => {
      try {
        stop();
      } catch {
        // It has ended by itself.
      }
    });
    browser.on('error', () => done('the browser does not start'));
    browser.on('exit', () => done('the browser ended'));
    setTimeout(() => done('the browser takes too long'), mostMilliseconds).unref();
  });
});
if (problem) console.error(problem);
process.on('exit', () => {});
await fs.rm(profile, { recursive: true, force: true }).catch(() => {});
process.exit(problem ? 1 : 0);
