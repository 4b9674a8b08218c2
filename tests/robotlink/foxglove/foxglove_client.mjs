// SPDX-License-Identifier: GPL-3.0-or-later
// Talks to a server with the client of the npm package @foxglove/ws-protocol and prints what it hears, a line each.
//
// Usage: foxglove_client.mjs URL, or --check: prints the path of the program ws-protocol-examples. The packages
// @foxglove/ws-protocol, @foxglove/ws-protocol-examples and ws are looked for in the folder
// ROBOTCONTROL_NODE_MODULES, or where node looks. Exit status 77: they are not there.
import { createRequire } from "node:module";
import { dirname, join } from "node:path";

const folder = process.env.ROBOTCONTROL_NODE_MODULES;
const require = createRequire(folder ? join(folder, "/") : import.meta.url);
const name = (text) => (folder ? join(folder, text) : text);

let FoxgloveClient, WebSocket;
try {
  ({ FoxgloveClient } = require(name("@foxglove/ws-protocol")));
  WebSocket = require(name("ws"));
  const description = require.resolve(name("@foxglove/ws-protocol-examples/package.json"));
  if (process.argv[2] === "--check") {
    console.log(join(dirname(description), require(description).bin["ws-protocol-examples"]));
    process.exit(0);
  }
} catch (error) {
  console.error(String(error.message).split("\n")[0]);
  process.exit(77);
}

const text = (data) => new TextDecoder().decode(data);
const bytes = (data) => new Uint8Array(Buffer.from(data));
const ws = new WebSocket(process.argv[2], ["foxglove.sdk.v1", FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
// The client insists on the older name, which has the same messages.
const client = new FoxgloveClient({ ws: new Proxy(ws, {
  get: (it, key) => key === "protocol" && it.protocol ? FoxgloveClient.SUPPORTED_SUBPROTOCOL
    : typeof it[key] === "function" ? it[key].bind(it) : it[key],
  set: (it, key, value) => ((it[key] = value), true),
}) });
client.on("error", (error) => console.log(`error ${error}`));
client.on("close", () => console.log("close"));
client.on("status", (event) => console.log(`status ${event.level} ${event.message}`));
client.on("serverInfo", (event) => {
  console.log(`serverInfo ${ws.protocol} ${event.name} ${event.capabilities.join(" ")}`);
  client.subscribeConnectionGraph();
  client.getParameters([], "all");
  client.fetchAsset("a.stl", 1);
  const channel = client.advertise({ topic: "drive", encoding: "json", schemaName: "Drive" });
  client.sendMessage(channel, bytes('{"speed":1}'));
});
client.on("connectionGraphUpdate", (event) => console.log(`graph ${JSON.stringify(event.publishedTopics)}`));
client.on("parameterValues", (event) => console.log(`parameters ${event.id} ${JSON.stringify(event.parameters)}`));
client.on("fetchAssetResponse", (event) =>
  console.log(`asset ${event.requestId} ${event.status} ${event.status === 0 ? text(event.data) : event.error}`));
client.on("advertiseServices", (services) => {
  const { id, name, request } = services[0];
  console.log(`service ${name} ${request.schemaName}`);
  client.sendServiceCallRequest({ serviceId: id, callId: 7, encoding: "json", data: bytes("{}") });
});
client.on("serviceCallResponse", (event) => console.log(`answer ${event.callId} ${event.encoding} ${text(event.data)}`));
client.on("advertise", (channels) => {
  for (const { id, topic, schema } of channels) {
    console.log(`channel ${topic} ${schema}`);
    client.subscribe(id);
  }
});
client.on("message", (event) => console.log(`message ${event.timestamp} ${text(event.data)}`));
client.on("time", (event) => console.log(`time ${event.timestamp}`));
