// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/SerialPorts.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <tuple>

namespace robotlink::arcos {
namespace {

namespace fs = std::filesystem;

enum class PortKind { kAdapter, kBluetooth, kBuiltIn };

struct Found {
  PortKind kind;
  std::string name;
  std::string description;
};

std::string firstLine(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// The description of a USB device, which is a few folders above its port. Empty if there is none.
std::string describeUsb(fs::path folder) {
  for (int up = 0; up < 5 && folder.has_relative_path(); ++up, folder = folder.parent_path()) {
    const std::string product = firstLine(folder / "product");
    if (product.empty()) continue;
    std::string text = product;
    const std::string maker = firstLine(folder / "manufacturer"), number = firstLine(folder / "serial");
    if (!maker.empty() && !product.starts_with(maker)) text = maker + " " + text;
    return number.empty() ? text : text + " (" + number + ")";
  }
  return {};
}

std::optional<Found> inspect(const fs::path& tty) {
  const std::string name = tty.filename().string();
  if (name.starts_with("rfcomm")) return Found{PortKind::kBluetooth, name, "Bluetooth serial port"};
  std::error_code error;
  const fs::path device = fs::canonical(tty / "device", error);
  if (error) return std::nullopt;  // a console or a pseudo-terminal
  if (name.starts_with("ttyUSB") || name.starts_with("ttyACM")) {
    const std::string usb = describeUsb(device);
    return Found{PortKind::kAdapter, name, usb.empty() ? "USB serial adapter" : usb};
  }
  // The kernel lists ttyS0 to ttyS3 whether or not there is hardware; without it their type is 0.
  if (firstLine(tty / "type") == "0") return std::nullopt;
  return Found{PortKind::kBuiltIn, name, "built-in serial port"};
}

}  // namespace

std::vector<SerialPort> serialPorts(const fs::path& ttys) {
  std::vector<Found> found;
  std::error_code error;
  for (fs::directory_iterator entry(ttys, error), end; !error && entry != end; entry.increment(error)) {
    if (auto port = inspect(entry->path())) found.push_back(std::move(*port));
  }
  std::ranges::sort(found, {}, [](const Found& f) { return std::tuple(f.kind, f.name.size(), f.name); });
  std::vector<SerialPort> ports;
  for (Found& f : found) ports.push_back({"/dev/" + f.name, std::move(f.description)});
  return ports;
}

}  // namespace robotlink::arcos
