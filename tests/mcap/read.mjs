// Reads an MCAP file with the official readers, checksums on, and prints what they saw as JSON.
// usage: node read.mjs FILE

import { open, readFile } from "node:fs/promises";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import lz4 from "@foxglove/wasm-lz4";
import zstd from "@foxglove/wasm-zstd";

await lz4.isLoaded;
await zstd.isLoaded;
const decompressHandlers = {
  lz4: (bytes, size) => new Uint8Array(lz4(bytes, Number(size))),
  zstd: (bytes, size) => new Uint8Array(zstd.decompress(bytes, Number(size))),
};

// Takes fields of little-endian CDR one after the other.
class Cdr {
  constructor(data) {
    this.view = new DataView(data.buffer, data.byteOffset + 4, data.byteLength - 4);
    if (data[0] !== 0 || data[1] !== 1) throw new Error("not little-endian CDR");
    this.at = 0;
  }
  take(size, get) {
    this.at = Math.ceil(this.at / size) * size;
    const value = get.call(this.view, this.at, true);
    this.at += size;
    return value;
  }
  uint32() { return this.take(4, DataView.prototype.getUint32); }
  float32() { return this.take(4, DataView.prototype.getFloat32); }
  float64() { return this.take(8, DataView.prototype.getFloat64); }
  string() {
    const length = this.uint32();
    const bytes = new Uint8Array(this.view.buffer, this.view.byteOffset + this.at, length - 1);
    if (this.view.getUint8(this.at + length - 1) !== 0) throw new Error("a string has no end");
    this.at += length;
    return new TextDecoder().decode(bytes);
  }
  list(take) { return Array.from({ length: this.uint32() }, () => take.call(this)); }
  end() { if (this.at !== this.view.byteLength) throw new Error("bytes are left over"); }
}

function decode(schema, data) {
  if (schema.name === "somato.Exploration") return JSON.parse(new TextDecoder().decode(data));
  const cdr = new Cdr(data);
  let value;
  if (schema.name === "sensor_msgs/msg/JointState") {
    value = { stamp: [cdr.uint32(), cdr.uint32()], frame: cdr.string(), names: cdr.list(cdr.string),
              values: cdr.list(cdr.float64) };
    if (cdr.uint32() + cdr.uint32() !== 0) throw new Error("velocities or efforts");
  } else if (schema.name === "std_msgs/msg/Float32MultiArray") {
    const dim = cdr.list(() => ({ label: cdr.string(), size: cdr.uint32(), stride: cdr.uint32() }));
    value = { dim, offset: cdr.uint32(), values: cdr.list(cdr.float32) };
  } else {
    throw new Error(`unknown schema ${schema.name}`);
  }
  cdr.end();
  return value; // JSON has no NaN: it is printed as null.
}

function plain(message, channels, schemas) {
  const channel = channels.get(message.channelId);
  const schema = schemas.get(channel.schemaId);
  return { topic: channel.topic, time: String(message.logTime), sequence: message.sequence,
           metadata: Object.fromEntries(channel.metadata), schema: schema.name,
           value: decode(schema, message.data) };
}

async function streamed(path) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  const channels = new Map(), schemas = new Map(), messages = [];
  reader.append(await readFile(path));
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Schema") schemas.set(record.id, record);
    if (record.type === "Channel") channels.set(record.id, record);
    if (record.type === "Message") messages.push(plain(record, channels, schemas));
  }
  if (!reader.done() || reader.bytesRemaining() !== 0) throw new Error("the stream is not done");
  return messages;
}

async function indexed(path) {
  const file = await open(path);
  const { size } = await file.stat();
  const readable = {
    size: async () => BigInt(size),
    read: async (offset, length) => {
      const bytes = new Uint8Array(Number(length));
      await file.read(bytes, 0, bytes.length, Number(offset));
      return bytes;
    },
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const messages = [];
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    messages.push(plain(message, reader.channelsById, reader.schemasById));
  }
  const metadata = [];
  for await (const record of reader.readMetadata()) {
    metadata.push([record.name, Object.fromEntries(record.metadata)]);
  }
  await file.close();
  const { statistics } = reader;
  return { messages, metadata, profile: reader.header.profile, chunks: reader.chunkIndexes.length,
           compressions: [...new Set(reader.chunkIndexes.map((index) => index.compression))],
           summaryOffsets: reader.summaryOffsetsByOpcode.size,
           statistics: { messages: Number(statistics.messageCount), chunks: statistics.chunkCount,
                         schemas: statistics.schemaCount, channels: statistics.channelCount,
                         metadata: statistics.metadataCount,
                         start: String(statistics.messageStartTime),
                         end: String(statistics.messageEndTime) } };
}

const path = process.argv[2];
console.log(JSON.stringify({ stream: await streamed(path), indexed: await indexed(path) }));
