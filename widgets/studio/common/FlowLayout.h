// widgets/studio/common/FlowLayout.h - a row of controls that goes on in the next line where the window is narrow.
#pragma once

#include <QLayout>
#include <vector>

namespace squat::studio {

// Owns its items. As narrow as its widest item; its height follows from its width. A line is as high as its highest
// item, on whose middle the others stand.
class FlowLayout : public QLayout {
  Q_OBJECT
 public:
  explicit FlowLayout(QWidget* parent = nullptr);
  ~FlowLayout() override;

  // Keeps these side by side: a control and the words before it.
  void addTogether(const std::vector<QWidget*>& widgets);

  void addItem(QLayoutItem* item) override;
  int count() const override;
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize minimumSize() const override;
  QSize sizeHint() const override;
  void setGeometry(const QRect& area) override;

 private:
  int arrange(const QRect& area, bool move) const;  // height that is needed
  std::vector<QLayoutItem*> items_;
};

}  // namespace squat::studio
