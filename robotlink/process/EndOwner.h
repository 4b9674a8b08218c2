// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace robotlink {

class AnyReceiver;
class AnySender;

/// The part of a process that its receivers and senders know: its name, how to wake it, and the lists in
/// which they register themselves when they are constructed. Ends are constructed before the process runs, by
/// one thread, and live as long as the process.
class EndOwner {
 public:
  explicit EndOwner(std::string name) : name_(std::move(name)) {}
  virtual ~EndOwner() = default;
  EndOwner(const EndOwner&) = delete;
  EndOwner& operator=(const EndOwner&) = delete;

  const std::string& name() const { return name_; }
  /// Makes the process look for new packages. Any thread.
  virtual void wake() = 0;

  /// All receivers and senders, in the order of their construction.
  const std::vector<AnyReceiver*>& receivers() const { return receivers_; }
  const std::vector<AnySender*>& senders() const { return senders_; }

 private:
  friend class AnyReceiver;
  friend class AnySender;
  // Called by the constructors of ends, which are members of the process or of its parts.
  void add(AnyReceiver& receiver) { receivers_.push_back(&receiver); }
  void add(AnySender& sender) { senders_.push_back(&sender); }

  const std::string name_;
  std::vector<AnyReceiver*> receivers_;
  std::vector<AnySender*> senders_;
};

}  // namespace robotlink
