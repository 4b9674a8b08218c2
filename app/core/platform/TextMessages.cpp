// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/TextMessages.h"

#include <iomanip>
#include <ostream>

#include "foxglove/Robot.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/base/Printable.h"
#include "robotlink/debugging/SharedDebugQueue.h"

namespace app {

void printText(std::ostream& out, robotlink::Instant time, const std::string& source,
               const std::string& text) {
  out << std::fixed << std::setprecision(3) << robotlink::seconds(time) << "  "
      << robotlink::printableLines(source + ": " + text, "    ") << "\n";
}

void printTexts(std::ostream& out, const std::string& robot, const robotlink::SharedDebugQueue& queue) {
  for (const auto& message : queue.messages) {
    const auto* text = message.as<foxglove::Log>();
    if (text == nullptr) continue;
    printText(out, message.time.value_or(robotlink::Instant()), robot + "/" + text->name(), text->message());
  }
}

void printMapNotes(std::ostream& out, const robotlink::GroundMap* map) {
  if (map == nullptr) return;
  for (const std::string& note : map->notes)
    out << (map->incomplete ? "Warning: " : "Note: ") << robotlink::printable(note) << "\n";
}

}  // namespace app
