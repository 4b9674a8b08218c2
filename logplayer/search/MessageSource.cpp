// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/MessageSource.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "logplayer/file/LogFile.h"

namespace logplayer {
namespace {

using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;
using robotlink::Stretch;
using Piece = robotlink::HistoryArchive::Piece;

/// A small cache is enough: each message is read once.
constexpr std::size_t kSourceCacheBytes = 16U << 20U;

class FileMessages final : public MessageSource {
 public:
  explicit FileMessages(std::filesystem::path file) : file_(std::move(file)) {}

  Result<void> open(const Progress& progress) override {
    auto opened = LogFile::open(file_, {.cacheBytes = kSourceCacheBytes, .progress = progress});
    if (!opened) return tl::unexpected(opened.error());
    log_ = std::move(*opened);
    return {};
  }
  std::vector<std::string> streams() const override {
    std::vector<std::string> paths;
    for (const LogFile::Stream& stream : log_->streams()) paths.push_back(stream.path);
    return paths;
  }
  Stretch stretch() const override { return {log_->begin(), log_->end()}; }
  std::unique_ptr<Cursor> read(const std::vector<std::string>& streams, Instant from) override {
    return std::make_unique<LogCursor>(LogFile::Cursor(log_, streams), from);
  }

 private:
  class LogCursor final : public Cursor {
   public:
    LogCursor(LogFile::Cursor cursor, Instant from) : cursor_(std::move(cursor)) {
      if (from > Instant::min()) cursor_.seek(from);
    }
    std::optional<Instant> nextTime() override { return cursor_.nextTime(); }
    std::optional<StreamMessage> next() override { return cursor_.next(); }

   private:
    LogFile::Cursor cursor_;
  };

  const std::filesystem::path file_;
  std::shared_ptr<LogFile> log_;
};

/// The files that are open; streams share them.
class OpenPieces {
 public:
  /// Null: it cannot be read.
  std::shared_ptr<LogFile> open(const std::filesystem::path& file) {
    std::erase_if(files_, [](const auto& entry) { return entry.second.expired(); });
    auto known = files_[file].lock();
    if (known) return known;
    auto opened = LogFile::open(file, {.cacheBytes = kSourceCacheBytes, .progress = {}});
    if (!opened) return nullptr;
    files_[file] = *opened;
    return *opened;
  }

 private:
  std::map<std::filesystem::path, std::weak_ptr<LogFile>> files_;
};

/// The messages of one stream, from one piece to the next.
class PieceStream {
 public:
  PieceStream(const std::vector<Piece>& pieces, OpenPieces& open, std::string path, Instant from)
      : pieces_(pieces), open_(open), path_(std::move(path)), from_(from) {
    advance();
  }

  const std::optional<StreamMessage>& next() const { return next_; }
  StreamMessage take() {
    StreamMessage taken = std::move(*next_);
    advance();
    return taken;
  }

 private:
  void advance() {
    do {
      next_ = readOn();
    } while (!next_ && enter());
  }
  /// The next message of the present piece.
  std::optional<StreamMessage> readOn() {
    if (log_) return log_->next();
    while (messages_ && at_ < messages_->size()) {
      const StreamMessage& message = (*messages_)[at_++];
      if (message.path == path_ && message.time >= from_) return message;
    }
    return std::nullopt;
  }
  /// Enters the next piece with messages; false: there is none.
  bool enter() {
    log_.reset();
    messages_.reset();
    while (piece_ < pieces_.size()) {
      const Piece& piece = pieces_[piece_++];
      const auto times = piece.times->find(path_);
      if (times == piece.times->end() || times->second.to < from_) continue;
      messages_ = piece.messages;
      at_ = 0;
      if (messages_) return true;
      const auto file = open_.open(piece.file);
      if (file == nullptr) continue;
      log_.emplace(file, std::vector<std::string>{path_});
      if (from_ > Instant::min()) log_->seek(from_);
      return true;
    }
    return false;
  }

  const std::vector<Piece>& pieces_;
  OpenPieces& open_;
  const std::string path_;
  const Instant from_;
  std::size_t piece_ = 0, at_ = 0;
  std::optional<LogFile::Cursor> log_;
  std::shared_ptr<const std::vector<StreamMessage>> messages_;
  std::optional<StreamMessage> next_;
};

class HistoryMessages final : public MessageSource {
 public:
  explicit HistoryMessages(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  Result<void> open(const Progress&) override { return {}; }
  std::vector<std::string> streams() const override {
    std::set<std::string> paths;
    for (const Piece& piece : pieces_) {
      for (const auto& [path, times] : *piece.times) paths.insert(path);
    }
    return {paths.begin(), paths.end()};
  }
  Stretch stretch() const override {
    return pieces_.empty() ? Stretch{} : Stretch{pieces_.front().held.from, pieces_.back().held.to};
  }
  std::unique_ptr<Cursor> read(const std::vector<std::string>& streams, Instant from) override {
    return std::make_unique<PieceCursor>(pieces_, streams, from);
  }

 private:
  class PieceCursor final : public Cursor {
   public:
    PieceCursor(const std::vector<Piece>& pieces, const std::vector<std::string>& streams, Instant from) {
      for (const std::string& stream : streams)
        streams_.push_back(std::make_unique<PieceStream>(pieces, open_, stream, from));
    }
    std::optional<Instant> nextTime() override {
      PieceStream* first = earliest();
      return first != nullptr ? std::optional(first->next()->time) : std::nullopt;
    }
    std::optional<StreamMessage> next() override {
      PieceStream* first = earliest();
      return first != nullptr ? std::optional(first->take()) : std::nullopt;
    }

   private:
    /// Null at the end.
    PieceStream* earliest() {
      PieceStream* first = nullptr;
      for (const auto& stream : streams_) {
        if (stream->next() && (first == nullptr || stream->next()->time < first->next()->time))
          first = stream.get();
      }
      return first;
    }

    OpenPieces open_;
    std::vector<std::unique_ptr<PieceStream>> streams_;
  };

  const std::vector<Piece> pieces_;
};

}  // namespace

std::unique_ptr<MessageSource> logSource(std::filesystem::path file) {
  return std::make_unique<FileMessages>(std::move(file));
}

std::unique_ptr<MessageSource> historySource(std::vector<Piece> pieces) {
  return std::make_unique<HistoryMessages>(std::move(pieces));
}

}  // namespace logplayer
