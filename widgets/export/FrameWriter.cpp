// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/FrameWriter.h"

#include <QString>

#include "logplayer/pictures/VideoOutput.h"
#include "widgets/WrittenPicture.h"

namespace widgets {

using robotlink::Result;

namespace {

/// A picture of exactly this size.
QImage sized(const QImage& picture, const QSize& size) {
  QImage result = picture;
  result.setDevicePixelRatio(1);
  if (result.isNull()) {
    result = QImage(size, QImage::Format_RGB32);
    result.fill(Qt::black);
  }
  return result.size() == size ? result
                               : result.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace

/// The destination of pictures. Used by one thread.
class FrameWriter::Sink {
 public:
  virtual ~Sink() = default;
  virtual Result<void> write(const QImage& picture) = 0;
  virtual Result<void> finish() = 0;
};

class FrameWriter::VideoSink final : public Sink {
 public:
  VideoSink(logplayer::VideoOutput video, QSize size) : video_(std::move(video)), size_(size) {}
  Result<void> write(const QImage& picture) override {
    const QImage frame = sized(picture, size_).convertToFormat(QImage::Format_BGR888);
    return video_.write(frame.constBits(), static_cast<int>(frame.bytesPerLine()));
  }
  Result<void> finish() override { return video_.finish(); }

 private:
  logplayer::VideoOutput video_;
  const QSize size_;
};

class FrameWriter::ImageSink final : public Sink {
 public:
  explicit ImageSink(const ExportPlan& plan) : plan_(plan) {}
  Result<void> write(const QImage& picture) override {
    const std::string number = QStringLiteral("%1").arg(++count_, 5, 10, QLatin1Char('0')).toStdString();
    const auto file = plan_.target / (plan_.name + "-" + number + ".png");
    return writePicture(sized(picture, plan_.size), QString::fromStdString(file.string()));
  }
  Result<void> finish() override { return {}; }

 private:
  const ExportPlan& plan_;
  qint64 count_ = 0;
};

FrameWriter::FrameWriter(const ExportPlan& plan, FreeSpace freeSpace)
    : plan_(plan), freeSpace_(std::move(freeSpace)), worker_([this](const Job& job, const std::stop_token&) {
        if (!failed_) {
          const auto done = run(job);
          if (!done) failed_ = done.error();
        }
        worker_.publish({failed_, job.isEnd});
      }) {}

FrameWriter::~FrameWriter() = default;

Result<void> FrameWriter::run(const Job& job) {
  if (!sink_ && plan_.kind == ExportPlan::Kind::kImages) sink_ = std::make_unique<ImageSink>(plan_);
  if (!sink_) {
    using logplayer::VideoOutput;
    VideoOutput::Options options{plan_.size.width(), plan_.size.height(), plan_.rate, freeSpace_};
    auto video = VideoOutput::create(plan_.target, options);
    if (!video) return tl::unexpected(video.error());
    const QSize even(VideoOutput::evenSize(options.width), VideoOutput::evenSize(options.height));
    sink_ = std::make_unique<VideoSink>(std::move(*video), even);
  }
  return job.isEnd ? sink_->finish() : sink_->write(job.picture);
}

void FrameWriter::take() {
  const auto written = worker_.take();
  if (!written) return;
  if (written->problem && !problem_) problem_ = written->problem;
  isFinished_ = written->isEnd && !written->problem;
}

bool FrameWriter::tryWrite(const QImage& picture) {
  // The last result must be taken first, so that none is lost.
  take();
  return worker_.postIfFree({picture});
}

bool FrameWriter::tryFinish() {
  take();
  return worker_.postIfFree({{}, true});
}

bool FrameWriter::isFinished() {
  take();
  return isFinished_;
}

const std::optional<robotlink::Error>& FrameWriter::problem() {
  take();
  return problem_;
}

}  // namespace widgets
