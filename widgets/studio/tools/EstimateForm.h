// widgets/studio/tools/EstimateForm.h - options of an estimate: which measured passages, and on which mesh.
#pragma once

#include "studio/tools/ToolForm.h"

class QComboBox;
class QDoubleSpinBox;

namespace squat::studio {

class RunStore;
class TargetList;

class EstimateForm : public ToolForm {
  Q_OBJECT
 public:
  explicit EstimateForm(const RunStore& store, QWidget* parent = nullptr);

  QString name() const override { return QStringLiteral("estimate"); }
  QString title() const override { return tr("Profile from measured passages"); }
  QString shortTitle() const override { return tr("Estimate"); }
  QString explanation() const override;
  QString subject() const override { return tr("The estimate"); }
  QString fate() const override { return tr("The best profile so far is kept."); }
  QString missing() const override;
  ToolWork work() override;
  void save(QSettings& settings) const override;
  void restore(const QSettings& settings) override;
  TargetList* passages() const { return passages_; }

 private:
  TargetList* passages_;
  QComboBox* mesh_;
  QDoubleSpinBox* longest_;
};

}  // namespace squat::studio
