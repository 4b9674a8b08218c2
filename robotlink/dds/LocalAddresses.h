// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace robotlink::dds {

/// The IPv4 addresses of this machine's interfaces that are up.
std::vector<std::string> localAddresses();
/// The IPv4 address of a machine, by its address or name; empty if there is none. Asks the system, which may
/// take seconds for a name.
std::string addressOf(const std::string& host);

}  // namespace robotlink::dds
