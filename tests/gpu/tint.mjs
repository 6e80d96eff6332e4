// Asks Tint, the compiler of Chromium, about every WGSL file in a folder. Run by run.sh, which installs Dawn for node.
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const [, , folder, modules] = process.argv;
const dawn = createRequire(`${modules}/`).resolve('webgpu');
const { create } = await import(pathToFileURL(dawn).href);

// Without a device: shaders are read and checked all the same.
const gpu = create(['backend=null']);
const adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();
device.pushErrorScope('validation');

const files = readdirSync(folder).filter((file) => file.endsWith('.wgsl'));
let refused = 0;
for (const file of files) {
  const module = device.createShaderModule({ code: readFileSync(`${folder}/${file}`, 'utf8') });
  for (const { type, message, lineNum, linePos } of (await module.getCompilationInfo()).messages) {
    console.log(`${file}:${lineNum}:${linePos}: ${type}: ${message}`);
    refused += 1;
  }
}
console.log(`Tint has read ${files.length} shaders and says ${refused} things`);
process.exit(refused || files.length === 0 ? 1 : 0);
