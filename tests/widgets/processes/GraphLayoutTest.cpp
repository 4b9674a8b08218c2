// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/GraphLayout.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

/// A graph of processes by their names; each edge is a package of its own.
struct Drawn {
  ProcessGraph graph;

  explicit Drawn(std::initializer_list<const char*> names) {
    for (const char* name : names) {
      ProcessGraph::Node node;
      node.name = QString::fromUtf8(name);
      if (node.name != QStringLiteral("platform")) node.tasks << node.name;
      graph.nodes.push_back(node);
    }
  }
  Drawn& edge(int from, int to, bool blocking = false) {
    auto& sender = graph.nodes[static_cast<std::size_t>(from)];
    auto& receiver = graph.nodes[static_cast<std::size_t>(to)];
    sender.outputs.emplace_back();
    receiver.inputs.emplace_back();
    receiver.inputs.back().blocking = blocking;
    graph.edges.push_back({from, static_cast<int>(sender.outputs.size()) - 1, to,
                           static_cast<int>(receiver.inputs.size()) - 1, false});
    return *this;
  }
  Drawn& layOut() {
    widgets::layOut(graph);
    return *this;
  }
  const ProcessGraph::Node& node(int index) const { return graph.nodes[static_cast<std::size_t>(index)]; }
};

TEST(GraphLayout, whoReceivesStandsToTheRightOfAllWhoSend) {
  const Drawn drawn = Drawn({"platform", "cognition", "motion"}).edge(0, 1).edge(0, 2).edge(1, 2).layOut();
  EXPECT_EQ(drawn.node(0).layer, 0);
  EXPECT_EQ(drawn.node(1).layer, 1);
  EXPECT_EQ(drawn.node(2).layer, 2) << "behind cognition, although the platform sends to it, too";
  EXPECT_LT(drawn.node(0).rect.right(), drawn.node(1).rect.left());
  EXPECT_LT(drawn.node(1).rect.right(), drawn.node(2).rect.left());
}

TEST(GraphLayout, ofACycleThePackagesToThePlatformGoBack) {
  const Drawn drawn =
      Drawn({"platform", "cognition", "motion"}).edge(2, 0).edge(0, 1, true).edge(1, 2).layOut();
  EXPECT_TRUE(drawn.graph.edges[0].back);
  EXPECT_FALSE(drawn.graph.edges[1].back || drawn.graph.edges[2].back);
  EXPECT_EQ(drawn.node(2).layer, 2);
}

TEST(GraphLayout, betweenTwoProcessesThePackageThatOneWaitsForGoesAhead) {
  const Drawn drawn = Drawn({"cognition", "motion"}).edge(0, 1).edge(1, 0, true).layOut();
  EXPECT_TRUE(drawn.graph.edges[0].back);
  EXPECT_FALSE(drawn.graph.edges[1].back);
  EXPECT_EQ(drawn.node(1).layer, 0);
  EXPECT_EQ(drawn.node(0).layer, 1);
}

TEST(GraphLayout, aPackageToItselfGoesBack) {
  const Drawn drawn = Drawn({"cognition"}).edge(0, 0, true).layOut();
  EXPECT_TRUE(drawn.graph.edges[0].back);
  EXPECT_EQ(drawn.node(0).layer, 0);
}

TEST(GraphLayout, nodesHaveRoomForTheirPortsAndDoNotOverlap) {
  const Drawn drawn =
      Drawn({"platform", "a", "b", "c"}).edge(0, 1).edge(0, 2).edge(0, 3).edge(0, 3).edge(0, 3).layOut();
  for (const ProcessGraph::Node& node : drawn.graph.nodes) {
    for (const auto* ports : {&node.inputs, &node.outputs})
      for (const ProcessGraph::Port& port : *ports) EXPECT_TRUE(node.rect.contains(port.rect));
    EXPECT_TRUE(drawn.graph.bounds.contains(node.rect));
    for (const ProcessGraph::Node& other : drawn.graph.nodes)
      if (&other != &node) {
        EXPECT_FALSE(node.rect.intersects(other.rect));
      }
  }
  EXPECT_TRUE(Drawn({}).layOut().graph.bounds.isEmpty());
}

TEST(GraphLayout, theSameGraphIsDrawnTheSame) {
  const auto draw = [] {
    return Drawn({"a", "b", "c", "d"}).edge(0, 2).edge(1, 3).edge(3, 2).edge(2, 0).layOut();
  };
  const Drawn once = draw(), again = draw();
  for (int i = 0; i < 4; ++i) EXPECT_EQ(once.node(i).rect, again.node(i).rect);
}

}  // namespace
}  // namespace widgets
