#include "plots/ReportLayout.h"

#include <QAbstractTextDocumentLayout>
#include <QTextCursor>
#include <QTextFrame>
#include <QTextLayout>
#include <QTextTable>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "plots/ReportWriter.h"

namespace squat::plots {
namespace {

// A paragraph, or a table.
struct Part {
  QTextBlock block;
  QTextTable* table = nullptr;
};

struct Stretch {
  double top = std::numeric_limits<double>::infinity(), bottom = 0;  // in units of the layout
};

class PageArranger {
 public:
  PageArranger(QTextDocument& document, double unitsPerInch)
      : layout_(document.documentLayout()), pageHeight_(document.pageSize().height()), unitsPerInch_(unitsPerInch) {
    QTextFrame* root = document.rootFrame();
    for (auto it = root->begin(); !it.atEnd(); ++it) {
      if (auto* table = qobject_cast<QTextTable*>(it.currentFrame()))
        parts_.push_back({{}, table});
      else if (it.currentBlock().isValid() && it.currentBlock().length() > 1)  // Qt hides empty ones beside tables
        parts_.push_back({it.currentBlock(), nullptr});
    }
  }

  // In the order of the pages: what is moved moves all behind it.
  void arrange() {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i].table) {
        keepRowsWhole(*parts_[i].table);
        continue;
      }
      if (breaksBefore(parts_[i].block) && i > 0 && pageOf(topOf(i)) > pageOf(bottomOf(i - 1)) + 1)
        setBreak(parts_[i].block, QTextFormat::PageBreak_Auto);
      else if (staysWith(i) && pageOf(endOfStart(i)) > pageOf(topOf(i)))
        setBreak(parts_[i].block, QTextFormat::PageBreak_AlwaysBefore);
    }
  }

 private:
  static bool breaksBefore(const QTextBlock& block) {
    return block.blockFormat().pageBreakPolicy() & QTextFormat::PageBreak_AlwaysBefore;
  }
  static void setBreak(const QTextBlock& block, QTextFormat::PageBreakFlags flags) {
    QTextBlockFormat format = block.blockFormat();
    format.setPageBreakPolicy(flags);
    QTextCursor(block).setBlockFormat(format);
  }

  bool staysWith(std::size_t part) const {
    return !parts_[part].table && parts_[part].block.blockFormat().boolProperty(staysWithNext) &&
           part + 1 < parts_.size();
  }
  // Ends of pages belong to the page above: a hundredth of an inch less than the end of a line.
  int pageOf(double place) const { return static_cast<int>(std::floor((place - 0.01 * unitsPerInch_) / pageHeight_)); }

  Stretch stretchOf(const QTextTable& table, int row) const {
    Stretch found;
    for (int column = 0; column < table.columns(); ++column) {
      const QTextTableCell cell = table.cellAt(row, column);
      found.top = std::min(found.top, layout_->blockBoundingRect(cell.firstCursorPosition().block()).top());
      found.bottom = std::max(found.bottom, layout_->blockBoundingRect(cell.lastCursorPosition().block()).bottom());
    }
    return found;
  }
  // A little below the first line's upper edge, so that it is on the page of the line.
  double topOf(std::size_t part) const {
    const auto* table = parts_[part].table;
    const double top = table ? stretchOf(*table, 0).top : layout_->blockBoundingRect(parts_[part].block).top();
    return top + 0.02 * unitsPerInch_;
  }
  double bottomOf(std::size_t part) const {
    const auto* table = parts_[part].table;
    return table ? stretchOf(*table, table->rows() - 1).bottom
                 : layout_->blockBoundingRect(parts_[part].block).bottom();
  }
  // Where ends what has to stand on the page of a heading: the first line, or the head and two rows, of what follows.
  double endOfStart(std::size_t part) const {
    while (staysWith(part)) ++part;
    if (const auto* table = parts_[part].table)
      return stretchOf(*table, std::min(table->rows(), table->format().headerRowCount() + 2) - 1).bottom;
    const QTextBlock& block = parts_[part].block;
    const double height = block.layout()->lineCount() > 0 ? block.layout()->lineAt(0).height() : 0;
    return layout_->blockBoundingRect(block).top() + height;
  }

  // A row that a page would end in begins on the next one: half a sentence beside a number says nothing.
  void keepRowsWhole(QTextTable& table) const {
    for (int row = table.format().headerRowCount(); row < table.rows(); ++row) {
      const Stretch found = stretchOf(table, row);
      const double end = (std::floor(found.top / pageHeight_) + 1) * pageHeight_;
      if (found.bottom <= end) continue;
      for (int column = 0; column < table.columns(); ++column) {
        QTextTableCell cell = table.cellAt(row, column);
        QTextTableCellFormat format = cell.format().toTableCellFormat();
        format.setTopPadding(screenDots((end - found.top) / unitsPerInch_ * 25.4) + screenDots(cellPadding));
        cell.setFormat(format);
      }
    }
  }

  QAbstractTextDocumentLayout* layout_;
  double pageHeight_, unitsPerInch_;
  std::vector<Part> parts_;
};

}  // namespace

void arrangePages(QTextDocument& document, double unitsPerInch) { PageArranger(document, unitsPerInch).arrange(); }

}  // namespace squat::plots
