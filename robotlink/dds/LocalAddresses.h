// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace robotlink::dds {

/// A network interface of this machine. A plain value.
struct LocalInterface {
  std::string name, address;
  bool isUp = false;
  bool operator==(const LocalInterface&) const = default;
};

/// The interfaces that have IPv4 addresses; one for each address.
std::vector<LocalInterface> localInterfaces();
/// The IPv4 addresses of those that are up.
std::vector<std::string> localAddresses();
/// Why no network can be used by this address of this machine: "its interface eth1 is down"; empty if one
/// can.
std::string whyNotUsable(const std::string& address, const std::vector<LocalInterface>& interfaces);
/// The IPv4 address of a machine, by its address or name; empty if there is none. Asks the system, for a name
/// 10 s at most.
std::string addressOf(const std::string& host);

}  // namespace robotlink::dds
