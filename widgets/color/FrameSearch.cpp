// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/FrameSearch.h"

#include <algorithm>
#include <queue>

#include "colortool/correction/ImageCorrector.h"
#include "foxglove/Image.pb.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/packages/Conversions.h"
#include "widgets/image/ImagePixels.h"

namespace widgets {
namespace {

constexpr int kFoundThumbnailHeight = 54;
constexpr std::size_t kFrameCacheBytes = 16U << 20U;  // each image is read once

}  // namespace

std::shared_ptr<const foxglove::RawImage> rawImageIn(const robotlink::StreamMessage& message) {
  if (const auto compressed = std::dynamic_pointer_cast<const foxglove::CompressedImage>(message.value)) {
    auto image = logplayer::rawImage(*compressed);
    return image ? *image : nullptr;
  }
  return std::dynamic_pointer_cast<const foxglove::RawImage>(message.value);
}

/// The data that the thread needs to examine images.
struct FrameSearch::Eye {
  colortool::SuspicionMeter meter;
  std::optional<colortool::ImageCorrector> corrector;
  robotlink::Image corrected;
  std::priority_queue<double, std::vector<double>, std::greater<>>
      // Scores of the frames that are kept, lowest on top.
      worst;

  explicit Eye(const FrameQuery& query)
      : meter(*query.table,
              query.margins ? std::span<const std::uint8_t>(*query.margins) : std::span<const std::uint8_t>(),
              query.things, query.options) {
    if (!query.correction.none()) corrector.emplace(query.correction);
  }
  colortool::Suspicion measure(const robotlink::ImageView& image) {
    if (!corrector) return meter.measure(image);
    corrector->correct(image, corrected);
    return meter.measure(corrected.view());
  }
};

FrameSearch::FrameSearch(FrameQuery query, std::function<void()> news)
    : query_(std::move(query)),
      news_(std::move(news)),
      eye_(std::make_unique<Eye>(query_)),
      worker_([this](std::monostate, const std::stop_token& stop) {
        stop_ = stop;
        if (const auto* logged = std::get_if<LoggedImages>(&query_.images))
          searchLog(*logged);
        else
          searchHistory(std::get<KeptImages>(query_.images));
      }) {
  worker_.post({});
}

FrameSearch::~FrameSearch() = default;

std::vector<SuspiciousFrame> FrameSearch::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(found_, {});
}

FrameSearch::Progress FrameSearch::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

void FrameSearch::end(std::string failure) {
  {
    const std::lock_guard lock(mutex_);
    progress_.ended = true;
    progress_.canceled = stop_.stop_requested();
    progress_.failure = std::move(failure);
  }
  news_();
}

void FrameSearch::searchLog(const LoggedImages& images) {
  logplayer::LogFile::Options options;
  options.cacheBytes = kFrameCacheBytes;
  options.progress = [this](double share) {
    {
      const std::lock_guard lock(mutex_);
      progress_.opening = share;
    }
    news_();
    return !stop_.stop_requested();
  };
  const auto log = logplayer::LogFile::open(images.log, options);
  if (stop_.stop_requested()) return end();
  if (!log) return end(log.error().describe());
  const auto stream = std::ranges::find((*log)->streams(), images.stream, &logplayer::LogFile::Stream::path);
  if (stream == (*log)->streams().end())
    return end("the log has no stream " + images.stream + "; choose one of its image streams");
  {
    const std::lock_guard lock(mutex_);
    progress_.total = stream->count;
  }
  logplayer::LogFile::Cursor cursor(*log, {images.stream});
  while (const auto message = cursor.next()) {
    if (!look(*message, images.offset)) break;
  }
  end();
}

void FrameSearch::searchHistory(const KeptImages& images) {
  {
    const std::lock_guard lock(mutex_);
    progress_.total = images.size();
  }
  for (const robotlink::StreamMessage& message : images) {
    if (!look(message, {})) break;
  }
  end();
}

bool FrameSearch::isKept(double score) {
  auto& worst = eye_->worst;
  if (worst.size() >= kMaxKept && score <= worst.top()) return false;
  worst.push(score);
  if (worst.size() > kMaxKept) worst.pop();
  return true;
}

bool FrameSearch::look(const robotlink::StreamMessage& message, robotlink::Duration offset) {
  if (stop_.stop_requested()) return false;
  const auto image = rawImageIn(message);
  const robotlink::ImageView view = image ? robotlink::imageView(*image) : robotlink::ImageView();
  const colortool::Suspicion found = view.empty() ? colortool::Suspicion() : eye_->measure(view);
  std::optional<SuspiciousFrame> frame;
  if (found.score > 0 && isKept(found.score)) {
    frame = {message.time + offset, found,
             toQImage(view).scaledToHeight(kFoundThumbnailHeight, Qt::SmoothTransformation)};
  }
  {
    const std::lock_guard lock(mutex_);
    ++progress_.seen;
    if (found.score > 0) ++progress_.suspicious;
    if (view.empty()) ++progress_.damaged;
    if (frame) found_.push_back(std::move(*frame));
    // The caller may not fetch results for a while.
    if (found_.size() > 2 * kMaxKept) {
      std::erase_if(found_,
                    [this](const SuspiciousFrame& one) { return one.found.score < eye_->worst.top(); });
    }
  }
  news_();
  return true;
}

}  // namespace widgets
