// Prints every family and its checksum, as the host does.
import { readFileSync } from 'node:fs';

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]));
const { memory, families, name, name_length, checksum } = instance.exports;
for (let k = 0; k < families(); k++) {
  const bytes = new Uint8Array(memory.buffer, name(k), name_length(k));
  console.log(`${new TextDecoder().decode(bytes)}: ${(checksum(k) >>> 0).toString(16).padStart(8, '0')}`);
}
