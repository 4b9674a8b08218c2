// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QString>
#include <QStringList>
#include <vector>

namespace widgets {

/// The processes of a robot and the packages between them as a picture: nodes with ports, edges, and their
/// places in pixels at zoom 1. Made by processGraph(). A plain value.
struct ProcessGraph {
  /// An input or output of a process: one package.
  struct Port {
    QString package;
    QString type;
    /// At inputs: the sending process.
    QString peer;
    /// The process waits for this package, or, at outputs, until all receivers have taken it.
    bool blocking = false;
    /// Packages sent or received, Hz.
    double rate = 0;
    /// Packages since the start.
    quint64 count = 0;
    /// At inputs: packages since the start that were replaced by newer ones before they were read.
    quint64 missed = 0;
    /// Packages a second that were replaced in this way, Hz.
    double missedRate = 0;
    /// At inputs: the process is meant to read every package and does not: it waits for this package and for
    /// no slower one, and still misses some. A process that reads only the newest package, or has a longer
    /// period, is not marked.
    bool falls = false;
    /// A value of a user is in the package's place.
    bool held = false;
    /// The port's row in its node.
    QRectF rect;
  };
  /// A process, or a platform, which no table describes.
  struct Node {
    QString name;
    /// "running", "stopped", "failed: ..."; empty if no table describes it.
    QString state;
    bool failed = false;
    /// Frames per second.
    double rate = 0;
    quint64 frames = 0;
    /// s; 0: the process is driven by events.
    double period = 0;
    /// Its nice value.
    int priority = 0;
    /// Debug messages that it dropped.
    quint64 dropped = 0;
    QStringList tasks;
    std::vector<Port> inputs;
    std::vector<Port> outputs;
    /// Column of the layout, from the left.
    int layer = 0;
    QRectF rect;
    /// Sum over all inputs.
    quint64 missed() const;
    /// Whether some input `falls`.
    bool fallsBehind() const;
  };
  /// A package from an output to an input.
  struct Edge {
    /// Indices of the nodes and of their ports.
    int from = 0, output = 0, to = 0, input = 0;
    /// Closes a cycle, and is drawn against the flow.
    bool back = false;
  };
  /// The parts of a table that are shown.
  struct Options {
    /// Whether packages named "debug/..." and their ports are shown.
    bool debugLinks = false;
  };

  std::vector<Node> nodes;
  std::vector<Edge> edges;
  /// Everything, with a margin.
  QRectF bounds;

  /// Index of a node; -1 if there is none.
  int find(const QString& name) const;
  const Port& output(const Edge& edge) const;
  const Port& input(const Edge& edge) const;
};

}  // namespace widgets
