// widgets/studio/window/HelpSearch.h - which pages of the help hold the words that are looked for.
#pragma once

#include <QStringList>
#include <vector>

namespace squat::studio {

struct HelpSection {
  QString heading, anchor;
  int count = 0;  // of matches
};

struct HelpMatch {
  QString page, title;                // its file, its first heading
  int count = 0;                      // of matches in the page
  std::vector<HelpSection> sections;  // with matches, most first
};

// The first heading, else the name of the file.
QString titleOfPage(const QString& page);

// Pages (Markdown files) that hold all of the words, which blanks separate; as parts of words and whatever their case.
// Those of the manual first, then by the number of matches; equal ones in their order.
std::vector<HelpMatch> searchHelp(const QStringList& pages, const QString& words);

// The same as HTML, with links to pages and to the sections that have most matches.
QString listOfMatches(const QStringList& pages, const QString& words);

}  // namespace squat::studio
