// tests/gui/EditorOfProfile.h - the profile editor with a defect of five points.
#pragma once

#include <gtest/gtest.h>

#include <QTest>

#include "case/CaseFile.h"
#include "plots/Style.h"
#include "studio/document/CaseDocument.h"
#include "studio/profile/ProfileEditor.h"

namespace squat::tests {

class EditorOfProfile : public testing::Test {
 protected:
  // 80 mm long and 150 um deep.
  void openFivePoints(cases::ModelExtent extent) {
    cases::CaseDescription description = cases::defaultCase();
    description.extent = extent;
    description.defect.shape = cases::DefectShape::profile;
    description.defect.points = {{-0.04, 0}, {-0.02, -5e-5}, {0, -1.5e-4}, {0.02, -5e-5}, {0.04, 0}};
    document_.startFrom(description, QString(), "test", false);
    editor_.resize(900, 600);
    editor_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&editor_));
  }

  studio::CaseDocument document_;
  studio::ProfileEditor editor_{document_, plots::lightStyle()};
};

}  // namespace squat::tests
