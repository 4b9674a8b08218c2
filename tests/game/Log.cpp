// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/game/Log.h"

#include <fstream>

namespace game {

using logplayer::bhuman::QueueBuilder;

namespace {

void addMotion(QueueBuilder& queue, int frame) {
  const std::uint32_t time = Log::motionMs(frame);
  queue.begin('m').sensors(time).joints(time).odometry(0.1, Log::walkedMm(frame), -20).keys().end('m');
}

void addCognition(QueueBuilder& queue, int number) {
  const View& image = View::at(number);
  const int uncertain = number - Log::kFirstUncertain;
  queue.begin('c').jpegImage(Log::imageMs(number), View::kWidth, View::kHeight, image.quads);
  queue.cameraMatrix(image.cameraInRobot, uncertain < 0 || uncertain >= Log::kUncertain);
  queue.imageCoordinateSystem(View::kWidth, View::kHeight, View::kHorizontalAngle, View::kVerticalAngle);
  if (number == 0) queue.text(Log::kText);
  queue.end('c');
}

}  // namespace

QueueBuilder Log::queue() {
  QueueBuilder queue;
  int motion = 0;
  for (int image = -1; image < View::kCount; ++image) {
    if (image >= 0) addCognition(queue, image);
    for (int i = 0; i < 2; ++i) addMotion(queue, motion++);
  }
  return queue;
}

const std::vector<std::uint8_t>& Log::bytes() {
  static const std::vector<std::uint8_t> file = queue().file();
  return file;
}

void Log::write(const std::filesystem::path& file) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes().data()), static_cast<std::streamsize>(bytes().size()));
}

}  // namespace game
