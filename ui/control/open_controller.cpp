// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/open_controller.h"

#include <algorithm>
#include <cmath>
#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

#include "core/base/error.h"
#include "core/io/input_facts.h"
#include "core/io/web/web_link.h"
#include "core/project/embedded_state.h"
#include "core/project/project_files.h"
#include "core/tiles/published/published_tiles.h"
#include "ui/control/output/package_controller.h"
#include "ui/control/output/save_controller.h"
#include "ui/frame/start_page.h"
#include "ui/language/error_text.h"
#include "ui/prepare/prepare_dialog.h"
#include "ui/work/file_names.h"
#include "ui/work/file_path.h"

namespace relievo {
namespace {

bool endsIn(const QString& file, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* ending) {
    return file.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
  });
}

/// A recording among the tables that carry a state.
bool isLog(const QString& file) {
  // Others need not be asked about; of these a broken one is shown as what its name says.
  if (endsIn(file, {".h5", ".hdf5"})) return true;
  if (!endsIn(file, {".csv"})) return false;
  try {
    return inputFacts(pathOf(file)).is_log;
  } catch (const Error&) {
    return false;  // Whoever opens it says what is wrong.
  }
}

/// Which directions of the file a view looks along, without its scale.
Rotation rotationOf(const ViewFromFile& view_from_file) {
  const auto& m = view_from_file.m;
  const double scale = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
  return {m[0] / scale, m[1] / scale, m[2] / scale, m[4] / scale, m[5] / scale,
          m[6] / scale, m[8] / scale, m[9] / scale, m[10] / scale};
}

/// Those that hold points. @throw Error  none can be read here
QStringList scansAmong(const QStringList& files) {
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files) paths.push_back(pathOf(file));
  const auto facts = inputFacts(paths);
  QStringList scans;
  for (int i = 0; i < files.size(); ++i) {
    const auto& of_file = facts[static_cast<std::size_t>(i)];
    if (of_file && of_file->kind == InputKind::scan) scans << files[i];
  }
  return scans;
}

}  // namespace

OpenController::OpenController(const ControllerParts& parts, SaveController& saving,
                               ForeignFiles& foreign, PackageController& packages)
    : Controller(parts), saving_(saving), foreign_(foreign), packages_(packages) {
  commands_.on(Command::open, this, [this] { choose(); });
  commands_.on(Command::open_folder, this, [this] { chooseFolder(); });
  commands_.on(Command::prepare, this, [this] { choosePrepare(); });
  commands_[Command::keep_view].setChecked(
      settings_.choice(QStringLiteral("keep_view"), false).toBool());
  commands_.onToggled(Command::keep_view, this, [this](bool on) {
    settings_.setChoice(QStringLiteral("keep_view"), on);
    announce(on ? tr("The next file is seen like this one.")
                : tr("The next file is seen from its own best side."));
  });
  connect(&document_, &Document::failed, this, &OpenController::showFailure);
  connect(&messages_, &WindowMessages::cancelAsked, this, &OpenController::cancel);
  connect(&packages_, &PackageController::unpacked, this,
          [this](const QString& file) { open(file); });
}

void OpenController::cancel() {
  restoring_.reset();
  document_.loader().cancel();
}

void OpenController::forgetState() {
  restoring_.reset();
  recovered_copy_.clear();
}

void OpenController::openNamed(const Project& project, const QString& from) {
  const ForeignFiles::HostFile host_file{.file = from};
  foreign_.whenTheyMayBeRead(project, host_file, [this, project, from](const auto& withheld) {
    if (!withheld.empty()) return tellInputWithheld(project, from);
    OpenRequest request;
    request.file = pathFromBytes(project.file);
    open(request);
  });
}

ForeignFiles::HostFile OpenController::hostFileOf(const QString& from) const {
  // What was kept of a crash lies among the program's own files, and names what it named before.
  if (from.isEmpty()) return {.file = recovered_copy_, .is_autosaved = true};
  return {.file = from};
}

void OpenController::restore(const Project& project, const QString& from) {
  Project found = project;
  if (isWebAddress(project.file)) {
    // Whoever wrote the state does not decide which server is asked (docs/adr/0200).
    const auto kept = keptMap(project.file);
    if (!kept) return offerAddress(project, from);
    found.file = kept->string();
  } else if (!from.isEmpty() && !QFileInfo::exists(pathFromBytes(project.file))) {
    try {  // Moved together with what carries the state, or in a package.
      found.file = foundInput(pathOf(from), project.file).string();
    } catch (const FileError&) {  // Said below.
    }
  }
  foreign_.whenTheyMayBeRead(found, hostFileOf(from), [this, found, from](const auto& withheld) {
    const std::filesystem::path input = found.file;
    if (std::find(withheld.begin(), withheld.end(), input) != withheld.end()) {
      tellInputWithheld(found, from);
      return;
    }
    foreign_.withhold(withheld);
    restoreNow(found, from);
  });
}

void OpenController::offerAddress(const Project& project, const QString& from) {
  const QString address = pathFromBytes(project.file);
  messages_.show(
      tr("%1 shows the map at %2, which was not opened on this computer yet. Nothing "
         "was changed. To open it asks that server.")
          .arg(from.isEmpty() ? tr("The work that was kept") : shownName(from), shownPath(address)),
      {{tr("&Open the map"), [this, project, from] { restoreOnChosen(project, from); }},
       {tr("&Choose another\u2026"), [this] { choose(); }}});
}

void OpenController::restoreOnChosen(const Project& project, const QString& from) {
  Project others = project;
  others.file.clear();
  foreign_.whenTheyMayBeRead(others, hostFileOf(from), [this, project, from](const auto& withheld) {
    foreign_.withhold(withheld);
    restoreNow(project, from);
  });
}

void OpenController::restoreNow(const Project& project, const QString& from) {
  OpenRequest request;
  request.file = pathFromBytes(project.file);
  request.project = project;
  request.project_file = endsIn(from, {".json"}) ? from : pathFromBytes(project.saved_as);
  if (!isAddress(request.file) && !QFileInfo::exists(request.file)) {
    messages_.show(
        tr("%1 needs %2, which has moved. Nothing was changed. Find it, or choose another "
           "file. (E501)")
            .arg(shownName(from), shownPath(request.file)),
        {{tr("&Find it\u2026"), [this, project, from] { relink(project, from); }},
         {tr("&Choose another\u2026"), [this] { choose(); }}});
    return;
  }
  open(request);
}

void OpenController::relink(const Project& project, const QString& from) {
  auto* dialog =
      new QFileDialog(&window_, tr("Find %1").arg(shownName(pathFromBytes(project.file))),
                      QFileInfo(from).absolutePath());
  dialog->setObjectName(QStringLiteral("relink_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this, project, from](const QString& file) {
    Project found = project;
    found.file = bytesOfPath(file);
    restoreOnChosen(found, from);
  });
  dialog->open();
}

bool OpenController::finish() {
  saving_.autosave().forget();
  saving_.showTitle();
  if (!restoring_) {
    foreign_.withhold({});
    return false;
  }
  const Project stored = *std::exchange(restoring_, std::nullopt)->project;
  if (!recovered_copy_.isEmpty()) {
    AutosaveController::discard(std::exchange(recovered_copy_, QString()));
    document_.saved().noteUnsaved();
    saving_.autosave().changed();
    saving_.showTitle();
  }
  if (!stored.sha256.empty() && stored.sha256 != document_.fileSha256().toStdString()) {
    tellChanged(stored);
  }
  return stored.figure.look != ReliefLook{};
}

void OpenController::tellChanged(const Project& stored) {
  messages_.show(tr("%1 has changed since this was saved (its checksum differs). It is shown as it "
                    "is now; results may differ. (E501)")
                     .arg(shownName(document_.file())),
                 {{tr("&Find it\u2026"), [this, stored] {
                     const QString& project = document_.saved().projectFile();
                     relink(stored, project.isEmpty() ? document_.file() : project);
                   }}});
}

bool OpenController::restoreFromFile(const QString& file) {
  if (isLog(file)) {
    Q_EMIT recordingChosen(file);  // It brings its state along.
    return true;
  }
  if (packages_.unpack(file)) return true;
  if (!endsIn(file, {".json", ".png", ".tif", ".tiff", ".pdf", ".svg", ".csv"})) return false;
  try {
    const auto project = embeddedProject(pathOf(file));
    if (!project) return false;  // A height map or points, then.
    restore(*project, file);
    return true;
  } catch (const Error& error) {
    if (!endsIn(file, {".json"})) return false;  // The readers say what is wrong.
    showDamaged(shownError(error));
    return true;
  }
}

// A project that cannot be read: what else there is.
void OpenController::showDamaged(const QString& text) {
  std::vector<MessageStrip::Button> buttons{{tr("&Choose another\u2026"), [this] { choose(); }}};
  if (saving_.autosave().left()) {
    buttons.push_back({tr("&Work that was kept\u2026"), [this] { offerLeftWork(); }});
  }
  messages_.show(text, buttons);
}

void OpenController::open(const QString& file, bool keeps_view) {
  saving_.whenNothingIsUnsaved([this, file, keeps_view] {
    packages_.cancelUnpacking();  // Else its project would take the place of what is opened now.
    forgetState();                // What is opened now does not hold that work.
    Q_EMIT begun();
    if (!isAddress(file) && restoreFromFile(QFileInfo(file).absoluteFilePath())) return;
    OpenRequest request;
    request.file = file;
    request.keeps_view = keeps_view || commands_[Command::keep_view].isChecked();
    open(request);
  });
}

void OpenController::open(const OpenRequest& request) {
  messages_.close();
  OpenRequest asked = request;
  if (!isAddress(asked.file)) asked.file = QFileInfo(request.file).absoluteFilePath();
  // Only a file that is opened for a state brings it back.
  if (request.project) {
    restoring_ = asked;
  } else {
    forgetState();  // What is opened now does not hold that work.
  }
  asked.remembered_unit = settings_.unitOfFolder(asked.file);
  if (!asked.remembered_unit) {
    asked.remembered_unit = lengthUnit(
        settings_.choice(QStringLiteral("unit_without"), QString()).toString().toStdString());
  }
  document_.open(asked);
}

void OpenController::showFailure(const QString& message, const QString& code, const QString& file) {
  std::vector<MessageStrip::Button> buttons;
  if (isAddress(file)) {
    OpenRequest again;
    if (restoring_) again = *restoring_;
    again.file = file;
    buttons = {{tr("&Try again"), [this, again] { open(again); }},
               {tr("Another &address\u2026"), [this, file] { Q_EMIT addressAsked(file); }}};
  }
  if (code == QLatin1String("E101") && !file.isEmpty()) {
    buttons.push_back({tr("&Load what is there"), [this, file] {
                         OpenRequest request;
                         if (restoring_ && restoring_->file == file) request = *restoring_;
                         request.file = file;
                         request.accept_incomplete = true;
                         if (request.project) request.project->accept_incomplete = true;
                         open(request);
                       }});
  }
  if (const auto every = document_.loader().offeredEvery(); every && !file.isEmpty()) {
    buttons.push_back({tr("&Load one point in %1").arg(*every), [this, file, every] {
                         OpenRequest request;
                         if (restoring_ && restoring_->file == file) request = *restoring_;
                         request.file = file;
                         request.scan.every = *every;
                         if (request.project) request.project->scan.every = *every;
                         open(request);
                       }});
  }
  if (!file.isEmpty()) buttons.push_back({tr("&Choose\u2026"), [this] { choose(); }});
  messages_.show(code.isEmpty() ? message : QStringLiteral("%1 (%2)").arg(message, code), buttons);
}

void OpenController::choose() {
  auto* dialog = new QFileDialog(&window_, tr("Open"));
  dialog->setObjectName(QStringLiteral("open_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  dialog->setNameFilters(
      {tr("Scans, height maps, projects and figures (%1)")
           .arg((scanPatterns() << QStringLiteral("*.json") << QStringLiteral("*.png")
                                << QStringLiteral("*.pdf") << QStringLiteral("*.svg")
                                << QStringLiteral("*.zip"))
                    .join(' ')),
       tr("All files (*)")});
  const QString folder = settings_.layout(QStringLiteral("folder")).toString();
  if (!folder.isEmpty()) dialog->setDirectory(folder);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    settings_.setLayout(QStringLiteral("folder"), QFileInfo(files.front()).absolutePath());
    openTogether(files);
  });
  dialog->open();
}

void OpenController::tellInputWithheld(const Project& project, const QString& host_file) {
  const std::string& kept = project.saved_as.empty() ? project.file : project.saved_as;
  messages_.show(
      tr("%1 was not opened: it needs %2, which is outside of its folder and was not read. "
         "Nothing was changed. Find it, or choose another file.")
          .arg(shownName(host_file.isEmpty() ? pathFromBytes(kept) : host_file),
               shownPath(pathFromBytes(project.file))),
      {{tr("&Find it\u2026"), [this, project, host_file] { relink(project, host_file); }},
       {tr("&Choose another\u2026"), [this] { choose(); }}});
}

void OpenController::offerLeftWork() {
  const auto left = saving_.autosave().left();
  if (!left) return;
  const Project& work = left->project;
  const QString name = shownName(pathFromBytes(work.saved_as.empty() ? work.file : work.saved_as));
  const int steps = static_cast<int>(left->project.history.size());
  messages_.show(
      tr("relievo ended unexpectedly. Work on %1 of %2 was kept (%n step(s)).", nullptr, steps)
          .arg(name, left->time),
      {{tr("&Restore"),
        [this, left] {
          recovered_copy_ = left->copy;
          restore(left->project, {});
        }},
       {tr("&Discard"), [this, left] {
          AutosaveController::discard(left->copy);
          offerLeftWork();
        }}});
}

void OpenController::chooseFolder() {
  auto* dialog = new QFileDialog(&window_, tr("Open folder"));
  dialog->setObjectName(QStringLiteral("open_folder_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly, true);
  const QString folder = settings_.layout(QStringLiteral("folder")).toString();
  if (!folder.isEmpty()) dialog->setDirectory(folder);
  connect(dialog, &QFileDialog::fileSelected, this, &OpenController::openFolder);
  dialog->open();
}

void OpenController::openFolder(const QString& folder) {
  settings_.setLayout(QStringLiteral("folder"), QFileInfo(folder).absoluteFilePath());
  QStringList files;
  for (const QFileInfo& file :
       QDir(folder).entryInfoList(scanPatterns(), QDir::Files, QDir::Name)) {
    files << file.absoluteFilePath();
  }
  try {
    files = scansAmong(files);
  } catch (const Error& error) {
    messages_.show(shownError(error));
    return;
  }
  if (files.isEmpty()) {
    messages_.show(tr("There is no scan in %1. Nothing was opened.").arg(shownPath(folder)));
    return;
  }
  openTogether(files);
}

void OpenController::openPaths(const QStringList& paths, bool keeps_view) {
  if (paths.size() == 1 && QFileInfo(paths.front()).isDir()) {
    openFolder(paths.front());
  } else if (paths.size() == 1) {
    open(paths.front(), keeps_view);
  } else {
    openTogether(paths);
  }
}

void OpenController::openTogether(const QStringList& files) {
  if (files.size() == 1) {
    open(files.front());
    return;
  }
  if (std::any_of(files.begin(), files.end(), isAddress)) {
    messages_.show(
        tr("A map is opened by its address alone, without other files. Nothing was "
           "opened."));
    return;
  }
  if (files.size() > static_cast<int>(kMostScans)) {
    messages_.show(tr("%1 files are more than the %2 scans that can be joined. Nothing was opened.")
                       .arg(files.size())
                       .arg(kMostScans));
    return;
  }
  saving_.whenNothingIsUnsaved([this, files] {
    PrepareStart start;
    for (const QString& file : files) {
      PrepareInput input;
      input.file = pathOf(QFileInfo(file).absoluteFilePath());
      input.unit = settings_.unitOfFolder(file);
      start.inputs.push_back(input);
    }
    showPrepare(start, [this](const QString& file) {
      OpenRequest request;
      request.file = file;
      restoring_.reset();
      open(request);
    });
  });
}

void OpenController::choosePrepare() {
  if (document_.loader().busy() || !document_.canRemake() || !document_.source().scan) return;
  const Project& opened = document_.project();
  PrepareInput input{
      .file = opened.file, .read = opened.scan, .accept_incomplete = opened.accept_incomplete};
  // What the window takes the coordinates for; a recipe has to say so where the file does not.
  const Surface& surface = *document_.surface();
  if (surface.unit_source != UnitSource::assumed && surface.unit_source != UnitSource::file) {
    input.unit = surface.unit;
  }
  showPrepare({.inputs = {input},
               .scan = document_.source().scan,
               .sha256 = opened.sha256,
               .view = rotationOf(surface.view_from_file)},
              [this](const QString& file) {
                OpenRequest request;
                request.file = file;
                request.step = tr("Prepare");
                // The prepared file says its unit.
                request.options = document_.project().options;
                request.options->unit.reset();
                request.options->unit_source = UnitSource::given;
                open(request);
              });
}

void OpenController::showPrepare(const PrepareStart& start,
                                 const std::function<void(const QString&)>& then) {
  auto* dialog = new PrepareDialog(start, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PrepareDialog::said, &messages_, &WindowMessages::announce);
  connect(dialog, &PrepareDialog::prepared, this, then);
  dialog->setModal(true);  // The document must not change below it.
  dialog->show();
}

}  // namespace relievo
