#!/usr/bin/env node
// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes MCAP files with the format's own @mcap/core, and messages with Foxglove's serialization of
// ROS 1 and ROS 2, and expected.json with what stands in them, into a folder.
//
//   write_mcaps.mjs FOLDER
//
// Exit 77 where a package is missing: npm ci in this folder.

import { createRequire } from "node:module";
import { openSync, writeFileSync, writeSync, closeSync } from "node:fs";
import { join } from "node:path";

const require = createRequire(import.meta.url);
let mcap, lz4, zstd, rosmsg, ros1, ros2;
try {
  mcap = require("@mcap/core");
  lz4 = require("lz4js");
  zstd = require("@foxglove/wasm-zstd");
  rosmsg = require("@foxglove/rosmsg");
  ros1 = require("@foxglove/rosmsg-serialization");
  ros2 = require("@foxglove/rosmsg2-serialization");
} catch (error) {
  console.error(error.message.split("\n")[0]);
  process.exit(77);
}

// Of a sequence 32 elements are fields, of an array of fixed length 64.
const MOST_OF_SEQUENCE = 32;
const MOST_OF_ARRAY = 64;

const MEMBERS = `
int32 CONSTANT=5
bool a
int8 b
int64 h
uint8 c
int16 d
float64 k
uint16 e
uint64 i
int32 f
float32 j
uint32 g
string n
float64[] doubles
int16[3] shorts
uint8[] bytes
string[] words
INNER inner
INNER[] inners
INNER[2] pair
float64 last
`;
const INNER = "string word\nfloat64[] x\nint8 y\n";
const SEPARATOR = "=".repeat(80) + "\n";

const ROS1_TEXT =
  "Header header\ntime t1\nduration t2\ntime[] t3\n" + MEMBERS.replaceAll("INNER", "fathom/Inner") +
  SEPARATOR + "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n" +
  SEPARATOR + "MSG: fathom/Inner\n" + INNER;
// Bounds and default values are of ROS 2 only.
const ROS2_TEXT =
  "float64[<=5] bounded\nstring<=10 brief\nint32 preset 7\nchar p\nstd_msgs/Header header\nbuiltin_interfaces/Time t1\nbuiltin_interfaces/Duration t2\n" +
  "builtin_interfaces/Time[] t3\n" + MEMBERS.replaceAll("INNER", "fathom/Inner") +
  SEPARATOR + "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" +
  SEPARATOR + "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" +
  SEPARATOR + "MSG: builtin_interfaces/Duration\nint32 sec\nuint32 nanosec\n" +
  SEPARATOR + "MSG: fathom/Inner\n" + INNER;

const range = (count, make) => Array.from({ length: count }, (_, i) => make(i));

function messageOf(k, time) {
  const inner = (j) => ({ word: "w".repeat(j), x: range((j + k) % 3, () => 1.5 * k), y: j });
  return {
    header: { seq: k, stamp: time, frame_id: "f".repeat(k % 5) },
    t1: time, t2: { sec: -k, nsec: 5 }, t3: range(k % 3, () => time),
    a: k % 2 === 1, b: -k % 100, c: 255 - k % 100, d: -32768 + k, e: 65535 - k,
    f: -(2 ** 31) + k, g: 2 ** 32 - 1 - k, h: -(2n ** 63n) + BigInt(k), i: 2n ** 64n - 1n - BigInt(k),
    j: 0.1, k: 0.1 * k, n: "x".repeat(k % 9),
    doubles: range((7 * k + 3) % 40, (j) => 0.5 * j), shorts: [k, -k, 1],
    bytes: Uint8Array.from(range(k % 5, (j) => j)), words: range(k % 3, () => "abcd"),
    inner: inner(0), inners: range(1 + k % 3, inner), pair: [inner(1), inner(2)],
    bounded: range(k % 6, (j) => j + 0.5 * k), brief: "y".repeat(k % 10), preset: -k, p: k % 256,
    last: Math.PI * k,
  };
}

// The numbers of a message by path, as definitions of @foxglove/rosmsg say.
function numbersOf(types, type, value, prefix, out) {
  for (const member of type.definitions) {
    if (member.isConstant || member.type === "string") continue;
    const put = (element, path) => {
      if (member.isComplex) {
        const inner = types.find((t) => t.name === member.type);
        numbersOf(types, inner, element, path + ".", out);
      } else if (member.type === "time" || member.type === "duration") {
        out[path] = element.sec + 1e-9 * element.nsec;
      } else {
        out[path] = member.type === "float32" ? Math.fround(element) : Number(element);
      }
    };
    const path = prefix + member.name;
    const element = value[member.name];
    if (!member.isArray) {
      put(element, path);
      continue;
    }
    const most = member.arrayLength === undefined ? MOST_OF_SEQUENCE : MOST_OF_ARRAY;
    Array.from(element).slice(0, most).forEach((e, i) => put(e, `${path}[${i}]`));
  }
}

const KINDS = [
  { topic: "/ros1", name: "fathom/Every", profile: "ros1", schema: "ros1msg", encoding: "ros1",
    text: ROS1_TEXT, parse: (text) => rosmsg.parse(text), writer: ros1.MessageWriter },
  { topic: "/ros2", name: "fathom/msg/Every", profile: "ros2", schema: "ros2msg", encoding: "cdr",
    text: ROS2_TEXT, parse: (text) => rosmsg.parse(text, { ros2: true }),
    writer: ros2.MessageWriter },
];

// A writer's options, `count` messages of each kind of `kinds`; what stands in the file.
async function write(path, kinds, count, options) {
  const file = openSync(path, "w");
  let position = 0n;
  const writer = new mcap.McapWriter({
    writable: {
      position: () => position,
      write: async (bytes) => {
        position += BigInt(bytes.length);
        writeSync(file, bytes);
      },
    },
    ...options,
  });
  await writer.start({ profile: kinds[0].profile, library: "fathom" });
  const channels = {};
  const streams = [];
  for (const kind of kinds) {
    const types = kind.parse(kind.text);
    const schemaId = await writer.registerSchema({
      name: kind.name, encoding: kind.schema, data: new TextEncoder().encode(kind.text) });
    // Two nodes may publish the same topic.
    for (const node of ["a", "b"]) {
      const id = await writer.registerChannel({
        schemaId, topic: kind.topic, messageEncoding: kind.encoding, metadata: new Map([["node", node]]) });
      streams.push({ kind, types, id, writer: new kind.writer(types) });
    }
  }
  for (let k = 0; k < count; ++k) {
    for (const stream of streams) {
      const time = { sec: 1500000000 + k, nsec: 250000000 + stream.id };
      const message = messageOf(k, time);
      const logTime = BigInt(time.sec) * 1000000000n + 333333333n + BigInt(stream.id);
      await writer.addMessage({
        channelId: stream.id, sequence: k, logTime, publishTime: logTime - 1000n,
        data: stream.writer.writeMessage(message) });
      const root = stream.types.find((type) => type.name === undefined);
      const numbers = {};
      numbersOf(stream.types, root, message, "", numbers);
      const channel = (channels[stream.kind.topic] ??= {
        type: stream.kind.name, time: [],
        fields: Object.fromEntries(Object.keys(numbers).map((name) => [name, []])) });
      channel.time.push(
        Number(logTime / 1000000000n) + 1e-9 * Number(logTime % 1000000000n));
      for (const [name, values] of Object.entries(channel.fields)) {
        values.push(numbers[name] ?? null);
      }
    }
    if (k === 10) {
      await writer.addAttachment({
        name: "notes.txt", logTime: 5n, createTime: 6n, mediaType: "text/plain",
        data: new Uint8Array(3000) });
      await writer.addMetadata({ name: "vehicle", metadata: new Map([["name", "rov"]]) });
    }
  }
  await writer.end();
  closeSync(file);
  return { format: "mcap", channels, remarks: [] };
}

const COMPRESSIONS = {
  none: undefined,
  lz4: (data) => ({ compression: "lz4", compressedData: lz4.compress(data) }),
  zstd: (data) => ({ compression: "zstd", compressedData: zstd.compress(data, 3) }),
};
const NO_SUMMARY = {
  useStatistics: false, useSummaryOffsets: false, repeatSchemas: false, repeatChannels: false,
  useAttachmentIndex: false, useMetadataIndex: false, useMessageIndex: false, useChunkIndex: false,
};

await zstd.isLoaded;
const folder = process.argv[2];
const files = {};
for (const [summary, extra] of [["", {}], ["_bare", NO_SUMMARY]]) {
  for (const [compression, compressChunk] of Object.entries(COMPRESSIONS)) {
    for (const chunkSize of [5000, 1000000]) {
      const name = `${compression}_${chunkSize}${summary}.mcap`;
      files[name] = await write(join(folder, name), KINDS, 60, { ...extra, chunkSize, compressChunk });
    }
  }
  const name = `unchunked${summary}.mcap`;
  files[name] = await write(join(folder, name), KINDS, 60, { ...extra, useChunks: false });
}
for (const kind of KINDS) {
  files[`${kind.profile}.mcap`] = await write(join(folder, `${kind.profile}.mcap`), [kind], 200, {});
}
writeFileSync(join(folder, "expected.json"), JSON.stringify(files));
