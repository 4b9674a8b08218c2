// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/core/spread/SpreadOptions.h"
#include "robotlink/base/Error.h"
#include "robotlink/dds/Node.h"
#include "robotlink/process/Layout.h"

namespace app {

/// The network for DDS in a program of a layout: the loopback interface, or, if the layout names
/// hosts, the interface of this machine that has the address of its host.
struct SpreadNetwork {
  robotlink::dds::NodeOptions node;
  /// A note for the user about it, as a sentence.
  std::string note;
};

/// Fails, with the place in the layout, if it has no such program, or if that belongs to another machine.
robotlink::Result<SpreadNetwork> spreadNetworkOf(const robotlink::Layout& layout,
                                                 const SpreadOptions& options);

}  // namespace app
