// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/LocalAddresses.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <chrono>

#include "robotlink/base/network/HostLookup.h"

namespace robotlink::dds {
namespace {

/// How long the system may take to find the address of a name.
constexpr std::chrono::seconds kLookupTime{10};

std::string textOfAddress(const sockaddr* address) {
  char text[INET_ADDRSTRLEN] = "";
  const auto* v4 = reinterpret_cast<const sockaddr_in*>(address);
  ::inet_ntop(AF_INET, &v4->sin_addr, text, sizeof text);
  return text;
}

}  // namespace

std::vector<LocalInterface> localInterfaces() {
  std::vector<LocalInterface> result;
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return result;
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr != nullptr && one->ifa_addr->sa_family == AF_INET)
      result.push_back({one->ifa_name, textOfAddress(one->ifa_addr), (one->ifa_flags & IFF_UP) != 0});
  }
  ::freeifaddrs(all);
  return result;
}

std::vector<std::string> localAddresses() {
  std::vector<std::string> result;
  for (const LocalInterface& one : localInterfaces()) {
    if (one.isUp) result.push_back(one.address);
  }
  return result;
}

std::string whyNotUsable(const std::string& address, const std::vector<LocalInterface>& interfaces) {
  std::string why = "no network interface of this machine has it";
  for (const LocalInterface& one : interfaces) {
    if (one.address != address) continue;
    if (one.isUp) return {};
    why = "its network interface " + one.name + " is down";
  }
  return why;
}

std::string addressOf(const std::string& host) {
  const auto found = HostLookup::start(host)->wait(kLookupTime);
  if (!found || !*found) return {};
  in_addr ignored{};
  const auto v4 = std::ranges::find_if(**found, [&](const std::string& address) {
    return ::inet_pton(AF_INET, address.c_str(), &ignored) == 1;
  });
  return v4 == (*found)->end() ? std::string() : *v4;
}

}  // namespace robotlink::dds
