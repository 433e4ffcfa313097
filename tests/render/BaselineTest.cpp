// Every figure beside its baseline in tests/render/baselines, as a thumbnail of 251 pixels, in colour and pixel by
// pixel (PictureComparison.h).
// A missing baseline is written to the build folder and the test fails; to renew one, look at the new picture and copy
// it.
#include <gtest/gtest.h>

#include <QImage>
#include <QString>

#include "plots/Application.h"
#include "plots/FigureRegistry.h"
#include "plots/Figures.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"

namespace squat {
namespace {

TEST(Baseline, figuresLookAsTheyDid) {
  plots::ensureApplication();
  const std::string folder = tests::freshFolder("baseline");
  const QString kept = QStringLiteral(SQUAT_SOURCE_DIR "/tests/render/baselines/%1.png");
  const QString now = QString::fromStdString(folder) + "/now_%1.png";
  plots::renderFigures(tests::syntheticResult(), folder, {{}, {"png"}});
  for (const auto& row : plots::figureRegistry()) {
    const QString figure = QString::fromStdString(row.name);
    const QImage small = tests::thumbnail(QImage(QString::fromStdString(folder + "/" + row.name + ".png")), 251);
    small.save(now.arg(figure));
    const QImage baseline(kept.arg(figure));
    EXPECT_EQ(tests::lookDifferent(small, baseline), "")
        << "now: " << now.arg(figure).toStdString() << "  kept: " << kept.arg(figure).toStdString();
  }
}

}  // namespace
}  // namespace squat
