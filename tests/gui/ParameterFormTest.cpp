// The form: every key, wrong values in place, reset.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "case/ParameterTable.h"
#include "studio/common/Theme.h"
#include "studio/document/CaseDocument.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"

namespace squat::studio {
namespace {

class Form : public testing::Test {
 protected:
  void SetUp() override {
    form_.resize(400, 600);
    form_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&form_));
  }
  void TearDown() override { QSettings().setValue("parameterLevel", 2); }
  QLineEdit* line(const std::string& key) { return qobject_cast<QLineEdit*>(form_.row(key)->editor()); }
  void type(const std::string& key, const QString& text) {
    line(key)->setFocus();
    line(key)->selectAll();
    QTest::keyClicks(line(key), text);
  }
  CaseDocument document_;
  ParameterForm form_{document_};
};

TEST_F(Form, hasOneRowForEveryKey) {
  EXPECT_EQ(form_.rows().size(), cases::parameterTable().size());
  for (const auto& parameter : cases::parameterTable()) {
    const ParameterRow* row = form_.row(parameter.key);
    ASSERT_NE(row, nullptr) << parameter.key;
    EXPECT_FALSE(row->editor()->accessibleName().isEmpty());
    EXPECT_TRUE(row->toolTip().contains(QString::fromStdString(parameter.doc).toHtmlEscaped())) << parameter.key;
  }
}

TEST_F(Form, typingChangesTheCaseAndUndoShowsTheOldValue) {
  type("motion.speed", "27");
  QTest::keyClick(line("motion.speed"), Qt::Key_Return);
  EXPECT_DOUBLE_EQ(document_.description().motion.speed, 27);
  EXPECT_TRUE(form_.row("motion.speed")->isChanged());
  document_.undoStack().undo();
  EXPECT_EQ(line("motion.speed")->text(), "30");
  EXPECT_FALSE(form_.row("motion.speed")->isChanged());
}

TEST_F(Form, aWrongValueIsFlaggedWhileTypingAndBlocksTheRun) {
  EXPECT_TRUE(form_.blockers().isEmpty()) << form_.blockers().join("; ").toStdString();
  type("pad.stiffness", "-5");
  EXPECT_FALSE(form_.row("pad.stiffness")->reason().isEmpty());
  ASSERT_EQ(form_.blockers().size(), 1);
  EXPECT_TRUE(form_.blockers()[0].startsWith("pad.stiffness"));
  QTest::keyClick(line("pad.stiffness"), Qt::Key_Return);
  EXPECT_EQ(document_.undoStack().count(), 0);
  type("pad.stiffness", "800");
  QTest::keyClick(line("pad.stiffness"), Qt::Key_Return);
  EXPECT_TRUE(form_.blockers().isEmpty());
  EXPECT_DOUBLE_EQ(document_.description().pad.stiffness, 800e6);
}

TEST_F(Form, curvesAndSeatsAreTypedAndJudgedWhileTyping) {
  type("pad.curve", "[[0, 0], [0.1, 20], [0.2, 10]]");
  EXPECT_TRUE(form_.row("pad.curve")->reason().contains("must rise")) << form_.row("pad.curve")->reason().toStdString();
  type("pad.curve", "[[0, 0], [0.1, 20], [0.2, 70]]");
  EXPECT_TRUE(form_.row("pad.curve")->reason().isEmpty());
  QTest::keyClick(line("pad.curve"), Qt::Key_Return);
  ASSERT_EQ(document_.description().pad.curve.size(), 3u);
  EXPECT_DOUBLE_EQ(document_.description().pad.curve[2].force, 70e3);
  type("track.seats", "[{ sleeper = 1, pad = 300 }]");
  EXPECT_TRUE(form_.row("track.seats")->reason().contains("there is no key pad"));
  type("track.seats", "[{ sleeper = 1, pad_stiffness = 300 }, { sleeper = -1, gap = 0.5 }]");
  QTest::keyClick(line("track.seats"), Qt::Key_Return);
  EXPECT_TRUE(form_.blockers().isEmpty()) << form_.blockers().join("; ").toStdString();
  ASSERT_EQ(document_.description().track.seats.size(), 2u);
  EXPECT_DOUBLE_EQ(*document_.description().track.seats[1].gap, 0.5e-3);
  // A sleeper beyond the rail is found where the keys are seen together.
  type("track.seats", "[{ sleeper = 900, gap = 0.5 }]");
  QTest::keyClick(line("track.seats"), Qt::Key_Return);
  ASSERT_EQ(form_.blockers().size(), 1);
  EXPECT_TRUE(form_.blockers()[0].startsWith("track.seats"));
  document_.resetParameter("track.seats");
  EXPECT_TRUE(document_.description().track.seats.empty());
}

// The user means to mend the text, not to lose it because something else was edited meanwhile.
TEST_F(Form, aRefusedTextStaysUntilItsOwnValueChanges) {
  const auto refuse = [this] {
    type("motion.speed", "35,5.5");
    QTest::keyClick(line("motion.speed"), Qt::Key_Return);
  };
  refuse();
  type("contact.friction", "0.4");
  QTest::keyClick(line("contact.friction"), Qt::Key_Return);
  EXPECT_DOUBLE_EQ(document_.description().contact.friction, 0.4);
  EXPECT_EQ(line("motion.speed")->text(), "35,5.5");
  EXPECT_FALSE(form_.row("motion.speed")->reason().isEmpty());
  EXPECT_EQ(form_.blockers().size(), 1);
  document_.undoStack().undo();  // of the friction
  EXPECT_EQ(line("motion.speed")->text(), "35,5.5");
  document_.setParameter("motion.speed", "32");
  EXPECT_EQ(line("motion.speed")->text(), "32");
  EXPECT_TRUE(form_.blockers().isEmpty()) << form_.blockers().join("; ").toStdString();
  refuse();
  document_.undoStack().undo();  // back to 30
  EXPECT_EQ(line("motion.speed")->text(), "30");
  refuse();
  document_.startNew();  // has the same speed
  EXPECT_EQ(line("motion.speed")->text(), "30");
  EXPECT_TRUE(form_.refusals().isEmpty());
}

// Many write 30,5 for 30.5, and in a field of one number it can mean nothing else. What is shown then has a point.
TEST_F(Form, aDecimalCommaIsTaken) {
  struct Row {
    const char *key, *typed, *shown;
  };
  for (const Row& row : {Row{"motion.speed", "30,5", "30.5"}, Row{"defect.depth", "0,15", "0.15"},  // the default
                         Row{"defect.depth", "0,25", "0.25"}, Row{"contact.friction", ",35", "0.35"},
                         Row{"pad.stiffness", "1,25e3 MN/m", "1250"}}) {
    SCOPED_TRACE(row.typed);
    type(row.key, row.typed);
    EXPECT_EQ(form_.row(row.key)->reason().toStdString(), "");  // while typing already
    QTest::keyClick(line(row.key), Qt::Key_Return);
    EXPECT_EQ(line(row.key)->text(), row.shown);
    EXPECT_TRUE(form_.blockers().isEmpty()) << form_.blockers().join("; ").toStdString();
  }
  EXPECT_DOUBLE_EQ(document_.description().motion.speed, 30.5);
  EXPECT_DOUBLE_EQ(document_.description().defect.depth, 0.25e-3);
  EXPECT_DOUBLE_EQ(document_.description().pad.stiffness, 1250e6);
  type("defect.wave_count", "2,5");
  EXPECT_TRUE(form_.row("defect.wave_count")->reason().contains("whole number"));
}

// Whether 8,000.5 has a comma of thousands is not guessed.
TEST_F(Form, groupedThousandsAreRefusedWithWhatIsAllowed) {
  for (const char* typed : {"8,000.5", "8.000,5", "8,000,000"}) {
    type("suspension.sprung_mass", typed);
    const QString reason = form_.row("suspension.sprung_mass")->reason();
    for (const char* words : {typed, " kg", "one decimal point or comma", "nothing between thousands"})
      EXPECT_TRUE(reason.contains(words)) << reason.toStdString();
    QTest::keyClick(line("suspension.sprung_mass"), Qt::Key_Return);
    EXPECT_EQ(line("suspension.sprung_mass")->text(), typed);  // to be mended
  }
  EXPECT_EQ(document_.undoStack().count(), 0);
}

// The pairs of a curve: 1 mm and 5 kN, not 1.5.
TEST_F(Form, aCommaInAListSeparates) {
  type("pad.curve", "[[0,0],[1,5],[2,20]]");
  QTest::keyClick(line("pad.curve"), Qt::Key_Return);
  ASSERT_EQ(document_.description().pad.curve.size(), 3u);
  EXPECT_DOUBLE_EQ(document_.description().pad.curve[1].compression, 1e-3);
  EXPECT_DOUBLE_EQ(document_.description().pad.curve[1].force, 5e3);
}

// Without Enter, and without another field that takes the focus. The sanitizers watch the order of destruction.
TEST(FormEnd, textInTheFieldWithTheFocusReachesTheCase) {
  CaseDocument document;
  {
    ParameterForm form(document);
    form.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&form));
    QApplication::setActiveWindow(&form);  // no window manager does it under a bare X server
    auto* line = qobject_cast<QLineEdit*>(form.row("motion.speed")->editor());
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, "27");
    EXPECT_DOUBLE_EQ(document.description().motion.speed, 30);
  }
  EXPECT_DOUBLE_EQ(document.description().motion.speed, 27);
}

// Also where the value has never left its default.
TEST_F(Form, aRefusedTextCanBeReset) {
  type("motion.speed", "400");
  QTest::keyClick(line("motion.speed"), Qt::Key_Return);
  auto* reset = form_.row("motion.speed")->findChild<QToolButton*>();
  ASSERT_TRUE(reset && reset->isVisible());
  form_.findChild<QCheckBox*>("changedOnly")->setChecked(true);  // only what was changed
  EXPECT_TRUE(line("motion.speed")->isVisible());
  form_.findChild<QCheckBox*>("changedOnly")->setChecked(false);
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(line("motion.speed")->text(), "30");
  EXPECT_TRUE(form_.blockers().isEmpty());
  EXPECT_FALSE(reset->isVisible());
}

TEST_F(Form, aNewcomerSeesADozenParameters) {
  const auto shown = [&] {
    return std::count_if(form_.rows().begin(), form_.rows().end(), [](const auto* row) { return row->isVisible(); });
  };
  auto* level = form_.findChild<QComboBox*>("parameterLevel");
  EXPECT_EQ(shown(), static_cast<std::ptrdiff_t>(cases::parameterTable().size()));  // as the tests begin
  level->setCurrentText("Basic");
  EXPECT_GE(shown(), 10);
  EXPECT_LE(shown(), 15);
  EXPECT_TRUE(form_.row("motion.speed")->isVisible());
  EXPECT_FALSE(form_.row("contact.normal_penalty")->isVisible());
  level->setCurrentText("Advanced");
  EXPECT_TRUE(form_.row("ballast.stiffness")->isVisible());
  EXPECT_FALSE(form_.row("contact.normal_penalty")->isVisible());
}

// What decides a run and what is looked for is seen at every level.
TEST_F(Form, changedWrongAndSoughtParametersAreShownAtEveryLevel) {
  form_.findChild<QComboBox*>("parameterLevel")->setCurrentText("Basic");
  ParameterRow* ramp = form_.row("motion.torque_ramp");
  EXPECT_FALSE(ramp->isVisible());
  form_.findChild<QLineEdit*>("parameterSearch")->setText("torque");
  EXPECT_TRUE(ramp->isVisible());
  type("motion.torque_ramp", "0.05");
  QTest::keyClick(line("motion.torque_ramp"), Qt::Key_Return);
  form_.findChild<QLineEdit*>("parameterSearch")->clear();
  EXPECT_TRUE(ramp->isVisible());
  line("motion.speed")->setFocus();
  document_.undoStack().undo();
  EXPECT_FALSE(ramp->isVisible());
  form_.mark({{"mesh.far_size", "0.9", "at most 0.3", "Make it smaller"}});
  EXPECT_TRUE(form_.row("mesh.far_size")->isVisible());
}

// A preset sets thirty sizes that nobody typed.
TEST_F(Form, whatAPresetSetsIsNotShownForThat) {
  form_.findChild<QComboBox*>("parameterLevel")->setCurrentText("Basic");
  document_.setParameter("wheelset.preset", "estimated");
  ParameterRow* radius = form_.row("wheelset.axle_radius");
  EXPECT_TRUE(radius->isChanged());
  EXPECT_FALSE(radius->isVisible());
  document_.setParameter("wheelset.axle_radius", "81");
  EXPECT_TRUE(radius->isVisible());
}

TEST_F(Form, theChosenLevelIsKept) {
  form_.findChild<QComboBox*>("parameterLevel")->setCurrentText("Advanced");
  const ParameterForm next(document_);
  EXPECT_EQ(next.findChild<QComboBox*>("parameterLevel")->currentText(), "Advanced");
}

TEST_F(Form, relationsAreFlaggedAtTheirKey) {
  document_.setParameter("motion.run_up", "9");  // longer than the track is before the defect
  EXPECT_FALSE(form_.blockers().isEmpty());
}

TEST_F(Form, searchLeavesWhatMatches) {
  auto* search = form_.findChild<QLineEdit*>("parameterSearch");
  QTest::keyClicks(search, "friction");
  EXPECT_TRUE(form_.row("contact.friction")->isVisible());
  EXPECT_FALSE(form_.row("pad.stiffness")->isVisible());
}

// A key that does not apply is greyed, and the tool tip says why; it comes back as soon as it applies.
TEST_F(Form, aKeyWithoutEffectIsGreyedWithTheReason) {
  document_.setParameter("defect.shape", "cosine");
  const ParameterRow* ramp = form_.row("defect.ramp");
  const auto colour = [](const ParameterRow& row) { return row.editor()->palette().color(QPalette::Text); };
  const QColor usual = colour(*form_.row("defect.length"));
  EXPECT_EQ(colour(*ramp), form_.palette().color(QPalette::PlaceholderText));
  EXPECT_NE(colour(*ramp), usual);
  EXPECT_TRUE(ramp->editor()->isEnabled());  // the keyboard reaches it, and F1 explains it
  EXPECT_TRUE(ramp->toolTip().contains("no effect because defect.shape is cosine")) << ramp->toolTip().toStdString();
  EXPECT_TRUE(ramp->editor()->accessibleDescription().contains("defect.shape is cosine"));
  applyTheme(true);
  QTest::qWait(20);
  EXPECT_EQ(colour(*ramp), form_.palette().color(QPalette::PlaceholderText));  // the grey of the dark ground
  applyTheme(false);
  QTest::qWait(20);
  document_.setParameter("defect.shape", "cut");
  EXPECT_EQ(colour(*ramp), usual);
  EXPECT_FALSE(ramp->toolTip().contains("no effect"));
}

// A key with two conditions counts where one holds.
TEST_F(Form, oneOfTwoConditionsIsEnough) {
  const ParameterRow* ramp = form_.row("motion.torque_ramp");
  EXPECT_TRUE(ramp->toolTip().contains("no effect"));
  ASSERT_EQ(document_.setParameter("motion.torque", "2"), std::nullopt);
  EXPECT_FALSE(ramp->toolTip().contains("no effect")) << ramp->toolTip().toStdString();
}

// 30 m/s are 108 km/h. Both wheels carry 8000 kg each and weigh 950 kg each: 17.9 t, 175.6 kN at 9.81 m/s2.
TEST_F(Form, speedAndLoadAreShownInOtherUnits) {
  const auto other = [&](const char* key) { return form_.row(key)->findChild<QLabel*>("otherUnits")->text(); };
  for (const char* key : {"motion.speed", "suspension.sprung_mass"}) {
    EXPECT_TRUE(form_.row(key)->findChild<QLabel*>("otherUnits")->isVisible()) << key;
  }
  document_.setParameter("motion.speed", "30");
  document_.setParameter("suspension.sprung_mass", "8000");
  document_.setParameter("wheelset.total_mass", "950");
  document_.setParameter("motion.gravity", "9.81");
  EXPECT_EQ(other("motion.speed"), "= 108 km/h");
  EXPECT_EQ(other("suspension.sprung_mass"), "axle load 17.9 t (176 kN)");
  EXPECT_EQ(other("pad.stiffness"), "");
}

}  // namespace
}  // namespace squat::studio
