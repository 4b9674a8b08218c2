// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/RemoteCommands.h"

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"

namespace app {

namespace {

robotlink::Result<void> limitRemote(OpenPlatform& open, const Values& values) {
  const double bytes = number(values, 1), rate = number(values, 3);
  if (!(bytes >= 0)) return robotlink::failure("remote.limit", "a limit is a number of bytes a second, or 0");
  if (!(rate >= 0))
    return robotlink::failure("remote.limit", "a limit is a number of images a second, or 0: all");
  return open.limitRemote(text(values, 0), {bytes, *imagesNamed(text(values, 2)), rate});
}

}  // namespace

void addRemoteCommands(robotlink::CommandTable& commands, OpenPlatform& open) {
  commands.attach("remote.connect", [&open](const Values& values) {
    return open.connectRemote(text(values, 0), text(values, 1));
  });
  commands.attach("remote.trust", [&open](const Values& values) {
    return open.trustRemote(text(values, 0), text(values, 1));
  });
  commands.attach("remote.show-token",
                  [&open](const Values& values) { return open.showToken(text(values, 0), text(values, 1)); });
  commands.attach("remote.remember-token",
                  [&open](const Values& values) { return open.rememberToken(text(values, 0)); });
  commands.attach("remote.forget-token",
                  [](const Values& values) { return RemoteRobots::forgetToken(text(values, 0)); });
  commands.attach("remote.disconnect",
                  [&open](const Values& values) { return open.disconnectRemote(text(values, 0)); });
  commands.attach("remote.limit", [&open](const Values& values) { return limitRemote(open, values); });
  commands.attach("robot.steer",
                  [&open](const Values& values) { return open.steer(text(values, 0), !flag(values, 1)); });
  commands.attach("session.offer",
                  [&open](const Values& values) { return open.offerSession(text(values, 0)); });
  commands.attach("session.stop-offering", [&open](const Values&) -> robotlink::Result<void> {
    open.stopOffering();
    return {};
  });
}

}  // namespace app
