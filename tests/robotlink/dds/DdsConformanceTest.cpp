// SPDX-License-Identifier: GPL-3.0-or-later
// The conformance suite of links over DDS. The two ends are at two participants, which meet only through the
// network stack, as those of two programs do.
#include "robotlink/dds/ProgramNet.h"
#include "robotlink/dds/ReceivingEnd.h"
#include "robotlink/dds/SendingEnd.h"
#include "tests/Eventually.h"
#include "tests/robotlink/dds/TestNodes.h"
#include "tests/robotlink/process/TransportConformance.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace robotlink::test {
namespace {

/// The nodes of all tests of this program: to open them takes longer than a test.
std::pair<std::shared_ptr<dds::Node>, std::shared_ptr<dds::Node>> nodes() {
  static const std::pair kNodes(openTestNode(), openTestNode());
  return kNodes;
}

/// Two programs that are linked over DDS.
class OverDds {
 public:
  void connect(AnySender& sender, AnyReceiver& receiver) {
    // Each connection replaces the receiver's one before.
    std::erase_if(links_, [&](const Linked& linked) { return linked.receiver == &receiver; });
    ASSERT_TRUE(senders_.link(sender, sender.process().name()));
    ASSERT_TRUE(receivers_.link(receiver, sender.process().name()));
    const auto from = senders_.sendingEnd(sender);
    links_.push_back(
        {&receiver, sender.blocking(), from->written(), from, receivers_.receivingEnd(receiver)});
    settle();
    ASSERT_TRUE(eventually([&] { return !links_.back().to->closed(); }));
    settle();
  }
  void settle() {
    ASSERT_TRUE(eventually([this] {
      return std::all_of(links_.begin(), links_.end(), [this](const Linked& link) { return settled(link); });
    }));
  }

 private:
  struct Linked {
    const AnyReceiver* receiver;
    bool blocking;
    /// What was written before it was linked.
    std::uint64_t before;
    std::shared_ptr<dds::SendingEnd> from;
    std::shared_ptr<dds::ReceivingEnd> to;
  };
  bool settled(const Linked& link) const {
    if (link.from->ended()) return link.to->closed();
    const auto receivers =
        static_cast<std::size_t>(std::count_if(links_.begin(), links_.end(), [&](const Linked& other) {
          return other.from == link.from && !other.to->ended();
        }));
    if (link.from->receivers() != receivers) return false;
    if (link.to->ended()) return true;
    if (link.from->written() != link.before && link.to->arrived() != link.from->written()) return false;
    return !link.blocking || link.from->leastTaken() >= leastTaken(link);
  }
  std::uint64_t leastTaken(const Linked& link) const {
    std::uint64_t least = link.to->taken();
    for (const Linked& other : links_) {
      if (other.from == link.from && !other.to->ended()) least = std::min(least, other.to->taken());
    }
    return least;
  }

  SteadyClock clock_;
  dds::ProgramNet senders_{nodes().first, {"robot", "senders"}, clock_, {}};
  dds::ProgramNet receivers_{nodes().second, {"robot", "receivers"}, clock_, {}};
  std::vector<Linked> links_;
};
INSTANTIATE_TYPED_TEST_SUITE_P(OverDds, TransportConformance, OverDds);

}  // namespace
}  // namespace robotlink::test
