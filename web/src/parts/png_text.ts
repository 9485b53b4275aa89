// Texts in a PNG file, as chunks tEXt after its header (PNG specification, section 11.3.3); texts
// with characters beyond Latin-1 as iTXt.

const kHeader = 33; // bytes: the signature and the chunk IHDR

export function withText(png: Uint8Array, texts: readonly [key: string, words: string][]): Uint8Array<ArrayBuffer> {
  const chunks = texts.map(([key, words]) => chunkOf(key, words));
  const whole = new Uint8Array(png.length + chunks.reduce((sum, chunk) => sum + chunk.length, 0));
  whole.set(png.subarray(0, kHeader));
  let at = kHeader;
  for (const chunk of chunks) {
    whole.set(chunk, at);
    at += chunk.length;
  }
  whole.set(png.subarray(kHeader), at);
  return whole;
}

function chunkOf(key: string, words: string): Uint8Array {
  const isLatin = [...words].every((letter) => letter.codePointAt(0)! < 256);
  if (isLatin) return chunk("tEXt", latin(`${key}\0${words}`));
  // Uncompressed, without language and translated key.
  return chunk("iTXt", joined(latin(`${key}\0\0\0\0\0`), new TextEncoder().encode(words)));
}

function chunk(type: string, content: Uint8Array): Uint8Array {
  const body = joined(latin(type), content);
  return joined(bigEndian(content.length), joined(body, bigEndian(checksum(body))));
}

function latin(words: string): Uint8Array {
  return Uint8Array.from(words, (letter) => letter.charCodeAt(0));
}

function bigEndian(number: number): Uint8Array {
  return Uint8Array.of(number >>> 24, number >>> 16, number >>> 8, number);
}

function joined(one: Uint8Array, other: Uint8Array): Uint8Array {
  const both = new Uint8Array(one.length + other.length);
  both.set(one);
  both.set(other, one.length);
  return both;
}

/** CRC-32 (ISO 3309), bit by bit. */
export function checksum(bytes: Uint8Array): number {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit += 1) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return (sum ^ 0xffffffff) >>> 0;
}
