#include "studio/tools/ToolWindow.h"

#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QResizeEvent>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QShortcut>
#include <QTabWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <map>
#include <utility>

#include "case/CaseFile.h"
#include "core/Errors.h"
#include "studio/common/ErrorText.h"
#include "studio/common/FigureSizeDialog.h"
#include "studio/common/MessageBar.h"
#include "studio/common/PaneKeys.h"
#include "studio/common/WaitForSignal.h"
#include "studio/common/WorkFolder.h"
#include "studio/document/CaseDocument.h"
#include "studio/runs/ProgressText.h"
#include "studio/signals/FigureView.h"

namespace squat::studio {
namespace {

constexpr QSize sizeWithoutView(900, 720), sizeWithView(1180, 880);

QString groupOf(const ToolForm& form) { return "tools/" + form.name(); }

QPlainTextEdit* makeText(const QString& name, QWidget* parent) {
  auto* text = new QPlainTextEdit(parent);
  text->setReadOnly(true);
  text->setAccessibleName(name);
  text->setLineWrapMode(QPlainTextEdit::NoWrap);
  text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  return text;
}

// Options of the command by the names that they have here.
std::exception_ptr inWordsOfTheWindow(const std::exception_ptr& error) {
  static const std::map<std::string, std::string> names{{"-o", "folder"},
                                                        {"--vary", "values"},
                                                        {"--sample", "points"},
                                                        {"--free", "unknown keys"},
                                                        {"--speed", "speed"},
                                                        {"--chainage", "begins at"},
                                                        {"axle", "axle boxes"},
                                                        {"--resume", "folder"},
                                                        {"--uncertain", "uncertain keys"},
                                                        {"--growths", "number of growths"},
                                                        {"--grind", "grinding"},
                                                        {"--tonnage", "traffic"}};
  try {
    std::rethrow_exception(error);
  } catch (const CaseError& wrong) {
    auto problems = wrong.problems();
    for (auto& problem : problems)
      if (const auto found = names.find(problem.key); found != names.end()) problem.key = found->second;
    return std::make_exception_ptr(CaseError(problems));
  } catch (...) {
    return error;
  }
}

// The panels of a sheet, each at least as large as on paper; the page scrolls where they are more than the window.
QWidget* pageOf(plots::FigureSheet sheet, MessageBar& messages, QWidget* parent) {
  auto* scroll = new QScrollArea(parent);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* inside = new QWidget(scroll);
  auto* grid = new QGridLayout(inside);
  int place = 0;
  for (auto& panel : sheet.panels) {
    auto* view = new FigureView(QString::fromStdString(sheet.name), inside);
    view->setMinimumSize((QSizeF(panel->printedUnits()) * panel->style().fontScale).toSize());
    view->show(std::move(panel), 0, {});
    QObject::connect(view, &FigureView::failed, &messages,
                     [&messages](const QString& problem) { messages.warn(problem); });
    grid->addWidget(view, place / sheet.columns, place % sheet.columns);
    ++place;
  }
  scroll->setWidget(inside);
  return scroll;
}

}  // namespace

ToolWindow::ToolWindow(CaseDocument& document, ToolForm* form, Blocker blocker, const plots::Style& style,
                       QWidget* parent)
    : QWidget(parent, Qt::Window),
      document_(document),
      form_(form),
      blocker_(std::move(blocker)),
      style_(style),
      messages_(new MessageBar(this)),
      head_(new QHBoxLayout),
      state_(new QLabel(this)),
      case_(new QLabel(this)),
      folder_(new QLineEdit(this)),
      start_(new QPushButton(tr("&Start"), this)),
      cancel_(new QPushButton(tr("&Cancel"), this)),
      openCase_(new QPushButton(tr("&Open the case found"), this)),
      openFolder_(new QPushButton(tr("Show in &folder"), this)),
      progress_(new QProgressBar(this)),
      tabs_(new QTabWidget(this)),
      text_(makeText(tr("Result"), tabs_)),
      log_(makeText(tr("Log"), tabs_)) {
  setObjectName(form_->name() + "Window");
  setWindowTitle(tr("%1 - Squat Studio").arg(form_->title()));
  form_->setParent(this);
  makeOptions();
  QSettings settings;
  settings.beginGroup(groupOf(*form_));
  form_->restore(settings);
  resize(usualSize());
  connect(&document_, &CaseDocument::changed, this, &ToolWindow::showCase);
  connect(&document_, &CaseDocument::titleChanged, this, &ToolWindow::showCase);
  connect(form_, &ToolForm::edited, this, &ToolWindow::showNextStep);
  connect(form_, &ToolForm::edited, this, [this] {
    if (!refusal_.isEmpty() && messages_->text() == refusal_) messages_->clear();
  });
  connect(form_, &ToolForm::noted, this, [this](const QString& note) {
    refusal_ = note;
    messages_->say(note);
  });
  connect(form_, &ToolForm::runRequested, this, &ToolWindow::runRequested);
  connect(form_, &ToolForm::failed, messages_, [this](const QString& problem) { messages_->warn(problem); });
  connect(&job_, &BackgroundJob::started, this, &ToolWindow::showState);
  connect(&job_, &BackgroundJob::stopping, this, &ToolWindow::showState);
  connect(&job_, &BackgroundJob::news, this, &ToolWindow::showNews);
  connect(&job_, &BackgroundJob::ended, this, &ToolWindow::conclude);
  connect(new QShortcut(QKeySequence::Close, this), &QShortcut::activated, this, &QWidget::close);
  connect(new QShortcut(QKeySequence::HelpContents, this), &QShortcut::activated, this, &ToolWindow::helpRequested);
  addPaneKeys(*this, [this] { return std::vector<QWidget*>{form_, tabs_}; });
  showCase();
  showState();
  showNextStep();
}

ToolWindow::~ToolWindow() { saveOptions(); }

void ToolWindow::makeOptions() {
  auto* words = new QLabel(form_->explanation(), this);
  words->setWordWrap(true);
  folder_->setObjectName("toolFolder");
  folder_->setAccessibleName(tr("Folder of the files that are written"));
  connect(folder_, &QLineEdit::textEdited, this, [this] {
    ownFolder_ = true;
    Q_EMIT form_->edited();
  });
  auto* browse = new QPushButton(tr("&Browse…"), this);
  browse->setObjectName("toolBrowse");
  connect(browse, &QPushButton::clicked, this, &ToolWindow::askForFolder);
  auto* where = new QHBoxLayout;
  auto* label = new QLabel(tr("Fol&der:"), this);
  label->setBuddy(folder_);
  where->addWidget(case_);
  where->addSpacing(12);
  where->addWidget(label);
  where->addWidget(folder_, 1);
  where->addWidget(browse);
  makeResults();
  head_->addWidget(words, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(9, 4, 9, 4);
  layout->addLayout(head_);
  layout->addWidget(form_);
  layout->addLayout(where);
  layout->addWidget(makeBar());
  layout->addWidget(tabs_, 1);
  layout->addWidget(messages_);
}

QWidget* ToolWindow::makeBar() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  start_->setObjectName("toolStart");
  cancel_->setObjectName("toolCancel");
  openCase_->setObjectName("toolOpenCase");
  openFolder_->setObjectName("toolOpenFolder");
  QSizePolicy keepsPlace = openCase_->sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true);
  openCase_->setSizePolicy(keepsPlace);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress"));
  state_->setFixedWidth(state_->fontMetrics().horizontalAdvance(QString(34, 'x')));
  row->addWidget(start_);
  row->addWidget(cancel_);
  row->addWidget(progress_, 1);
  row->addWidget(state_);
  row->addWidget(openCase_);
  row->addWidget(openFolder_);
  connect(start_, &QPushButton::clicked, this, &ToolWindow::start);
  connect(cancel_, &QPushButton::clicked, this, &ToolWindow::cancel);
  connect(openCase_, &QPushButton::clicked, this,
          [this] { Q_EMIT openCaseRequested(QString::fromStdString(result_->foundCase)); });
  connect(openFolder_, &QPushButton::clicked, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(writtenTo_)); });
  return bar;
}

void ToolWindow::makeResults() {
  tabs_->setDocumentMode(true);
  tabs_->setAccessibleName(tr("What came out"));
  if (form_->view()) tabs_->addTab(form_->view(), form_->viewTitle());
  tabs_->addTab(text_, tr("Result"));
  tabs_->addTab(log_, tr("Log"));
  text_->setObjectName("toolText");
  log_->setObjectName("toolLog");
  ownTabs_ = tabs_->count();
}

QString ToolWindow::usualFolder() const {
  return workFolder(project_, document_.path()).filePath(document_.name() + "-" + form_->name());
}

void ToolWindow::setProject(const QString& path) {
  project_ = path;
  showCase();
}

void ToolWindow::showCase() {
  form_->showCase(document_.description());
  constexpr int letters = 30;  // of a name that leaves room for the folder
  const int room = case_->fontMetrics().horizontalAdvance(QString(letters, 'x'));
  case_->setText(tr("Case: %1").arg(case_->fontMetrics().elidedText(document_.name(), Qt::ElideMiddle, room)));
  case_->setToolTip(document_.name());
  if (!ownFolder_ && !isBusy()) folder_->setText(usualFolder());
}

void ToolWindow::setFolder(const QString& folder) {
  ownFolder_ = true;
  folder_->setText(folder);
}

// While nothing has come out: what is missing first.
void ToolWindow::showNextStep() {
  const QString missing = form_->missing();
  const QString start = tr("Press Start. What comes out is shown here and written into the folder.");
  text_->setPlaceholderText(missing.isEmpty() ? start : missing + '\n' + start);
}

void ToolWindow::askForFolder() {
  const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder of the files"), folder_->text());
  if (!chosen.isEmpty()) setFolder(chosen);
}

void ToolWindow::start() {
  if (isBusy()) return;
  messages_->clear();
  if (const QString reason = blocker_(); !reason.isEmpty() && form_->usesCase())
    return refuse(tr("Cannot start: %1").arg(reason));
  if (const QString missing = form_->missing(); !missing.isEmpty()) return refuse(missing);
  const QString named = folder_->text().trimmed();
  if (named.isEmpty() || !QDir::isAbsolutePath(named)) return refuse(tr("Enter the full path of the output folder."));
  const QString folder = QDir::cleanPath(named);
  writtenTo_ = folder;
  result_ = nullptr;
  text_->clear(), log_->clear();
  showFigures();
  ToolInput input{document_.name().toStdString(), document_.description(), folder.toStdString(), {}};
  if (const auto path = document_.path().toStdString(); !path.empty())
    input.files = cases::filesOfCase(path, document_.description());
  const auto made = std::make_shared<ToolResult>();
  result_ = made;
  if (form_->view()) tabs_->setCurrentWidget(form_->view());
  job_.start([work = form_->work(), input, made](WorkerMonitor& monitor) {
    ToolInput own = input;
    own.show = [&monitor](const std::function<void()>& soFar) { monitor.show(soFar); };
    *made = work(own, monitor);
  });
}

// Shown until an option changes.
void ToolWindow::refuse(const QString& reason, const QString& details) {
  refusal_ = reason;
  messages_->warn(reason, details);
}

bool ToolWindow::waitFor(int milliseconds) {
  if (isBusy()) waitForSignal(this, &ToolWindow::ended, milliseconds);
  return !isBusy();
}

void ToolWindow::cancel() { job_.cancel(); }

QString ToolWindow::text() const { return text_->toPlainText(); }

void ToolWindow::showState() {
  const bool running = job_.isRunning();
  start_->setEnabled(!isBusy());
  form_->setEnabled(!isBusy());
  folder_->setEnabled(!isBusy());
  cancel_->setEnabled(running && !job_.isStopping());
  openCase_->setVisible(!isBusy() && result_ && !result_->foundCase.empty());
  openFolder_->setEnabled(!isBusy() && !writtenTo_.isEmpty() && QDir(writtenTo_).exists());
  if (!running) progress_->setValue(0);
  if (job_.isStopping())
    state_->setText(tr("Stopping…"));
  else if (!toWrite_.empty())
    state_->setText(tr("Drawing figures…"));
  else if (!running)
    state_->setText(tr("Ready"));
  progressText_ = isBusy() ? state_->text() : QString();
  Q_EMIT progressed();
}

void ToolWindow::showNews(const WorkerMonitor::News& news) {
  const Progress& now = news.progress;
  progress_->setValue(static_cast<int>(1000 * now.fraction));
  if (!job_.isStopping() && !now.phase.empty()) {
    const QString text = progressText(now);
    state_->setText(state_->fontMetrics().elidedText(text, Qt::ElideMiddle, state_->width()));
    state_->setToolTip(text);
    progressText_ = text;
    Q_EMIT progressed();
  }
  for (const QString& line : news.messages) log_->appendPlainText(line);
  try {
    if (news.show) news.show();
  } catch (const std::exception& failure) {  // a look that cannot be drawn costs itself alone
    messages_->warn(QString::fromStdString(failure.what()));
  }
}

void ToolWindow::conclude(const std::exception_ptr& error) {
  if (error) {
    result_ = nullptr;
    const ErrorText text = errorText(inWordsOfTheWindow(error), form_->subject());
    if (text.problems.empty())
      messages_->warn(text.sentence, text.details);
    else
      refuse(tr("%1 cannot be computed: %2").arg(form_->subject(), text.details.section('\n', 0, 0)), text.details);
    return finish();
  }
  text_->setPlainText(QString::fromStdString(result_->text));
  tabs_->setCurrentWidget(form_->view() ? form_->view() : text_);
  if (result_->show) result_->show();
  if (!result_->complete) {
    const QString fate = QString::fromStdString(result_->fate);
    messages_->say(tr("Cancelled. %1").arg(fate.isEmpty() ? form_->fate() : fate));
  }
  try {
    showFigures();
    if (result_->figures) toWrite_ = result_->figures(plots::lightStyle());
  } catch (const std::exception& failure) {  // figures that cannot be drawn cost themselves alone
    messages_->warn(QString::fromStdString(failure.what()));
  }
  writeNext();
}

void ToolWindow::showFigures() {
  while (tabs_->count() > ownTabs_) {
    QWidget* old = tabs_->widget(tabs_->count() - 1);
    tabs_->removeTab(tabs_->count() - 1);
    delete old;
  }
  if (!result_ || !result_->figures) return;
  const auto& shown = result_->shownFigures ? result_->shownFigures : result_->figures;
  for (auto& sheet : shown(style_)) {
    const QString title = QString::fromStdString(sheet.name);
    tabs_->addTab(pageOf(std::move(sheet), *messages_, tabs_), QString(title).replace('_', ' '));
  }
  takeFigureSize();
}

void ToolWindow::takeFigureSize() {
  const plots::PrintedSize size = storedFigureSize();
  for (FigureView* view : tabs_->findChildren<FigureView*>()) view->setPrintedSize(size);
}

// As the command writes them in the size that is chosen: light, in all formats. One sheet between events, so that the
// window answers.
void ToolWindow::writeNext() {
  if (toWrite_.empty()) return finish();
  showState();
  const plots::PrintedSize size = storedFigureSize();
  if (size.width > 0)
    for (const auto& panel : toWrite_.back().panels) panel->setPrintedSize({size.width, size.height});
  try {
    for (auto& path : plots::writeSheet(toWrite_.back(), writtenTo_.toStdString(), {}, size.resolution))
      result_->files.push_back(std::move(path));
  } catch (const std::exception& error) {
    messages_->warn(QString::fromStdString(error.what()));
    toWrite_.clear();
    return finish();
  }
  toWrite_.pop_back();
  if (toWrite_.empty()) return finish();
  QTimer::singleShot(0, this, &ToolWindow::writeNext);
}

void ToolWindow::finish() {
  form_->conclude();
  showCase();
  showState();
  if (result_ && result_->complete) {
    if (messages_->isEmpty()) messages_->say(tr("%1 files written to %2.").arg(result_->files.size()).arg(writtenTo_));
    if (!result_->foundCase.empty()) Q_EMIT caseFound(QString::fromStdString(result_->foundCase));
  }
  if (result_ && !result_->results.empty()) Q_EMIT resultsKept(result_->results);
  Q_EMIT ended();
}

void ToolWindow::setStyle(const plots::Style& style) {
  style_ = style;
  form_->setStyle(style);
  if (!isBusy() && result_ && result_->complete) showFigures();
}

void ToolWindow::setCorner(QWidget* corner) { head_->addWidget(corner, 0, Qt::AlignTop); }

QSize ToolWindow::usualSize() const {
  return (form_->view() ? sizeWithView : sizeWithoutView).boundedTo(screen()->availableSize());
}

void ToolWindow::saveOptions() const {
  QSettings settings;
  settings.beginGroup(groupOf(*form_));
  form_->save(settings);
}

// The size is chosen in the main window, perhaps since the figures were drawn.
// Words that wrap take more lines where the window is narrow; a layout's own minimum counts one.
void ToolWindow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  setMinimumHeight(layout()->totalMinimumHeightForWidth(width()));
}

void ToolWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::ActivationChange) takeFigureSize();
}

// The tab may have been behind another one when the window was activated.
void ToolWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  takeFigureSize();
}

void ToolWindow::hideEvent(QHideEvent* event) {
  saveOptions();
  QWidget::hideEvent(event);
}

}  // namespace squat::studio
