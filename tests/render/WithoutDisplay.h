// tests/render/WithoutDisplay.h - figures as files, drawn with no display at all, and what such files hold.
#pragma once

#include <gtest/gtest.h>

#include <QByteArray>
#include <string>
#include <vector>

namespace squat::tests {

class WithoutDisplay : public testing::Test {
 protected:
  static void SetUpTestSuite();
  static QByteArray contents(const std::string& path);
  // All character data of <text> elements; fails where the document is not well-formed.
  static std::vector<std::string> textsOf(const QByteArray& svg);
};

}  // namespace squat::tests
