// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/TextMessages.h"

#include <iomanip>
#include <iostream>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/GroundMap.h"

namespace app {

void printText(robotlink::Instant time, const std::string& source, const std::string& text) {
  std::cerr << std::fixed << std::setprecision(3) << robotlink::seconds(time) << "  " << source << ": "
            << text << "\n";
}

void printTexts(const std::string& robot, const robotcontrol::DebugQueue& queue) {
  for (const auto& message : queue.messages()) {
    if (!message.has_text()) continue;
    const auto& stamp = message.timestamp();
    const robotlink::Instant time(std::chrono::seconds(stamp.seconds()) +
                                  std::chrono::nanoseconds(stamp.nanos()));
    printText(time, robot + "/" + message.text().name(), message.text().message());
  }
}

void printMapNotes(const robotlink::GroundMap* map) {
  if (map == nullptr) return;
  for (const std::string& note : map->notes)
    std::cerr << (map->incomplete ? "Warning: " : "Note: ") << note << "\n";
}

}  // namespace app
