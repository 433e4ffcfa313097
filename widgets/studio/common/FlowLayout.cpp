#include "studio/common/FlowLayout.h"

#include <QHBoxLayout>
#include <QWidget>
#include <algorithm>
#include <iterator>

namespace squat::studio {
namespace {

constexpr int gap = 4, lineGap = 3;  // [pixels]

}  // namespace

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) { setContentsMargins(0, 0, 0, 0); }

FlowLayout::~FlowLayout() {
  while (QLayoutItem* item = takeAt(0)) delete item;  // a layout that goes looks for itself here
}

void FlowLayout::addTogether(const std::vector<QWidget*>& widgets) {
  auto* row = new QHBoxLayout;
  row->setSpacing(gap);
  for (QWidget* widget : widgets) row->addWidget(widget);
  addChildLayout(row);
  addItem(row);
}

void FlowLayout::addItem(QLayoutItem* item) {
  items_.push_back(item);
  invalidate();
}

int FlowLayout::count() const { return static_cast<int>(items_.size()); }

QLayoutItem* FlowLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
  QLayoutItem* item = itemAt(index);
  if (item) items_.erase(items_.begin() + index);
  return item;
}

int FlowLayout::heightForWidth(int width) const { return arrange(QRect(0, 0, width, 0), false); }

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const QLayoutItem* item : items_) size = size.expandedTo(item->minimumSize());
  return size;
}

// All in one line.
QSize FlowLayout::sizeHint() const {
  QSize size;
  for (const QLayoutItem* item : items_) {
    const QSize one = item->sizeHint();
    size = QSize(size.width() + one.width() + gap, std::max(size.height(), one.height()));
  }
  return size;
}

void FlowLayout::setGeometry(const QRect& area) {
  QLayout::setGeometry(area);
  arrange(area, true);
}

int FlowLayout::arrange(const QRect& area, bool move) const {
  std::vector<QLayoutItem*> seen;
  std::copy_if(items_.begin(), items_.end(), std::back_inserter(seen), [](auto* item) { return !item->isEmpty(); });
  int top = area.top();
  std::size_t first = 0;
  while (first < seen.size()) {
    int width = 0, height = 0;
    std::size_t last = first;
    for (; last < seen.size(); ++last) {
      const QSize size = seen[last]->sizeHint();
      const int with = width + (last > first ? gap : 0) + size.width();
      if (last > first && with > area.width()) break;
      width = with;
      height = std::max(height, size.height());
    }
    int left = area.left();
    for (; first < last; ++first) {
      const QSize size = seen[first]->sizeHint().boundedTo(QSize(std::max(area.width(), 1), height));
      if (move) seen[first]->setGeometry(QRect(QPoint(left, top + (height - size.height()) / 2), size));
      left += size.width() + gap;
    }
    top += height + lineGap;
  }
  return seen.empty() ? 0 : top - lineGap - area.top();
}

}  // namespace squat::studio
