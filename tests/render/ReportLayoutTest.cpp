// Where pages end: documents of every length around the end of a page.
#include "plots/ReportLayout.h"

#include <gtest/gtest.h>

#include <QAbstractTextDocumentLayout>
#include <QGuiApplication>
#include <QScreen>
#include <QTextTable>
#include <cmath>
#include <memory>

#include "plots/Application.h"
#include "plots/ReportWriter.h"

namespace squat::plots {
namespace {

constexpr double pageHeight = 800;  // in dots of the screen, like all of the layout without a printer

class ReportLayout : public ::testing::Test {
 protected:
  void SetUp() override {
    ensureApplication();
    begin();
  }
  void begin() {
    document_ = std::make_unique<QTextDocument>();
    document_->setDocumentMargin(0);
    document_->setPageSize({600, pageHeight});
  }
  void arrange() { arrangePages(*document_, QGuiApplication::primaryScreen()->logicalDotsPerInchY()); }
  int pageOf(const QTextBlock& block) const {
    return static_cast<int>(std::floor((document_->documentLayout()->blockBoundingRect(block).top() + 1) / pageHeight));
  }
  QTextBlock blockOf(const QString& text) const { return document_->find(text).block(); }

  std::unique_ptr<QTextDocument> document_;
};

const project::ReportTable fourRows{
    "Heading", {"name", "value"}, {{"one", "1"}, {"two", "2"}, {"three", "3"}, {"four", "4"}}};

// Behind so many paragraphs; whether the heading stands on the page of the table's second row.
TEST_F(ReportLayout, keepsAHeadingWithTheFirstRowsOfItsTable) {
  int apart = 0;
  for (int count = 1; count < 60; ++count) {
    begin();
    ReportWriter writer(*document_);
    for (int i = 0; i < count; ++i) writer.paragraph("text");
    writer.heading("Part", HeadingLevel::part);
    writer.table(fourRows);
    apart += pageOf(blockOf("Part")) != pageOf(blockOf("two"));
    arrange();
    EXPECT_EQ(pageOf(blockOf("Part")), pageOf(blockOf("two"))) << count << " paragraphs";
    EXPECT_EQ(pageOf(blockOf("Heading")), pageOf(blockOf("two"))) << count << " paragraphs";
  }
  EXPECT_GT(apart, 0);  // else the pages of this test show nothing
}

TEST_F(ReportLayout, keepsAHeadingWithItsFirstLine) {
  int apart = 0;
  for (int count = 1; count < 60; ++count) {
    begin();
    ReportWriter writer(*document_);
    for (int i = 0; i < count; ++i) writer.paragraph("text");
    writer.heading("Heading");
    writer.paragraph("behind");
    apart += pageOf(blockOf("Heading")) != pageOf(blockOf("behind"));
    arrange();
    EXPECT_EQ(pageOf(blockOf("Heading")), pageOf(blockOf("behind"))) << count << " paragraphs";
  }
  EXPECT_GT(apart, 0);
}

// Two breaks in a row.
TEST_F(ReportLayout, leavesNoPageEmpty) {
  ReportWriter writer(*document_);
  writer.paragraph("before");
  QTextBlockFormat last = writer.cursor().blockFormat();
  last.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysAfter);
  writer.cursor().setBlockFormat(last);
  writer.heading("Heading", HeadingLevel::part, true);
  writer.paragraph("behind");
  ASSERT_EQ(pageOf(blockOf("Heading")), 2);
  arrange();
  EXPECT_EQ(pageOf(blockOf("Heading")), 1);
}

// The distance of a heading to the row above is that of two paragraphs with such margins.
TEST_F(ReportLayout, headingsBehindTablesHaveTheirMargin) {
  ReportWriter writer(*document_);
  writer.table(fourRows);
  writer.heading("Behind");
  const auto* layout = document_->documentLayout();
  const double gap =
      layout->blockBoundingRect(blockOf("Behind")).top() - layout->blockBoundingRect(blockOf("four")).bottom();
  EXPECT_GT(gap, screenDots(5));
  EXPECT_LT(gap, screenDots(7));  // 5 mm, and the padding of the cell
}

}  // namespace
}  // namespace squat::plots
