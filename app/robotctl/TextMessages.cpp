// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/TextMessages.h"

#include <iomanip>
#include <iostream>

#include "robotcontrol/Debugging.pb.h"

namespace app {

void printTexts(const std::string& robot, const robotcontrol::DebugQueue& queue) {
  for (const auto& message : queue.messages()) {
    if (!message.has_text()) continue;
    const auto& stamp = message.timestamp();
    std::cerr << std::fixed << std::setprecision(3)
              << static_cast<double>(stamp.seconds()) + 1e-9 * stamp.nanos() << "  " << robot << "/"
              << message.text().name() << ": " << message.text().message() << "\n";
  }
}

}  // namespace app
