// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "robotlink/session/StreamStore.h"
#include "widgets/data/DataFilter.h"
#include "widgets/data/DataNode.h"
#include "widgets/data/DataStreams.h"
#include "widgets/data/ImageThumbnails.h"

namespace widgets {

/// The reference with which the shown messages are compared.
struct DataComparison {
  enum class With : std::uint8_t {
    kNothing,
    /// The same stream of another robot.
    kRobot,
    /// The messages that DataModel::remember() was called for.
    kRemembered,
    /// The logged version of what is recomputed from a log.
    kLogged,
  };
  With with = With::kNothing;
  /// Only for kRobot.
  std::string robot = {};
  bool operator==(const DataComparison&) const = default;
};

/// All streams of a session by robot, and below each the fields of its message at an instant. Rows of fields
/// are made when their parent is unfolded (fetchMore()), and brought up to date while it is followed, so that
/// what is folded costs nothing. New messages change values in place: rows are inserted and removed only
/// where lists grow and shrink, and where a stream's type changes.
///
/// Streams that no debug key publishes yet are listed as off. GUI thread.
class DataModel final : public QAbstractItemModel {
  Q_OBJECT
 public:
  /// Name; value, of streams their rate and age; unit; the value that it is compared with.
  enum Column { kName, kValue, kUnit, kOther, kColumns };
  enum Role {
    /// The path that expressions take (QString).
    kPathRole = Qt::UserRole + 1,
    /// rowKeyOf() (QString).
    kRowRole,
    /// PlotSource::text() of numbers (QString); else empty.
    kSourceRole,
    /// The path of a value or list below its stream (QString); else empty.
    kFieldRole,
    /// The debug key of a stream that is off (QString); else empty.
    kKeyRole,
    /// The value with all its digits; of messages and lists what is shown (QString).
    kFullValueRole,
    /// Whether the value differs from the one that it is compared with, here or below (bool).
    kChangedRole,
    /// Whether the row itself is found by the search, not only something below it (bool).
    kFoundRole,
  };
  /// Height of the pictures of images, in pixels.
  static constexpr int kThumbnailHeight = 16;

  explicit DataModel(QObject* parent = nullptr);
  ~DataModel() override;

  /// Shows the messages at an instant. The store must outlive the model.
  void update(const robotlink::StreamStore& store, robotlink::Instant shown);
  /// Whether the children of a row are made, and brought up to date by update(): while it is unfolded.
  void setFollowed(const QModelIndex& index, bool isFollowed);
  /// Lists only rows that are found, with those above and below them. Resets the model.
  void setWords(const QString& words);
  bool isFiltered() const { return !filter_.isEmpty(); }

  void setComparison(const DataComparison& comparison);
  const DataComparison& comparison() const { return comparison_; }
  /// Keeps the shown messages of all streams to compare with.
  void remember();
  bool hasRemembered() const { return !remembered_.empty(); }

  /// Null for an invalid index.
  const DataNode* node(const QModelIndex& index) const;
  /// The first row with this kRowRole among those that are listed; invalid if there is none.
  QModelIndex find(const QString& row) const;
  /// The row's message, list or value as indented JSON; empty for robots.
  QString json(const QModelIndex& index) const;
  /// Names of the robots that have streams.
  std::vector<std::string> robots() const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  bool hasChildren(const QModelIndex& parent = {}) const override;
  bool canFetchMore(const QModelIndex& parent) const override;
  void fetchMore(const QModelIndex& parent) override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// The numbers among the rows, as the Plots view takes them.
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;

 private:
  using Children = std::vector<std::unique_ptr<DataNode>>;

  DataNode& nodeAt(const QModelIndex& index) const;
  QModelIndex indexOf(const DataNode& node) const;
  /// Makes rows of robots and streams follow streams_.
  void mergeStreams();
  /// Removes the children that are not in `wanted`, and inserts those that are missing; both are in the same
  /// order.
  void merge(DataNode& parent, DataNode::Kind kind, const std::vector<DataStream>& wanted);
  bool isFound(const DataStream& stream) const;
  /// The message of a stream at the shown instant; null if there is none.
  robotlink::PackagePtr shownMessage(const std::string& path) const;
  /// The message that a stream's is compared with; null if there is none.
  robotlink::PackagePtr otherMessage(const std::string& path) const;

  /// Takes the stream's message, and brings its rows up to date.
  void follow(DataNode& stream);
  /// Whether there is something to unfold below a row.
  bool hasContents(const DataNode& node) const;
  /// The rows below a field, element or stream, as the message has them now.
  Children childrenOf(DataNode& node) const;
  Children fieldsOf(DataNode& node) const;
  Children elementsOf(DataNode& node) const;
  /// The text that is searched for a row.
  QString searched(const DataNode& node) const;
  /// Whether a search finds the row, something above it, or something below it.
  bool isListed(const DataNode& node) const;
  void list(DataNode& node);
  void unlist(DataNode& node);
  void insert(DataNode& parent, Children children);
  void remove(DataNode& parent, int from);
  /// Brings the listed rows below a row up to date.
  void refresh(DataNode& node);
  /// Brings the elements of a list up to date, which may have grown or shrunk.
  void refreshList(DataNode& list, int count);
  void announce(const DataNode& parent);

  QVariant streamData(const DataNode& node, int column, int role) const;
  QVariant fieldData(const DataNode& node, int column, int role) const;
  QString valueOf(const DataNode& node) const;
  QString otherValueOf(const DataNode& node) const;
  QString streamState(const DataNode& node) const;
  QString arrivalState(const DataNode& node) const;
  /// Whether a user holds a value in place of a stream's package.
  bool isHeld(const DataNode& stream) const;
  QString toolTip(const DataNode& node) const;
  QString sourceOf(const DataNode& node) const;
  bool isChanged(const DataNode& node) const;
  QVariant colorOfRow(const DataNode& node, int role) const;

  const robotlink::StreamStore* store_ = nullptr;
  robotlink::Instant shown_;
  /// Packages in whose place users hold values at that instant, by robot.
  std::map<std::string, std::set<std::string>> held_;
  DataStreams streams_;
  DataFilter filter_;
  DataComparison comparison_;
  /// The messages to compare with, by stream.
  std::map<std::string, robotlink::PackagePtr> remembered_;
  std::unique_ptr<DataNode> root_;
  mutable ImageThumbnails thumbnails_;
};

}  // namespace widgets
