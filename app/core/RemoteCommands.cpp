// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/RemoteCommands.h"

#include <map>
#include <string>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"

namespace app {

using Type = robotlink::CommandTable::Type;

namespace {

robotlink::Result<void> limitRemote(OpenPlatform& open, const Values& values) {
  using Images = RemoteRobots::Limits::Images;
  const double bytes = number(values, 1);
  const std::string& name = text(values, 2);
  const std::map<std::string, Images> images{
      {"auto", Images::kAutomatic}, {"raw", Images::kRaw}, {"jpeg", Images::kJpeg}};
  const auto found = images.find(name);
  if (found == images.end())
    return robotlink::failure("remote.images", "images are sent auto, raw or jpeg, not " + name, {}, {name});
  if (!(bytes >= 0)) return robotlink::failure("remote.limit", "a limit is a number of bytes a second, or 0");
  return open.limitRemote(text(values, 0), {bytes, found->second});
}

}  // namespace

void addRemoteCommands(robotlink::CommandTable& commands, OpenPlatform& open) {
  commands.add(
      {"remote.connect",
       "Connects robots whose programs run elsewhere, beside those that are open here",
       {{"url", Type::kText, "ws://HOST[:PORT]"}, {"token", Type::kText, "that the robot asks for, or ''"}},
       [&open](const Values& values) { return open.connectRemote(text(values, 0), text(values, 1)); }});
  commands.add(
      {"remote.trust",
       "Trusts the certificate that a robot elsewhere shows, from now on, and connects it",
       {{"url", Type::kText, "as it was connected"},
        {"fingerprint", Type::kText, "SHA256:..., as the robot has printed it at its start"}},
       [&open](const Values& values) { return open.trustRemote(text(values, 0), text(values, 1)); }});
  commands.add({"remote.show-token",
                "Shows a token to a robot elsewhere that asks for one",
                {{"url", Type::kText, "as it was connected"},
                 {"token", Type::kText, "one of the two that the robot has printed"}},
                [&open](const Values& values) { return open.showToken(text(values, 0), text(values, 1)); }});
  commands.add({"remote.remember-token",
                "Remembers the token of a connection on this computer, once the robot has accepted it",
                {{"url", Type::kText, "as it was connected"}},
                [&open](const Values& values) { return open.rememberToken(text(values, 0)); }});
  commands.add({"remote.forget-token",
                "Forgets the token that is remembered for a robot elsewhere",
                {{"url", Type::kText, "as it was connected"}},
                [](const Values& values) { return RemoteRobots::forgetToken(text(values, 0)); }});
  commands.add({"remote.disconnect",
                "Ends the connection to robots elsewhere, which leave the window",
                {{"url", Type::kText, "as it was connected"}},
                [&open](const Values& values) { return open.disconnectRemote(text(values, 0)); }});
  commands.add({"remote.limit",
                "Limits what robots elsewhere send, for lines that are narrow or shared",
                {{"url", Type::kText, "as it was connected"},
                 {"bytes", Type::kNumber, "at most so many bytes a second; 0: no limit"},
                 {"images", Type::kText, "'raw', 'jpeg', or 'auto': raw as long as the line carries it"}},
                [&open](const Values& values) { return limitRemote(open, values); }});
  commands.add({"robot.steer",
                "Steers a robot that others can steer, too, from now on; or gives it up",
                {{"robot", Type::kText, "its name"},
                 {"on", Type::kBool, "true: instead of whoever steers it now; false: gives it up"}},
                [&open](const Values& values) { return open.steer(text(values, 0), !flag(values, 1)); }});
  commands.add(
      {"session.offer",
       "Lets others watch and steer what is open here, as clients of the Foxglove WebSocket protocol",
       {{"address", Type::kText, "[ADDRESS:]PORT, or '' for 127.0.0.1:8765"}},
       [&open](const Values& values) { return open.offerSession(text(values, 0)); }});
  commands.add({"session.stop-offering",
                "Ends the connections of all who watch and steer what is open here",
                {},
                [&open](const Values&) -> robotlink::Result<void> {
                  open.stopOffering();
                  return {};
                }});
}

}  // namespace app
