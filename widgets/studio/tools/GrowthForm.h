// widgets/studio/tools/GrowthForm.h - the open case's defect under traffic.
#pragma once

#include "studio/tools/ToolForm.h"

class QCheckBox;
class QComboBox;

namespace squat::studio {

class GrowthFilm;
class NumberBox;

class GrowthForm : public ToolForm {
  Q_OBJECT
 public:
  explicit GrowthForm(const plots::Style& style, QWidget* parent = nullptr);

  QString name() const override { return QStringLiteral("growth"); }
  QString title() const override { return tr("Growth under traffic"); }
  QString shortTitle() const override { return tr("Growth"); }
  QString explanation() const override;
  QString subject() const override { return tr("The growth"); }
  ToolWork work() override;
  QWidget* view() const override;
  QString viewTitle() const override { return tr("Film"); }
  void setStyle(const plots::Style& style) override;
  void save(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

 private:
  NumberBox* box(const QString& name, const QString& label, double low, double high, double value,
                 const QString& suffix);

  NumberBox *tonnage_, *until_, *depth_, *after_;
  QComboBox *steel_, *mesh_;
  QCheckBox *stops_, *grinds_;
  GrowthFilm* film_;
};

}  // namespace squat::studio
