// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/ListenOptions.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "app/core/deploy/OwnResources.h"
#include "app/core/platform/NumberRange.h"
#include "app/core/platform/ProgramTroubles.h"
#include "app/core/remote/OfferAddress.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"

namespace app {

void ListenOptions::addTo(CLI::App& command) {
  option_ = command
                .add_option("--listen", text_,
                            "Lets clients of the Foxglove WebSocket protocol watch and steer the robots, at "
                            "[ADDRESS:]PORT (127.0.0.1:8765); until Ctrl-C unless --seconds is given. At "
                            "addresses that other machines reach, with encryption and tokens")
                ->expected(0, 1)
                ->type_name("[ADDRESS:]PORT");
  command
      .add_option("--recordings", recordings_,
                  "With --listen: the folder where clients may record, and fetch recordings from "
                  "(robotctl log fetch)")
      ->type_name("FOLDER")
      ->needs(option_);
  // Everything else may read the resources, so the folder is made while the options are read.
  command
      .add_option_function<std::string>(
          "--resources",
          [this](const std::string& folder) {
            if (const auto used = useOwnResources(folder); !used)
              throw CLI::ValidationError("--resources", used.error().describe());
            resources_ = folder;
          },
          "With --listen: the robot's own resource folder, created as a copy of the installed one if "
          "missing. Clients may deploy layouts, parameters, motions and color tables into it (robotctl "
          "deploy)")
      ->type_name("FOLDER")
      ->needs(option_);
  addAccessTo(command);
  addTimeLimitsTo(command);
}

void ListenOptions::addAccessTo(CLI::App& command) {
  auto* secure =
      command.add_flag("--secure", access_.isSecure, "Requires encryption and tokens at 127.0.0.1 as well")
          ->needs(option_);
  auto* tokens = command
                     .add_option("--token-file", access_.tokenFile,
                                 "The file of the tokens that clients need; created if missing "
                                 "(robotcontrol/tokens in ~/.local/state)")
                     ->needs(option_)
                     ->type_name("FILE");
  command
      .add_flag("--insecure", access_.isInsecure,
                "No encryption, no tokens: anyone who can reach the address can watch and steer the robots")
      ->needs(option_)
      ->excludes(secure)
      ->excludes(tokens);
  command
      .add_option("--allow-origin", access_.origins,
                  "Web pages of this origin may connect, such as https://app.foxglove.dev; * for all")
      ->needs(option_)
      ->type_name("ORIGIN");
}

void ListenOptions::addTimeLimitsTo(CLI::App& command) {
  command
      .add_option(
          "--motion-timeout", motionTimeout_,
          "A robot stops when the client that steers it has not repeated its motion request for this long, s")
      ->needs(option_)
      ->check(numberFrom(0.1, 60))
      ->capture_default_str();
  command
      .add_option("--link-timeout", linkTimeout_,
                  "A robot stops when the client that steers it has been silent for this long, s")
      ->needs(option_)
      ->check(numberFrom(0.1, 60))
      ->capture_default_str();
}

bool ListenOptions::given() const {
  return option_ != nullptr && option_->count() > 0;
}

robotlink::Result<robotlink::websocket::ListenAddress> ListenOptions::address() const {
  return parseOfferAddress(text_);
}

int ListenOptions::serve(PlatformOpening opening, ServeOptions options, const RecordOptions& record) const {
  const auto where = address();
  if (!where) return printErrors({where.error()});
  options.address = *where;
  options.recordings = recordings_;
  options.resources = resources_;
  options.access = access_;
  options.steering = {.commandTime = robotlink::fromSeconds(motionTimeout_),
                      .linkTime = robotlink::fromSeconds(linkTimeout_)};
  const Interrupt interrupt;
  const auto recorder = record.start();
  if (!recorder) return printErrors({recorder.error()});
  logplayer::Recorder none({});
  const auto errors =
      app::serve(std::move(opening), options, *recorder ? **recorder : none, &Interrupt::noted, std::cerr);
  const int status = *recorder ? finishRecording(**recorder, std::cerr) : kDone;
  if (!errors.empty()) return printErrors(errors);
  return status == kDone && options.troubles && options.troubles->any() ? kDoneWithLosses : status;
}

}  // namespace app
