// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QString>
#include <QStringList>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotcontrol {
class ProcessTable;
}

namespace widgets {

/// The processes of a robot and the packages between them, as a picture: nodes with their ports, edges, and
/// where all of it lies, in pixels at zoom 1. Made anew from each table; rates follow from an older one. A
/// plain value.
struct ProcessGraph {
  struct Port {
    QString package;
    QString type;
    QString peer;  ///< at inputs: who sends
    bool blocking = false;
    double rate = 0;  ///< Hz, sent or taken
    quint64 count = 0;
    quint64 missed = 0;     ///< since the start
    double missedRate = 0;  ///< Hz
    /// At inputs: packages are lost that the layout means to be read, each of them: its process waits for
    /// this package and for no slower one, and still does not keep up. A process that only looks at the
    /// newest, or has a longer period, loses none.
    bool falls = false;
    QRectF rect;
  };
  struct Node {
    QString name;
    QString state;  ///< "running", "stopped", "failed: ..."; empty if no table tells of it
    bool failed = false;
    double rate = 0;  ///< frames a second
    quint64 frames = 0;
    double period = 0;  ///< s; 0 is event-driven
    int priority = 0;
    quint64 dropped = 0;
    QStringList tasks;
    std::vector<Port> inputs;
    std::vector<Port> outputs;
    int layer = 0;
    QRectF rect;
    quint64 missed() const;
    bool fallsBehind() const;
  };
  struct Edge {
    int from = 0, output = 0, to = 0, input = 0;  ///< indices of nodes and of their ports
    bool back = false;                            ///< against the flow
  };
  struct Options {
    bool debugLinks = false;  ///< shows the packages "debug/..." and their ports, too
  };

  std::vector<Node> nodes;
  std::vector<Edge> edges;
  QRectF bounds;

  int find(const QString& name) const;  ///< -1 if there is none
  const Port& output(const Edge& edge) const;
  const Port& input(const Edge& edge) const;
};

/// `before` is an older table, `elapsed` before `now`; without one, rates are 0.
ProcessGraph processGraph(const robotcontrol::ProcessTable& now, const robotcontrol::ProcessTable* before,
                          robotlink::Duration elapsed, const ProcessGraph::Options& options);

}  // namespace widgets
