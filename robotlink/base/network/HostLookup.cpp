// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/network/HostLookup.h"

#include <arpa/inet.h>
#include <netdb.h>

#include <array>
#include <system_error>
#include <thread>

namespace robotlink {
namespace {

bool isIpAddress(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> address{};
  return inet_pton(AF_INET, host.c_str(), address.data()) == 1 ||
         inet_pton(AF_INET6, host.c_str(), address.data()) == 1;
}

HostLookup::Outcome addressesOf(const std::string& host) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int status = getaddrinfo(host.c_str(), nullptr, &hints, &found);
  std::vector<std::string> addresses;
  for (const addrinfo* item = found; item != nullptr; item = item->ai_next) {
    std::array<char, NI_MAXHOST> text{};
    if (getnameinfo(item->ai_addr, item->ai_addrlen, text.data(), text.size(), nullptr, 0, NI_NUMERICHOST) ==
        0)
      addresses.emplace_back(text.data());
  }
  if (found != nullptr) freeaddrinfo(found);
  if (status == 0 && !addresses.empty()) return addresses;
  return failure("host.unknown",
                 "there is no machine named '" + host + "' (" + gai_strerror(status) +
                     "); check its name, or give its IP address",
                 {}, {host});
}

/// The same in a thread that nothing may leave by an exception.
HostLookup::Outcome tried(const HostLookup::Resolver& resolver, const std::string& host) {
  try {
    return resolver(host);
  } catch (const std::exception& error) {
    return failure("host.unknown", "the address of '" + host + "' cannot be looked up: " + error.what(), {},
                   {host});
  }
}

}  // namespace

std::shared_ptr<HostLookup> HostLookup::start(const std::string& host, Resolver resolver) {
  auto lookup = std::make_shared<HostLookup>();
  if (isIpAddress(host) || host == "localhost") {
    lookup->finish(std::vector{host == "localhost" ? std::string("127.0.0.1") : host});
    return lookup;
  }
  if (!resolver) resolver = addressesOf;
  try {
    // No PacedThread: the system cannot be interrupted, so no one joins the thread.
    std::thread([lookup, host, resolver] { lookup->finish(tried(resolver, host)); }).detach();
  } catch (const std::system_error& error) {
    lookup->finish(failure("host.unknown", std::string("the system cannot start a thread: ") + error.what()));
  }
  return lookup;
}

void HostLookup::finish(Outcome outcome) {
  {
    const std::lock_guard lock(mutex_);
    outcome_ = std::move(outcome);
  }
  finished_.notify_all();
}

std::optional<HostLookup::Outcome> HostLookup::outcome() const {
  const std::lock_guard lock(mutex_);
  return outcome_;
}

std::optional<HostLookup::Outcome> HostLookup::wait(Duration limit) const {
  std::unique_lock lock(mutex_);
  finished_.wait_for(lock, limit, [this] { return outcome_.has_value(); });
  return outcome_;
}

}  // namespace robotlink
