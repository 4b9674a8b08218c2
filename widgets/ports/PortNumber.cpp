// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ports/PortNumber.h"

#include <algorithm>

#include "robotcontrol/World.pb.h"
#include "robotlink/packages/PortUnits.h"

namespace widgets {

int numberCount(const robotcontrol::WorldPort& port) {
  int numbers = 1;
  constexpr int kMaxNumbers = 1 << 20;
  for (const int size : port.shape())
    numbers = std::clamp(numbers * std::clamp(size, 0, kMaxNumbers / std::max(numbers, 1)), 0, kMaxNumbers);
  return numbers;
}

PortNumber portNumber(const robotcontrol::WorldObject& object, int number) {
  const robotcontrol::WorldPort& port = object.port();
  PortNumber result{port.minimum(), port.maximum(), {}};
  result.unit = robotlink::unitOfNumber(port.unit(), static_cast<std::size_t>(number),
                                        static_cast<std::size_t>(numberCount(port)));
  for (const auto& property : object.properties()) {
    if (number >= property.values_size()) continue;
    if (property.name() == "minimum") result.minimum = property.values(number);
    if (property.name() == "maximum") result.maximum = property.values(number);
  }
  return result;
}

}  // namespace widgets
