// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/far/NetworkCable.h"

#include <unistd.h>

#include <cstdlib>

namespace app::test {

robotlink::Result<std::unique_ptr<NetworkCable>> NetworkCable::make(const End& one, const End& other) {
  // `ip` takes a file for a network if its name has a slash.
  const std::string file =
      "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(other.network.descriptor());
  auto done = one.network.ip("link add " + one.interface + " type veth peer name " + other.interface +
                             " netns " + file);
  for (const End* end : {&one, &other}) {
    if (done) done = end->network.ip("address add " + end->address + "/24 dev " + end->interface);
    if (done) done = end->network.ip("link set " + end->interface + " up");
  }
  if (!done) return tl::unexpected(done.error());
  return std::unique_ptr<NetworkCable>(new NetworkCable(one));
}

void NetworkCable::unplug(bool unplugged) const {
  if (!one_.network.ip("link set " + one_.interface + (unplugged ? " down" : " up"))) std::abort();
}

}  // namespace app::test
