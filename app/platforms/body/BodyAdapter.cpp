// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter of remote bodies, whose programs run here.
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/body/BodyFeed.h"
#include "app/platforms/body/BodyHeadless.h"
#include "robotlink/foxglove/client/ServerUrl.h"

namespace app {
namespace {

robotlink::Result<PlatformOpening> openBody(const PlatformChoices& choices) {
  BodyOptions options{.url = choices.sources.front()};
  if (const auto url = robotlink::websocket::parseServerUrl(options.url); !url)
    return tl::unexpected(url.error());
  options.token = textOf(choices.values, "token");
  options.robot = textOf(choices.values, "robot");
  if (const std::string layout = textOf(choices.values, "layout"); !layout.empty())
    options.program.layout = layoutNamed(layout);
  options.program.map = textOf(choices.values, "map");
  return BodyFeed::opening(std::move(options));
}

/// Only a command: the dialog is that of all connections, Robot > Connect…
PlatformForm bodyForm() {
  PlatformForm form{.name = "body",
                    .command = "remote.host",
                    .commandHelp =
                        "Runs a robot's program here, for a remote body that 'robotctl platform ... "
                        "--listen' offers"};
  form.fields = {
      {.name = "url", .help = "ws://HOST[:PORT]", .noun = "URL", .isSource = true},
      {.name = "token", .help = "the token printed there, or ''", .noun = "token"},
      {.name = "robot", .help = "the robot whose body it is; '': the first one offered", .noun = "robot"},
      {.name = "layout",
       .help = "a layout file or the name of a shipped one; '': the robot's",
       .noun = "layout"},
      {.name = "map", .help = "a map of the area where it drives, or ''", .noun = "map"}};
  return form;
}

const PlatformRegistration kBodyRegistration{
    {.name = BodyFeed::kAdapter,
     .sources = "a remote body whose program runs here (ws://HOST[:PORT], with --program here)",
     .time = TimeKind::kReal,
     .opens = [](const std::string& source) { return robotlink::websocket::isServerUrl(source); },
     .order = 1,
     .open = openBody,
     .form = bodyForm,
     .headless = headlessBody}};

}  // namespace
}  // namespace app
