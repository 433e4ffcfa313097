// widgets/plots/ReportPages.h - a report on the pages of a PDF.
#pragma once

#include <QByteArray>
#include <string>
#include <vector>

#include "project/Report.h"

namespace squat::plots {

enum class PageFormat { a4, letter };

struct ReportOptions {
  PageFormat page = PageFormat::a4;
  std::vector<std::string> figures;   // names of figureRegistry(); empty: all that the run has something for
  std::string colourMap = "viridis";  // or "cividis", "jet"
};

// Title, date and version; a picture; a sentence a run; notes, summary and changed inputs; squats, a page each with the
// signal over it; an appendix with the other figures of the run that is shown, at their printed size, and all numbers
// and keys. Short notes stand under the title. Text stays text, fonts are embedded; each page has a number and the
// version of the program. `problems` gets a sentence for what could not be computed or drawn. Call ensureApplication()
// before. Throws CaseError for unknown names and for figures that the run has nothing for.
QByteArray reportPdf(const project::Report& report, const ReportOptions& options, std::vector<std::string>& problems);

}  // namespace squat::plots
