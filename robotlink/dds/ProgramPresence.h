// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "robotlink/dds/Node.h"

namespace robotlink::dds {

/// The name of a program of a robot in a network, which only one program can have at a time. It is free again
/// as soon as that has ended, however it ended. Any thread.
class ProgramPresence {
 public:
  /// The owner of a name, as a value.
  struct Identity {
    std::string robot;
    std::string program;
    /// The place of the program, for users: "process 4711 on robot1.local". A program at the same place is
    /// the same program.
    std::string where;
  };
  /// Claims the name; takes a moment, to listen for other programs. Fails, with the place of the other one,
  /// if one has the name. `report` gets a sentence, in a thread of DDS, if one is found to have it later,
  /// after the network was divided; it must not block.
  static Result<std::unique_ptr<ProgramPresence>> claim(const std::shared_ptr<Node>& node,
                                                        const Identity& identity,
                                                        std::function<void(const std::string& text)> report);
  ~ProgramPresence();

  /// "process 4711 on robot1.local".
  static std::string here();

 private:
  struct Implementation;
  explicit ProgramPresence(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink::dds
