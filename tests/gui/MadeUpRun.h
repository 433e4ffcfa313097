// tests/gui/MadeUpRun.h - a run without mechanics, for tests of the window around it.
#pragma once

#include <QString>

#include "studio/window/MainWindow.h"

namespace squat::tests {

// Takes about `milliseconds`, reports every one of them, obeys pause and cancel, and hands over the made-up result.
// Fails with a RunError half-way where the case's title is "fails".
studio::Runner madeUpRunner(int milliseconds);

// Services for a window that never asks with a box: `answer` is given at once.
studio::StudioServices services(int milliseconds = 50, studio::Answer answer = studio::Answer::discard);

// Lets events pass until `condition` holds; false after `milliseconds`.
template <class Condition>
bool passes(const Condition& condition, int milliseconds = 5000);

}  // namespace squat::tests

#include <QTest>

template <class Condition>
bool squat::tests::passes(const Condition& condition, int milliseconds) {
  return QTest::qWaitFor(condition, milliseconds);
}
