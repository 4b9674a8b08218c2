// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "tests/app/far/FarLine.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {

/// What somebody at the desk does with robots whose programs run on another machine: `robotctl sim --listen`
/// and `robotctl run --listen` in processes of their own, with encryption and tokens. Derived classes say how
/// that machine is reached; each runs all of these tests.
class FarRobotSteps : public WindowTest {
  Q_OBJECT
 protected:
  /// A new line for a test; null, after QSKIP, where there can be none.
  virtual std::unique_ptr<FarLine> makeLine() = 0;

 private Q_SLOTS:
  void keysAndSolutionsAreSwitched();
  void itIsDrivenStandsWhenItIsReleasedAndObeysStop();
  void itPlaysWithAColorTableThatIsSentToIt();
  void itsProgramMovesToAProcessOfItsOwnAndIsStartedAgain();
  void theLineIsLostWhileItIsDrivenAndFoundByItself();
  void whatComesOverTheLineIsRecorded();
  void itsPicturesAreThoseOfAHostedRobot();
  void aPioneerIsDrivenStoppedLostAndFound();
};

}  // namespace app::test
