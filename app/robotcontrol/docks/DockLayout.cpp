// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/DockLayout.h"

#include <QSet>
#include <QString>
#include <QXmlStreamReader>

namespace app {
namespace {

constexpr int kMaxDepth = 40;  // of splitters in each other; people nest four or five
constexpr int kMaxParts = 1000;

/// Reads a layout from its start; each function reads one element to its end and says whether it is whole.
class DockLayoutReader {
 public:
  explicit DockLayoutReader(const QByteArray& xml) : xml_(xml) {}

  bool readsWhole() {
    if (!xml_.readNextStartElement() || xml_.name() != QLatin1String("QtAdvancedDockingSystem")) return false;
    int containers = 0;
    while (xml_.readNextStartElement()) {
      if (!readContainer(containers++ > 0)) return false;
    }
    return containers > 0 && !xml_.hasError();
  }

 private:
  bool isElement(const char* name) const { return xml_.name() == QLatin1String(name); }
  int number(const char* attribute) const {
    bool valid = false;
    const int value = xml_.attributes().value(QLatin1String(attribute)).toInt(&valid);
    return valid && value >= 0 && value <= kMaxParts ? value : -1;
  }

  /// The first container is the window, all others float.
  bool readContainer(bool floats) {
    if (!isElement("Container") || number("Floating") != (floats ? 1 : 0) || ++parts_ > kMaxParts)
      return false;
    if (floats) {
      if (!xml_.readNextStartElement() || !isElement("Geometry")) return false;
      xml_.skipCurrentElement();
    }
    int nodes = 0;
    while (xml_.readNextStartElement()) {
      if (++nodes > 1 || !readNode(0)) return false;
    }
    return !xml_.hasError();
  }

  bool readNode(int depth) {
    if (++parts_ > kMaxParts || depth > kMaxDepth) return false;
    if (isElement("Area")) return readArea();
    return isElement("Splitter") && readSplitter(depth);
  }

  bool readSplitter(int depth) {
    const auto orientation = xml_.attributes().value(QLatin1String("Orientation"));
    if (orientation != QLatin1String("|") && orientation != QLatin1String("-")) return false;
    const int count = number("Count");
    int nodes = 0, sizes = -1;
    while (xml_.readNextStartElement()) {
      if (isElement("Sizes")) {
        if (sizes >= 0 || !readSizes(sizes)) return false;
      } else if (++nodes; !readNode(depth + 1)) {
        return false;
      }
    }
    return count >= 0 && nodes == count && sizes == count && !xml_.hasError();
  }

  bool readSizes(int& count) {
    const auto sizes = xml_.readElementText().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    count = static_cast<int>(sizes.size());
    for (const QString& size : sizes) {
      bool valid = false;
      if (size.toInt(&valid) < 0 || !valid) return false;
    }
    return !xml_.hasError();
  }

  bool readArea() {
    const int tabs = number("Tabs");
    int docks = 0;
    while (xml_.readNextStartElement()) {
      const QString name = xml_.attributes().value(QLatin1String("Name")).toString();
      if (!isElement("Widget") || name.isEmpty() || names_.contains(name) || number("Closed") < 0)
        return false;
      names_.insert(name);
      ++docks;
      xml_.skipCurrentElement();
    }
    return docks > 0 && docks == tabs && !xml_.hasError();
  }

  QXmlStreamReader xml_;
  QSet<QString> names_;
  int parts_ = 0;
};

}  // namespace

bool isDockLayout(const QByteArray& xml) {
  return DockLayoutReader(xml).readsWhole();
}

}  // namespace app
