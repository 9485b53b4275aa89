// Writes an MCAP file with the official writer, its content fixed in the test.
// usage: node write.mjs FILE own|foreign none|lz4|zstd|unchunked

import { open } from "node:fs/promises";
import { McapWriter } from "@mcap/core";
import zstd from "@foxglove/wasm-zstd";

await zstd.isLoaded;
const [path, layout, compression] = process.argv.slice(2);

// An LZ4 frame whose blocks are stored as they are: no package compresses to LZ4.
function storedLz4(bytes) {
  const head = Buffer.from([0x04, 0x22, 0x4d, 0x18, 0x60, 0x70, 0x73]);
  const parts = [head];
  for (let at = 0; at < bytes.length; at += 1 << 20) {
    const block = bytes.subarray(at, at + (1 << 20));
    const size = Buffer.alloc(4);
    size.writeUInt32LE((block.length | 0x80000000) >>> 0);
    parts.push(size, block);
  }
  return Buffer.concat([...parts, Buffer.alloc(4)]);
}

const compressors = {
  lz4: (bytes) => ({ compression: "lz4", compressedData: storedLz4(bytes) }),
  zstd: (bytes) => ({ compression: "zstd", compressedData: zstd.compress(bytes, 3) }),
};

// Appends fields as CDR of the given byte order.
class Cdr {
  constructor(little) {
    this.little = little;
    this.bytes = [];
  }
  put(size, set, value) {
    while (this.bytes.length % size !== 0) this.bytes.push(0);
    const view = new DataView(new ArrayBuffer(size));
    view[set](0, value, this.little);
    this.bytes.push(...new Uint8Array(view.buffer));
    return this;
  }
  uint32(value) { return this.put(4, "setUint32", value); }
  string(value) {
    const bytes = new TextEncoder().encode(value + "\0");
    this.uint32(bytes.length).bytes.push(...bytes);
    return this;
  }
  list(values, put) {
    this.uint32(values.length);
    for (const value of values) put.call(this, value);
    return this;
  }
  float32(value) { return this.put(4, "setFloat32", value); }
  float64(value) { return this.put(8, "setFloat64", value); }
  done() { return new Uint8Array([0, this.little ? 1 : 0, 0, 0, ...this.bytes]); }
}

function jointState(names, position, little) {
  const cdr = new Cdr(little).uint32(0).uint32(0).string("hand").list(names, Cdr.prototype.string);
  return cdr.list(position, Cdr.prototype.float64).uint32(0).uint32(0).done();
}

function floatArray(shape, values, little, put = Cdr.prototype.float32) {
  const cdr = new Cdr(little).uint32(shape.length);
  shape.forEach((size, i) => {
    cdr.string("x").uint32(size).uint32(shape.slice(i).reduce((a, b) => a * b, 1));
  });
  return cdr.uint32(0).list(values, put).done();
}

const file = await open(path, "w");
let position = 0n;
const writable = {
  write: async (bytes) => {
    await file.write(bytes);
    position += BigInt(bytes.byteLength);
  },
  position: () => position,
};
const writer = new McapWriter({ writable, useChunks: compression !== "unchunked", chunkSize: 2000,
                                compressChunk: compressors[compression] });
await writer.start({ profile: layout === "own" ? "somato" : "ros2", library: "write.mjs" });

const text = (value) => new TextEncoder().encode(value);
const schema = (name, encoding = "ros2msg") =>
  writer.registerSchema({ name, encoding, data: text("made up") });
const channel = async (topic, schemaId, messageEncoding, metadata = {}) =>
  writer.registerChannel({ topic, schemaId, messageEncoding,
                           metadata: new Map(Object.entries(metadata)) });
const add = (channelId, logTime, data) =>
  writer.addMessage({ channelId, sequence: 0, logTime, publishTime: logTime, data });

const joints = await schema("sensor_msgs/msg/JointState");
const floats = await schema("std_msgs/msg/Float32MultiArray");

if (layout === "own") {
  const explorations = await channel("/exploration", await schema("somato.Exploration", "jsonschema"),
                                     "json");
  const hand = await channel("/joints", joints, "cdr", { unit: "deg", elements: '["a","b"]' });
  const touch = await channel("/touch", floats, "cdr", { unit: "counts", shape: "[2,3]", rate: "50" });
  const say = (time, message) => add(explorations, time, text(JSON.stringify(message)));
  let time = 5n;
  for (let index = 0; index < 30; ++index) {
    await say(time, { event: "begin", index, labels: [{ name: "object", value: `cup ${index % 3}` }],
                      source: "made", channels: ["touch", "joints"], zero: String(time) });
    for (let frame = 0; frame < 4; ++frame) {
      time += 250_000_000n;
      await add(hand, time, jointState(["a", "b"], [Math.PI / 2, (index * Math.PI) / 180], true));
      await add(touch, time, floatArray([2, 3], [index, frame, NaN, 0.25, 5, 6], true));
    }
    await say(time, { event: "end", index });
  }
} else {
  const odd = await channel("/camera", await schema("sensor_msgs/msg/Image"), "cdr");
  const hand = await channel("/robot/joint_states", joints, "cdr", { rate: "about thirty" });
  const touch = await channel("/skin", floats, "cdr");
  const wide = await channel("/wide", await schema("std_msgs/msg/Float64MultiArray"), "cdr");
  const start = 1_700_000_000_123_456_789n;
  for (let frame = 0; frame < 60; ++frame) {
    const time = start + BigInt(frame) * 10_000_000n;
    const little = frame % 2 === 0;
    await add(odd, time, new Uint8Array(100).fill(7));
    await add(hand, time, jointState(["elbow", "wrist"], [0.5, frame], little));
    await add(touch, time + 1n, floatArray([5, 12], Array.from({ length: 60 }, (_, i) => i + frame), little));
    await add(wide, time + 2n, floatArray([3], [1, 2, frame], little, Cdr.prototype.float64));
  }
  await writer.addAttachment({ name: "notes", logTime: start, createTime: start,
                               mediaType: "text/plain", data: text("felt soft") });
  await writer.addMetadata({ name: "lab", metadata: new Map([["room", "1"]]) });
}
await writer.end();
await file.close();
