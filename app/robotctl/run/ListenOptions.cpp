// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/ListenOptions.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "app/core/remote/OfferAddress.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"

namespace app {

void ListenOptions::addTo(CLI::App& command) {
  option_ = command
                .add_option("--listen", text_,
                            "Lets clients of the Foxglove WebSocket protocol watch and steer the robots, at "
                            "[ADDRESS:]PORT (127.0.0.1:8765); until Ctrl-C unless --seconds is given")
                ->expected(0, 1)
                ->type_name("[ADDRESS:]PORT");
  command
      .add_option("--recordings", recordings_,
                  "With --listen: the folder where clients may record, and fetch recordings from "
                  "(robotctl log fetch)")
      ->type_name("FOLDER")
      ->needs(option_);
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
  const Interrupt interrupt;
  const auto recorder = record.start();
  if (!recorder) return printErrors({recorder.error()});
  logplayer::Recorder none({});
  const auto errors =
      app::serve(std::move(opening), options, *recorder ? **recorder : none, &Interrupt::noted, std::cerr);
  const int status = *recorder ? finishRecording(**recorder, std::cerr) : kDone;
  return errors.empty() ? status : printErrors(errors);
}

}  // namespace app
