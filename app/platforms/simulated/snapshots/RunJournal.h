// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Error.h"

namespace app {

/// The journal of all requests to a simulated run and its programs since its start, so that it can be re-run
/// to the same state: in lockstep, nothing else decides what happens. A plain value; one thread at a time.
class RunJournal {
 public:
  /// The requests of a longer run are not kept.
  static constexpr std::size_t kMaxBytes = std::size_t{32} << 20U;

  struct Entry {
    /// Steps that the run had made since its start.
    std::uint64_t step = 0;
    robotcontrol::Request request;
  };

  /// Starts over. `settings` says with what the run starts, one "name: value" in a line each; `overrides` are
  /// the requests that choose what its programs start with.
  void begin(std::uint64_t seed, std::string settings, std::vector<robotcontrol::Request> overrides);
  /// Keeps a request that was accepted.
  void add(std::uint64_t step, const robotcontrol::Request& request);
  /// The run cannot be repeated from now on, and why: "the layout was changed at 2.4 s".
  void spoil(std::string reason);

  std::uint64_t seed() const { return seed_; }
  const std::string& settings() const { return settings_; }
  const std::vector<robotcontrol::Request>& overrides() const { return overrides_; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// The reason why it cannot be repeated; empty: it can.
  const std::string& spoiled() const { return spoiled_; }

  std::vector<std::uint8_t> encode() const;
  /// Fails if the bytes are not those of a journal.
  static robotlink::Result<RunJournal> decode(const std::vector<std::uint8_t>& bytes);

 private:
  std::uint64_t seed_ = 0;
  std::string settings_, spoiled_;
  std::vector<robotcontrol::Request> overrides_;
  std::vector<Entry> entries_;
  std::size_t bytes_ = 0;
};

}  // namespace app
