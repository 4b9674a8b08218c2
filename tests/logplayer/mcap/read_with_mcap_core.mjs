// SPDX-License-Identifier: GPL-3.0-or-later
// Reads an MCAP file with the npm package @mcap/core and prints what is in it, a line each, by its indexed reader
// and by its stream reader, both with CRC checks:
//
//   indexed TOPIC SEQUENCE LOG_TIME PUBLISH_TIME DATA_IN_HEX
//   stream  ...
//
// Usage: read_with_mcap_core.mjs FILE, or --check. The packages @mcap/core and @mcap/support are looked for in the
// folder ROBOTCONTROL_NODE_MODULES, or where node looks. Exit status 77: they are not there.
import { createRequire } from "node:module";
import { open, readFile } from "node:fs/promises";
import { join } from "node:path";
import zlib from "node:zlib";

async function load() {
  const folder = process.env.ROBOTCONTROL_NODE_MODULES;
  const require = createRequire(folder ? join(folder, "/") : import.meta.url);
  const find = (name) => (folder ? require(join(folder, name)) : require(name));
  try {
    return { core: find("@mcap/core"), support: find("@mcap/support") };
  } catch (error) {
    console.error(String(error.message).split("\n")[0]);
    process.exit(77);
  }
}

function print(reader, channel, message) {
  const data = Buffer.from(message.data).toString("hex");
  console.log(`${reader} ${channel.topic} ${message.sequence} ${message.logTime} ${message.publishTime} ${data}`);
}

async function readIndexed(file, core, decompressHandlers) {
  const handle = await open(file);
  const readable = {
    size: async () => BigInt((await handle.stat()).size),
    read: async (offset, size) => {
      const buffer = new Uint8Array(Number(size));
      await handle.read(buffer, 0, Number(size), Number(offset));
      return buffer;
    },
  };
  const reader = await core.McapIndexedReader.Initialize({ readable, decompressHandlers });
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    print("indexed", reader.channelsById.get(message.channelId), message);
  }
  for await (const attachment of reader.readAttachments({ validateCrcs: true })) {
    console.log(`attachment ${attachment.name} ${Buffer.from(attachment.data).toString("hex")}`);
  }
  for await (const metadata of reader.readMetadata()) {
    console.log(`metadata ${metadata.name} ${JSON.stringify([...metadata.metadata])}`);
  }
  console.log(`statistics ${reader.statistics.messageCount} in ${reader.statistics.chunkCount} chunks`);
  if (zlib.crc32) {
    const bytes = await readFile(file);
    const crc = zlib.crc32(bytes.subarray(0, Number(reader.dataEndOffset)));
    if (crc !== reader.dataSectionCrc) throw new Error("the CRC of the data section is wrong");
  }
  await handle.close();
}

async function readStream(file, core, decompressHandlers) {
  const reader = new core.McapStreamReader({ decompressHandlers, validateCrcs: true });
  const channels = new Map();
  reader.append(await readFile(file));
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Channel") channels.set(record.id, record);
    if (record.type === "Message") print("stream", channels.get(record.channelId), record);
  }
  if (!reader.done()) throw new Error("the stream is not complete");
}

const { core, support } = await load();
if (process.argv[2] === "--check") process.exit(0);
const decompressHandlers = await support.loadDecompressHandlers();
await readIndexed(process.argv[2], core, decompressHandlers);
await readStream(process.argv[2], core, decompressHandlers);
