#include "render/WithoutDisplay.h"

#include <QFile>
#include <QXmlStreamReader>

#include "plots/Application.h"

namespace squat::tests {

void WithoutDisplay::SetUpTestSuite() {
  qunsetenv("DISPLAY");
  qunsetenv("WAYLAND_DISPLAY");
  plots::ensureApplication();
}

QByteArray WithoutDisplay::contents(const std::string& path) {
  QFile file(QString::fromStdString(path));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path;
  return file.readAll();
}

std::vector<std::string> WithoutDisplay::textsOf(const QByteArray& svg) {
  QXmlStreamReader reader(svg);
  std::vector<std::string> texts;
  while (!reader.atEnd())
    if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == QLatin1String("text"))
      texts.push_back(reader.readElementText().toStdString());
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
  return texts;
}

}  // namespace squat::tests
