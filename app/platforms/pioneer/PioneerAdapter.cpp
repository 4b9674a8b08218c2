// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter of robots that are reached over a line: the addresses that it opens, and the form for
// users.
#include <charconv>
#include <filesystem>

#include "app/core/platform/PlatformAdapter.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/pioneer/PioneerAddress.h"
#include "app/platforms/pioneer/PioneerCommands.h"
#include "app/platforms/pioneer/PioneerOptions.h"
#include "app/platforms/real/RealFeed.h"
#include "app/platforms/real/RealHeadless.h"
#include "robotlink/arcos/stream/SerialPorts.h"
#include "robotlink/arcos/stream/StreamUrl.h"
#include "robotlink/config/RobotDescription.h"

namespace app {
namespace {

namespace arcos = robotlink::arcos;
using Kind = PlatformField::Kind;
using robotlink::Result;

constexpr char kFirstAddress[] = "tcp://localhost:8101";
constexpr char kNetwork[] = "tcp", kSerial[] = "serial";

/// Whether a source is an address: "tcp://localhost:8101", or in short "localhost:8101" and "/dev/ttyUSB0".
/// Names of existing files are none.
bool isAddress(const std::string& source) {
  if (source.starts_with("tcp://") || source.starts_with("serial://")) return true;
  std::error_code ignored;
  const bool isFile =
      !source.starts_with("/dev/") && (source.starts_with('/') || std::filesystem::exists(source, ignored));
  return !isFile && PioneerAddress::parse(source).has_value();
}

Result<PlatformOpening> openPioneer(const PlatformChoices& choices) {
  RealRobotOptions options = pioneerOptions(choices.sources.front());
  if (const std::string layout = textOf(choices.values, "layout"); !layout.empty())
    options.program.layout = layoutNamed(layout);
  options.program.map = textOf(choices.values, "map");
  options.program.hosting.ownProcesses = flagOf(choices.values, ownProcessField().name);
  return RealFeed::opening(std::move(options));
}

// ---- The form: an address, or its parts

/// Returns the meaning of an address.
std::string meaningOf(const arcos::StreamUrl& url) {
  if (const auto* tcp = std::get_if<arcos::TcpAddress>(&url))
    return "over the network: " + tcp->host + ", port " + std::to_string(tcp->port);
  const auto& serial = std::get<arcos::SerialAddress>(url);
  return "over the serial line " + serial.device + " at " + std::to_string(serial.baud) + " baud";
}

std::string meaningOf(const PioneerAddress& address) {
  std::string text = meaningOf(address.line);
  if (address.laser) text += "; a SICK LMS 200 " + meaningOf(*address.laser);
  return text;
}

/// Sets the parts from the address.
void readAddress(FormValues& values, const PioneerAddress& address) {
  const arcos::StreamUrl& url = address.line;
  values["kind"] = address.kind;
  values["laser"] = address.laser ? toString(*address.laser) : std::string();
  if (const auto* tcp = std::get_if<arcos::TcpAddress>(&url)) {
    values["line"] = std::string(kNetwork);
    values["host"] = tcp->host;
    values["port"] = static_cast<double>(tcp->port);
  } else {
    const auto& serial = std::get<arcos::SerialAddress>(url);
    values["line"] = std::string(kSerial);
    values["device"] = serial.device;
    values["baud"] = std::to_string(serial.baud);
  }
}

/// Sets the address from the parts; of what has no part it keeps the rest.
void writeAddress(FormValues& values) {
  PioneerAddress address = PioneerAddress::parse(textOf(values, "address")).value_or(PioneerAddress());
  if (textOf(values, "line") == kNetwork) {
    address.line =
        arcos::TcpAddress{textOf(values, "host"), static_cast<std::uint16_t>(numberOf(values, "port"))};
  } else {
    arcos::SerialAddress serial{textOf(values, "device")};
    const std::string baud = textOf(values, "baud");
    std::from_chars(baud.data(), baud.data() + baud.size(), serial.baud);
    address.line = serial;
  }
  address.kind = textOf(values, "kind");
  address.laser.reset();
  std::string text = address.text();
  // The address as typed, so that an error about the laser quotes what the user wrote.
  if (const std::string laser = textOf(values, "laser"); !laser.empty())
    text += (text.find('?') == std::string::npos ? "?laser=" : "&laser=") + laser;
  values["address"] = text;
}

PlatformField::Items deviceItems() {
  PlatformField::Items items;
  for (const auto& port : arcos::serialPorts()) items.push_back({port.device, port.device, port.description});
  return items;
}

void followAddress(FormState& state, const std::string& changed) {
  FormValues& values = state.values;
  for (const char* part : {"line", "host", "port", "device", "baud", "kind", "laser"}) {
    if (changed == part) writeAddress(values);
  }
  const auto url = PioneerAddress::parse(textOf(values, "address"));
  if (url && (changed.empty() || changed == "address")) readAddress(values, *url);
  const bool network = textOf(values, "line") == kNetwork;
  for (const char* part : {"device", "baud"}) {
    if (network) state.hidden.insert(part);
  }
  for (const char* part : {"host", "port"}) {
    if (!network) state.hidden.insert(part);
  }
  const std::string address = textOf(values, "address");
  const bool isProgram = address.starts_with("ws://") || address.starts_with("wss://");
  const std::string problem =
      isProgram
          ? "a robot's program runs at this address, so it is not a Pioneer's line: choose Robot > Connect…"
          : (url ? std::string() : url.error().text);
  state.notes["address"] = {problem.empty() ? meaningOf(*url) : problem, !problem.empty()};
  state.complete = url.has_value();
}

/// The same robot always has the same address.
void normalizeAddress(FormValues& values) {
  if (const auto url = PioneerAddress::parse(textOf(values, "address"))) values["address"] = url->text();
}

/// The layouts that the program of such a robot can run in.
PlatformField::Items layoutItems() {
  PlatformField::Items items{{.title = "of the robot", .value = ""}};
  const auto description = readRobot(pioneerOptions({}).kind);
  if (!description) return items;
  for (const auto& file : layoutsFor(**description))
    items.push_back({file.stem().string(), file.stem().string()});
  return items;
}

PlatformField::Items baudItems() {
  PlatformField::Items items;
  for (const char* rate : {"9600", "19200", "38400", "57600", "115200"}) items.push_back({rate, rate});
  return items;
}

std::vector<PlatformField> lineFields() {
  return {
      {.name = "line",
       .kind = Kind::kChoice,
       .label = "Line:",
       .initial = std::string(kNetwork),
       .items =
           [] {
             return PlatformField::Items{
                 {.title = "&Network (TCP)",
                  .value = kNetwork,
                  .help = "A simulated robot, or one whose serial line a computer forwards"},
                 {.title = "&Serial", .value = kSerial, .help = "A robot at a serial port of this computer"}};
           },
       .buttons = true,
       .isArgument = false},
      {.name = "host",
       .label = "&Host:",
       .help = "Name or address of the computer; localhost is this one",
       .isArgument = false},
      {.name = "port",
       .kind = Kind::kNumber,
       .label = "port",
       .help = "8101 for the first robot, 8102 for the next",
       .initial = static_cast<double>(arcos::kDefaultPort),
       .noun = "port",
       .min = 1,
       .max = 65535,
       .sameRow = true,
       .isArgument = false},
      {.name = "device",
       .kind = Kind::kChoice,
       .label = "&Port:",
       .help = "Serial ports of this computer; another one can be typed",
       .emptyText = "no serial port found; type its path",
       .items = deviceItems,
       .editable = true,
       .listAgain = "Searches for serial ports",
       .isArgument = false},
      {.name = "baud",
       .kind = Kind::kChoice,
       .label = "at",
       .help = "As set in the robot; Pioneers use 9600 by default",
       .initial = std::string("9600"),
       .unit = "baud",
       .items = baudItems,
       .sameRow = true,
       .isArgument = false}};
}

/// The fields about the robot itself.
std::vector<PlatformField> pioneerFields() {
  return {{.name = "kind",
           .label = "&Kind:",
           .help = "The robot's description: p3at, p3dx, peoplebot or one of your own",
           .initial = PioneerAddress().kind,
           .isArgument = false},
          {.name = "laser",
           .kind = Kind::kChoice,
           .label = "La&ser:",
           .help = "Line of a SICK LMS 200, such as /dev/ttyUSB1; empty: the robot has none",
           .emptyText = "none",
           .items = deviceItems,
           .editable = true,
           .isArgument = false}};
}

PlatformForm pioneerForm() {
  PlatformForm form{.name = "connect",
                    .command = "robot.connect",
                    .commandHelp =
                        "Connects a Pioneer over TCP or a serial line and runs its program here; it stays "
                        "connected until something else is opened",
                    .menu = "robot",
                    .entry = "Connect a &Pioneer…",
                    .action = "robot.connect",
                    .icon = "connect",
                    .keys = "Ctrl+K",
                    .entryHelp = "Connects a robot over TCP or a serial line, and runs its program here",
                    .title = "Connect to a robot",
                    .accept = "&Connect",
                    .connects = true};
  form.fields = {{.name = "address",
                  .kind = Kind::kChoice,
                  .label = "&Address:",
                  .help =
                      "HOST:PORT, tcp://HOST[:PORT] or serial://DEVICE[?baud=RATE]; the list has the recent "
                      "ones",
                  .initial = std::string(kFirstAddress),
                  .noun = "address",
                  .editable = true,
                  .isSource = true,
                  .remembered = "recent_robots",
                  .recent = true}};
  for (auto& field : lineFields()) form.fields.push_back(std::move(field));
  for (auto& field : pioneerFields()) form.fields.push_back(std::move(field));
  form.fields.push_back({.name = "layout",
                         .kind = Kind::kChoice,
                         .label = "&Layout:",
                         .help = "Process layout (which process runs which tasks): a file or the "
                                 "name of a shipped one; empty: the robot's",
                         .noun = "layout",
                         .items = layoutItems,
                         .editable = true});
  form.fields.push_back({.name = "map",
                         .kind = Kind::kFile,
                         .label = "&Map:",
                         .help = "Map of the area where the robot drives, for localization; may be empty",
                         .emptyText = "none: no localization in a map",
                         .files = "Maps (*.map)",
                         .option = "--map",
                         .remembered = "robot_map"});
  form.fields.push_back(ownProcessField());
  form.follow = followAddress;
  form.normalize = normalizeAddress;
  return form;
}

constexpr char kMotors[] = "motors";

HeadlessPlatform headlessPioneer() {
  return headlessReal({.help = "a Pioneer: tcp://HOST[:PORT], serial://DEVICE[?baud=RATE]",
                       .usage = "a robot's address: tcp://HOST:PORT or serial://DEVICE?baud=RATE",
                       .robot = pioneerOptions({}).robot,
                       .options = {{.name = kMotors,
                                    .kind = Kind::kFlag,
                                    .help = "Robots: switches the motors on as soon as it is connected",
                                    .initial = false,
                                    .option = "--motors"}},
                       .robotOf = [](const std::string& url, const FormValues& values) {
                         return pioneerOptions(url, flagOf(values, kMotors));
                       }});
}

const PlatformRegistration kPioneerRegistration{
    {.name = kPioneerAdapter,
     .sources = "a Pioneer's address, tcp://HOST[:PORT] or serial://DEVICE[?baud=RATE]",
     .time = TimeKind::kReal,
     .opens = isAddress,
     .order = 2,
     .open = openPioneer,
     .perspective = [](const std::string&) { return "Drive"; },
     .form = pioneerForm,
     .headless = headlessPioneer,
     .commands = addPioneerCommands}};

}  // namespace
}  // namespace app
