// The module: how it is loaded, its memory, and its reasons.

/** Status of a refusal whose reason ends with the first number of the result. */
const REFUSED_NUMBER = 2;
const PAGE = 65536;
const NUMBER = 8;
/** Most numbers of a result of fixed size. */
const LONGEST = 24;

const decoder = new TextDecoder();
const encoder = new TextEncoder();

/** The exported functions. Before `init` each of them says that it is missing. */
export let wasm = new Proxy(
  {},
  {
    get(_, name) {
      if (name === "memory") return undefined;
      throw new Error("tribos is not loaded yet: await init() first");
    },
  },
);

// What is on its way or there, of the small module and of the one with everything.
const loading = {};
let resultAddress = 0;
let result = new Float64Array();
// Pages of our own, which the kernel does not use: memory for arguments and results of any length.
let ownAddress = 0;
let ownLength = 0;
let own = new Float64Array();

/** A function that loads the module `name` from what it is given, or from what `standard` gives. */
export function loader(name, standard) {
  return function init(source) {
    // Everything has what is in the small module.
    if (loading.all !== undefined) return loading.all;
    loading[name] ??= instantiate(source ?? standard()).catch((error) => {
      loading[name] = undefined;
      throw error;
    });
    return loading[name];
  };
}

/** The same at once. */
export function syncLoader(name, standard) {
  return function initSync(source) {
    if (wasm.memory !== undefined && (name !== "all" || wasm.release !== undefined)) return;
    const given = source ?? standard?.();
    if (given === undefined) {
      throw new TypeError("initSync needs the bytes of the module, or a WebAssembly.Module");
    }
    const module = given instanceof WebAssembly.Module ? given : new WebAssembly.Module(given);
    use(new WebAssembly.Instance(module));
    loading[name] = Promise.resolve();
  };
}

async function instantiate(source) {
  let from = await source;
  if (from instanceof WebAssembly.Module) {
    use(await WebAssembly.instantiate(from));
    return;
  }
  if (typeof from === "string" || from instanceof URL) from = await fetched(from);
  if (typeof Response !== "undefined" && from instanceof Response) {
    if (!from.ok) throw new Error(`${from.url}: ${from.status} ${from.statusText}`);
    // A server that does not know the type of the file must not stop us.
    from = await from.arrayBuffer();
  }
  if (!(from instanceof ArrayBuffer) && !ArrayBuffer.isView(from)) {
    throw new TypeError("init takes an address, bytes, a Response or a WebAssembly.Module");
  }
  use((await WebAssembly.instantiate(from)).instance);
}

/** The bytes at an address, which may be a file where there is one. */
async function fetched(address) {
  const base = typeof document === "undefined" ? import.meta.url : document.baseURI;
  const url = new URL(address, base);
  if (url.protocol !== "file:") return fetch(url);
  // Bundlers for browsers must not look for it.
  const files = "node:fs/promises";
  const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ files);
  return readFile(url);
}

function use(instance) {
  // The small module may come late.
  if (wasm.memory !== undefined && wasm.release !== undefined) return;
  wasm = instance.exports;
  ownAddress = 0;
  ownLength = 0;
  resultAddress = wasm.result();
}

/** The last result of fixed size. Valid until the next call. */
export function answer() {
  // Memory that has grown is another buffer.
  if (result.buffer !== wasm.memory.buffer) {
    result = new Float64Array(wasm.memory.buffer, resultAddress, LONGEST);
  }
  return result;
}

/** At least `count` numbers of our own memory. Valid until the next call of this or of the kernel. */
export function room(count) {
  if (count > ownLength) {
    const pages = Math.ceil((Math.max(count, 2 * ownLength) * NUMBER) / PAGE);
    ownAddress = wasm.memory.grow(pages) * PAGE;
    ownLength = (pages * PAGE) / NUMBER;
  }
  if (own.buffer !== wasm.memory.buffer || own.byteOffset !== ownAddress) {
    own = new Float64Array(wasm.memory.buffer, ownAddress, ownLength);
  }
  return own;
}

/** Address of number `at` of our own memory. */
export function place(at = 0) {
  return ownAddress + NUMBER * at;
}

/** Puts texts behind `from` numbers of our own memory: address and length of each in bytes. */
export function texts(from, ...given) {
  const bytes = given.map((text) => encoder.encode(text));
  const total = bytes.reduce((sum, one) => sum + one.length, 0);
  room(from + Math.ceil(total / NUMBER) + 1);
  const memory = new Uint8Array(wasm.memory.buffer);
  let address = place(from);
  return bytes.flatMap((one) => {
    memory.set(one, address);
    const pair = [address, one.length];
    address += one.length;
    return pair;
  });
}

/** Throws what the kernel refuses. */
export function check(status) {
  if (status !== 0) refuse(status);
}

function refuse(status) {
  const words = said();
  throw new RangeError(status === REFUSED_NUMBER ? words + answer()[0] : words);
}

/** The text that the kernel left. */
export function said() {
  const buffer = wasm.memory.buffer;
  const pieces = new Uint32Array(buffer, wasm.reason(), 6);
  let words = "";
  for (let at = 0; at < pieces.length; at += 2) {
    words += decoder.decode(new Uint8Array(buffer, pieces[at], pieces[at + 1]));
  }
  return words;
}
