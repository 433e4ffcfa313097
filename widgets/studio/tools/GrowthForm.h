// widgets/studio/tools/GrowthForm.h - the open case's defect under traffic.
#pragma once

#include "studio/tools/ToolForm.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QSpinBox;

namespace squat::studio {

class GrowthFilm;
class KeyRows;
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
  QString missing() const override;
  void showCase(const cases::CaseDescription& description) override;
  void setStyle(const plots::Style& style) override;
  void save(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

 private:
  NumberBox* box(const QString& name, const QString& label, double low, double high, double value,
                 const QString& suffix);
  void makeForecast(QFormLayout& layout);
  void enableChosen();

  NumberBox *tonnage_, *until_, *depth_, *after_;
  QComboBox *steel_, *mesh_;
  QCheckBox *stops_, *grinds_, *forecasts_;
  KeyRows* uncertain_;
  QSpinBox* growths_;
  GrowthFilm* film_;
};

}  // namespace squat::studio
