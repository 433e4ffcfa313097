#include "studio/runs/MeasuredDialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace squat::studio {
namespace {

QLineEdit* lineIn(QFormLayout& form, const QString& label, const QString& name, const QString& otherwise) {
  auto* line = new QLineEdit;
  line->setObjectName(name);
  line->setPlaceholderText(otherwise);
  form.addRow(label, line);
  return line;
}

// Zero stands for the value in the file.
QDoubleSpinBox* numberIn(QFormLayout& form, const QString& label, const QString& name, const QString& unit,
                         double most) {
  auto* number = new QDoubleSpinBox;
  number->setObjectName(name);
  number->setRange(0, most);
  number->setDecimals(3);
  number->setSuffix(" " + unit);
  number->setSpecialValueText(QObject::tr("from file"));
  form.addRow(label, number);
  return number;
}

}  // namespace

MeasuredDialog::MeasuredDialog(const QString& path, const QString& reason, Reading read, QWidget* parent)
    : QDialog(parent), read_(std::move(read)), reason_(new QLabel(reason)) {
  setWindowTitle(tr("Import settings for %1").arg(QFileInfo(path).fileName()));
  reason_->setObjectName("reason");
  reason_->setWordWrap(true);
  reason_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  reason_->setMinimumWidth(420);
  auto* form = new QFormLayout;
  column_ = lineIn(*form, tr("Signal &column"), "column", tr("name or number; several separated by commas; or “all”"));
  timeColumn_ = lineIn(*form, tr("&Time column"), "timeColumn", tr("detected from the header"));
  rate_ = numberIn(*form, tr("Sampling &rate"), "rate", tr("Hz"), 1e8);
  speed_ = numberIn(*form, tr("&Speed"), "speed", tr("m/s"), 1000);
  object_ = lineIn(*form, tr("&HDF5 path"), "object", tr("detected by name"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("&Overlay"));
  connect(buttons, &QDialogButtonBox::accepted, this, &MeasuredDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &MeasuredDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(reason_);
  layout->addLayout(form);
  layout->addWidget(buttons);
}

readers::SignalFileOptions MeasuredDialog::options() const {
  readers::SignalFileOptions options;
  options.column = column_->text().trimmed().toStdString();
  options.timeColumn = timeColumn_->text().trimmed().toStdString();
  options.object = object_->text().trimmed().toStdString();
  options.rate = rate_->value(), options.speed = speed_->value();
  return options;
}

void MeasuredDialog::accept() {
  const QString reason = read_(options());
  if (reason.isEmpty()) return QDialog::accept();
  reason_->setText(reason);
}

}  // namespace squat::studio
