// SPDX-License-Identifier: GPL-3.0-or-later
// A camera with the program that sees its images.
#include <gtest/gtest.h>

#include <mutex>
#include <set>

#include "app/core/camera/CameraOptions.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/real/RealRun.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/QueueMessages.h"
#include "tests/Eventually.h"
#include "tests/app/camera/FakeCamera.h"

namespace app {
namespace {

class CameraRunTest : public testing::Test {
 protected:
  CameraRunTest() {
    camera_.width = 64, camera_.height = 48;
    camera_.formats = {V4L2_PIX_FMT_YUYV};
  }
  void open(const std::string& url = "camera:///dev/video0") {
    RealRun::Listeners listeners;
    listeners.queue = [this](const std::string& robot, const auto& queue) {
      const std::lock_guard lock(mutex_);
      for (const auto& message : robotlink::messagesOf(robot, *queue, {}).messages)
        paths_.insert(message.path);
    };
    listeners.platform = [this](const std::string&, robotlink::Instant, const std::string& text) {
      const std::lock_guard lock(mutex_);
      reports_ += text + "\n";
    };
    auto run = RealRun::create(cameraOptions(url, camera_), listeners);
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
    for (const char* key : {"package/camera/image", "package/camera/pose", "package/percepts/regions"}) {
      robotcontrol::Request request;
      request.set_robot("camera");
      request.mutable_set_key()->set_name(key);
      request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
      EXPECT_TRUE(run_->request(request));
    }
  }
  void giveImage() { camera_.give(std::string(64 * 48 * 2, '\x60')); }
  bool playUntil(const std::function<bool()>& happens) {
    return eventually([&] {
      if (camera_.waiting() == 0) giveImage();
      run_->step();
      return happens();
    });
  }
  bool has(const std::string& path) {
    const std::lock_guard lock(mutex_);
    return paths_.contains(path);
  }
  bool reported(const std::string& text) {
    const std::lock_guard lock(mutex_);
    return reports_.find(text) != std::string::npos;
  }

  test::FakeCamera camera_;
  std::mutex mutex_;  // protects paths_ and reports_
  std::set<std::string> paths_;
  std::string reports_;
  std::unique_ptr<RealRun> run_;
};

TEST_F(CameraRunTest, itsImagesAreSeenByPerceptionWithTheCamerasPose) {
  open();
  EXPECT_TRUE(playUntil([&] { return has("camera/camera/image") && has("camera/camera/pose"); }));
  EXPECT_TRUE(run_->platform().isConnected());
  EXPECT_TRUE(reported("Fake camera takes images of 64x48 (YUYV), 30 a second."));
}

TEST_F(CameraRunTest, aCameraThatWasUnpluggedIsOpenedAgain) {
  open();
  EXPECT_TRUE(playUntil([&] { return run_->platform().isConnected(); }));
  camera_.unplug(true);
  EXPECT_TRUE(playUntil([&] { return !run_->platform().isConnected() && reported("it is tried again"); }));
  EXPECT_EQ(camera_.opened(), 0);
  camera_.unplug(false);
  run_->connectNow();
  EXPECT_TRUE(playUntil([&] { return run_->platform().isConnected(); }));
}

TEST_F(CameraRunTest, itIsOpenedWhenItIsPluggedIn) {
  camera_.unplug(true);
  open();
  EXPECT_TRUE(playUntil([&] { return reported("is the camera plugged in?"); }));
  camera_.unplug(false);
  run_->connectNow();
  EXPECT_TRUE(playUntil([&] { return has("camera/camera/image"); }));
}

TEST_F(CameraRunTest, anAddressThatIsNoneIsRefused) {
  const auto run = RealRun::create(cameraOptions("camera:///dev/video0?size=1", camera_), {});
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().front().id, "camera.address");
}

TEST(CameraAdapter, opensCamerasBeforeSerialLines) {
  for (const char* source : {"camera:///dev/video0", "/dev/video0", "camera:///dev/video0?size=1"}) {
    const PlatformAdapter* adapter = adapterFor(source);
    ASSERT_NE(adapter, nullptr) << source;
    EXPECT_EQ(adapter->name, std::string(kCameraAdapter)) << source;
  }
  EXPECT_NE(adapterFor("/dev/ttyUSB0")->name, std::string(kCameraAdapter));
}

}  // namespace
}  // namespace app
