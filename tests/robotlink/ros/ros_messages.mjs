// SPDX-License-Identifier: GPL-3.0-or-later
// Writes messages of ROS 1 and ROS 2 with the npm packages @foxglove/rosmsg, @foxglove/ros2idl-parser,
// @foxglove/rosmsg-serialization and @foxglove/rosmsg2-serialization.
//
//   ros_messages.mjs           prints them, one JSON object a line: what they are, their bytes, their values
//   ros_messages.mjs FOLDER    writes larger ones for the benchmark: NAME.type, NAME.msg, NAME.cdr; then prints how
//                              long npm takes to decode each: NAME NANOSECONDS
//
// The packages are looked for in the folder ROBOTCONTROL_NODE_MODULES, or where node looks. Exit status 77: they are
// not there.
import { createRequire } from "node:module";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

const folder = process.env.ROBOTCONTROL_NODE_MODULES;
const require = createRequire(folder ? join(folder, "/") : import.meta.url);
const load = (name) => require(folder ? join(folder, name) : name);
let parse, parseRos2idl, ros1, ros2;
try {
  ({ parse } = load("@foxglove/rosmsg"));
  ({ parseRos2idl } = load("@foxglove/ros2idl-parser"));
  ros1 = load("@foxglove/rosmsg-serialization");
  ros2 = load("@foxglove/rosmsg2-serialization");
} catch (error) {
  console.error(String(error.message).split("\n")[0]);
  process.exit(77);
}

const line = `\n${"=".repeat(80)}\nMSG: `;
const header = `${line}std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id`;
const header1 = `${line}std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id`;
const vector = `${line}geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z`;
const quaternion = `${line}geometry_msgs/Quaternion\nfloat64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1`;

const definitions = {
  imu: `std_msgs/Header header
geometry_msgs/Quaternion orientation
float64[9] orientation_covariance # row major
geometry_msgs/Vector3 angular_velocity
float64[9] angular_velocity_covariance
geometry_msgs/Vector3 linear_acceleration
float64[9] linear_acceleration_covariance${quaternion}${vector}`,
  laser: `std_msgs/Header header
float32 angle_min
float32 angle_max
float32 angle_increment
float32 time_increment
float32 scan_time
float32 range_min
float32 range_max
float32[] ranges
float32[] intensities`,
  joints: `std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort`,
  transforms: `geometry_msgs/TransformStamped[] transforms${line}geometry_msgs/TransformStamped
std_msgs/Header header\nstring child_frame_id\nTransform transform${line}geometry_msgs/Transform
Vector3 translation\nQuaternion rotation${vector}${quaternion}`,
  image: `std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\nuint8[] data`,
  everything: `bool flag\nbyte b\nchar c\nint8 i8\nuint8 u8\nint16 i16\nuint16 u16\nint32 i32\nuint32 u32
int64 i64\nuint64 u64\nfloat32 f32\nfloat64 f64\nstring text "some # text"\nint32 LIMIT=7
bool[] flags\nint8[] i8s\nuint8[3] u8s\nint16[2] i16s\nuint16[] u16s\nint32[] i32s\nuint32[] u32s
int64[] i64s\nuint64[2] u64s\nfloat32[] f32s\nfloat64[] f64s\nstring[] texts\nEmpty empty\nInner[2] inners
time stamp\nduration[] durations${line}p/Empty\n${line}p/Inner\nuint8 a\nfloat64 b\nstring c`,
};
const idlFile = (name, body) => {
  const [folder, type] = name.split("/msg/");
  return `${"=".repeat(80)}\nIDL: ${name}\nmodule ${folder} {\n  module msg {\n${body.replace("TYPE", type)}  };\n};\n`;
};
const idl = idlFile("sensor_msgs/msg/Imu", `    typedef double double__9[9];
    @verbatim (language="comment", text="About it; \\"all\\"" "of it")
    struct TYPE {
      std_msgs::msg::Header header; geometry_msgs::msg::Quaternion orientation;
      @unit (value="rad^2") double__9 orientation_covariance;
      geometry_msgs::msg::Vector3 angular_velocity; double__9 angular_velocity_covariance;
      geometry_msgs::msg::Vector3 linear_acceleration; double__9 linear_acceleration_covariance;
    };\n`) + idlFile("std_msgs/msg/Header", "struct TYPE { builtin_interfaces::msg::Time stamp; string frame_id; };\n")
  + idlFile("builtin_interfaces/msg/Time", "struct TYPE { int32 sec; uint32 nanosec; };\n")
  + idlFile("geometry_msgs/msg/Vector3", "struct TYPE { double x; double y; double z; };\n")
  + idlFile("geometry_msgs/msg/Quaternion", `struct TYPE { @default (value=0.0) double x; double y; double z;
      @default (value=1.0) double w; };\n`);
const types = { imu: "sensor_msgs/Imu", laser: "sensor_msgs/LaserScan", joints: "sensor_msgs/JointState",
  transforms: "tf2_msgs/TFMessage", image: "sensor_msgs/Image", everything: "p/Everything" };

const point = (i) => ({ x: i, y: -i / 2, z: 1e-3 * i });
const turn = { x: 0, y: 0, z: Math.sqrt(0.5), w: Math.sqrt(0.5) };
const numbers = (count, f) => Array.from({ length: count }, (_, i) => f(i));
const stamped = (nanos) => ({ seq: 3, stamp: { sec: 1_700_000_000, [nanos]: 123_456_789 }, frame_id: "base_link" });
const values = (size, nanos) => ({
  imu: { header: stamped(nanos), orientation: turn, orientation_covariance: numbers(9, (i) => i), angular_velocity: point(1),
    angular_velocity_covariance: numbers(9, (i) => -i), linear_acceleration: point(9.81),
    linear_acceleration_covariance: numbers(9, (i) => i / 7) },
  laser: { header: stamped(nanos), angle_min: -1.5, angle_max: 1.5, angle_increment: 0.25, time_increment: 0, scan_time: 0.125,
    range_min: 0.0625, range_max: 30, ranges: numbers(size * 36, (i) => i / 4), intensities: numbers(size * 36, (i) => i) },
  joints: { header: stamped(nanos), name: numbers(size, (i) => `leg_joint_${i}`), position: numbers(size, (i) => i / 3),
    velocity: numbers(size, (i) => -i / 3), effort: [] },
  transforms: { transforms: numbers(size, (i) => ({ header: stamped(nanos), child_frame_id: `link_${i}`,
    transform: { translation: point(i), rotation: turn } })) },
  image: { header: stamped(nanos), height: size * 24, width: size * 32, encoding: "rgb8", is_bigendian: 0, step: size * 96,
    data: Uint8Array.from(numbers(size * 24 * size * 96, (i) => i & 255)) },
  everything: { flag: true, b: 5, c: 200, i8: -128, u8: 255, i16: -32768, u16: 65535, i32: -2147483648, u32: 4294967295,
    i64: -(2n ** 63n), u64: 2n ** 64n - 1n, f32: 0.5, f64: Math.PI, text: "size" /* their writer counts no UTF-8 */, flags: [true, false, true], i8s: [-1, 2],
    u8s: Uint8Array.of(1, 2, 255), i16s: [-3, 4], u16s: [65535], i32s: [-5, 6, 7], u32s: [4294967295], i64s: [-8n], u64s: [9n, 10n],
    f32s: [1.5, -2.5], f64s: [], texts: ["", "a", "bcd"], empty: {}, inners: [{ a: 1, b: 2, c: "x" }, { a: 3, b: 4, c: "" }],
    stamp: { sec: 7, [nanos]: 8 }, durations: [{ sec: 1, [nanos]: 500_000_000 }] },
});

// ROS 1 has none.
const withoutDefaults = (definition) => definition.replace(/^(float64 [xyzw]|string text) .*$/gm, "$1");
const plain = (key, value) => typeof value === "bigint" ? { integer: String(value) }
  : ArrayBuffer.isView(value) ? { bytes: Buffer.from(value).toString("hex") }
  : value !== null && value.sec !== undefined ? { seconds: value.sec, nanos: value.nanosec ?? value.nsec } : value;

function printKnown() {
  for (const [name, value] of Object.entries(values(2, "nanosec"))) {
    const definition = definitions[name] + header;
    const bytes = new ros2.MessageWriter(parse(definition, { ros2: true })).writeMessage(value);
    console.log(JSON.stringify({ type: types[name].replace("/", "/msg/"), schemaEncoding: "ros2msg", encoding: "cdr",
      definition, bytes: Buffer.from(bytes).toString("hex"), value }, plain));
  }
  // Their parser of IDL calls it so.
  const { imu } = values(2, "nsec");
  const bytes = new ros2.MessageWriter(parseRos2idl(idl)).writeMessage(imu);
  console.log(JSON.stringify({ type: "sensor_msgs/msg/Imu", schemaEncoding: "ros2idl", encoding: "cdr", definition: idl,
    bytes: Buffer.from(bytes).toString("hex"), value: imu }, plain));
  for (const [name, value] of Object.entries(values(2, "nsec"))) {
    const definition = withoutDefaults(definitions[name]) + header1;
    const bytes = new ros1.MessageWriter(parse(definition)).writeMessage(value);
    console.log(JSON.stringify({ type: types[name], schemaEncoding: "ros1msg", encoding: "ros1",
      definition, bytes: Buffer.from(bytes).toString("hex"), value }, plain));
  }
}

// What outlives the buffer, as the messages of a history do, has to be copied out of it.
let kept;
function bestTime(reader, bytes, copies) {
  let best = Infinity;
  for (let round = 0; round < 20; ++round) {
    const count = 2000;
    const begin = process.hrtime.bigint();
    for (let i = 0; i < count; ++i) {
      const message = reader.readMessage(bytes);
      if (copies) for (const value of Object.values(message)) if (ArrayBuffer.isView(value)) kept = value.slice();
    }
    best = Math.min(best, Number(process.hrtime.bigint() - begin) / count);
  }
  return best;
}

function measure(target) {
  for (const [name, value] of Object.entries(values(20, "nanosec"))) {
    const definition = definitions[name] + header;
    const parsed = parse(definition, { ros2: true });
    const bytes = new ros2.MessageWriter(parsed).writeMessage(value);
    writeFileSync(join(target, `${name}.type`), types[name]);
    writeFileSync(join(target, `${name}.msg`), definition);
    writeFileSync(join(target, `${name}.cdr`), bytes);
    const reader = new ros2.MessageReader(parsed);
    const best = [false, true].map((copies) => bestTime(reader, bytes, copies));
    console.log(`${name} ${best.map((time) => time.toFixed(0)).join(" ")}`);
  }
}

if (process.argv[2] === undefined) printKnown();
else measure(process.argv[2]);
