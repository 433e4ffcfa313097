#include "studio/window/HelpSearch.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QObject>
#include <QRegularExpression>
#include <QUrl>
#include <algorithm>
#include <optional>
#include <utility>

#include "text/HeadingAnchor.h"

namespace squat::studio {
namespace {

constexpr std::size_t shownSections = 3;

bool isOfManual(const HelpMatch& match) { return QFileInfo(match.page).dir().dirName() == "manual"; }

// As it reads: no marks of code, of links the text.
QString plainHeading(QString line) {
  static const QRegularExpression link("\\[([^\\]]*)\\]\\([^)]*\\)"), marks("^#+\\s*|`");
  return line.replace(link, "\\1").remove(marks).trimmed();
}

// Nothing where the page lacks one of the words, or cannot be read.
std::optional<HelpMatch> matchOf(const QString& page, const QStringList& words) {
  QFile file(page);
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
  HelpMatch match{page, titleOfPage(page), 0, {}};
  std::vector<bool> found(static_cast<std::size_t>(words.size()), false);
  bool isCode = false;
  HelpSection section;
  const auto endSection = [&] {
    if (section.count > 0 && !section.heading.isEmpty()) match.sections.push_back(section);
  };
  const auto lines = QString::fromUtf8(file.readAll()).split('\n');
  for (const QString& line : lines) {
    if (line.startsWith("```")) isCode = !isCode;
    if (!isCode && line.startsWith("##")) {
      endSection();
      const QString heading = plainHeading(line);
      section = {heading, QString::fromStdString(text::headingAnchor(heading.toStdString())), 0};
    }
    for (qsizetype i = 0; i < words.size(); ++i) {
      const int count = static_cast<int>(line.count(words[i], Qt::CaseInsensitive));
      if (count > 0) found[static_cast<std::size_t>(i)] = true;
      section.count += count, match.count += count;
    }
  }
  endSection();
  if (std::count(found.begin(), found.end(), false) > 0) return std::nullopt;
  std::stable_sort(match.sections.begin(), match.sections.end(),
                   [](const auto& a, const auto& b) { return a.count > b.count; });
  return match;
}

QString linkTo(const QString& page, const QString& anchor, const QString& text) {
  QUrl url = QUrl::fromLocalFile(page);
  if (!anchor.isEmpty()) url.setFragment(anchor);
  return QStringLiteral("<a href=\"%1\">%2</a>").arg(url.toString(QUrl::FullyEncoded), text.toHtmlEscaped());
}

}  // namespace

QString titleOfPage(const QString& page) {
  QFile file(page);
  constexpr int linesLookedAt = 40;  // a picture or badges may stand above the heading
  if (file.open(QIODevice::ReadOnly))
    for (int i = 0; i < linesLookedAt && !file.atEnd(); ++i) {
      const QString line = QString::fromUtf8(file.readLine()).trimmed();
      if (line.startsWith("# ")) return line.mid(2).trimmed();
    }
  return QFileInfo(page).completeBaseName().replace('-', ' ');
}

std::vector<HelpMatch> searchHelp(const QStringList& pages, const QString& words) {
  std::vector<HelpMatch> matches;
  const auto wanted = words.split(' ', Qt::SkipEmptyParts);
  if (wanted.isEmpty()) return matches;
  for (const QString& page : pages)
    if (auto match = matchOf(page, wanted)) matches.push_back(*std::move(match));
  std::stable_sort(matches.begin(), matches.end(), [](const auto& a, const auto& b) {
    return isOfManual(a) != isOfManual(b) ? isOfManual(a) : a.count > b.count;
  });
  return matches;
}

QString listOfMatches(const QStringList& pages, const QString& words) {
  const auto matches = searchHelp(pages, words);
  QString text = "<h1>" + QObject::tr("Pages with “%1”").arg(words.toHtmlEscaped()) + "</h1>";
  if (matches.empty()) return text + "<p>" + QObject::tr("No page holds all of these words.") + "</p>";
  text += "<ol>";
  for (const auto& match : matches) {
    text += "<li>" + linkTo(match.page, {}, match.title) + ' ' +
            (match.count == 1 ? QObject::tr("(1 match)") : QObject::tr("(%1 matches)").arg(match.count));
    QStringList sections;
    for (std::size_t i = 0; i < std::min(match.sections.size(), shownSections); ++i)
      sections << linkTo(match.page, match.sections[i].anchor, match.sections[i].heading);
    if (!sections.isEmpty()) text += "<br>" + sections.join(", ");
    text += "</li>";
  }
  return text + "</ol>";
}

}  // namespace squat::studio
