// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/start_page.h"

#include <array>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/io/format.h"
#include "ui/style/icons.h"
#include "ui/style/palette.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr QSize kIconSize(80, 60);
constexpr int kPicturesAfterMs = 1500;  // Who opens a file at once does not need them.

QListWidget* fileList(const QString& title, QVBoxLayout* column) {
  auto* heading = new QLabel(title);
  QFont font = heading->font();
  font.setBold(true);
  heading->setFont(font);
  auto* list = new QListWidget;
  list->setAccessibleName(title);
  list->setFrameShape(QFrame::StyledPanel);
  list->setTextElideMode(Qt::ElideMiddle);
  list->setWordWrap(true);
  list->setResizeMode(QListView::Adjust);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setSpacing(2);
  list->setIconSize(kIconSize);
  heading->setBuddy(list);
  column->addWidget(heading);
  column->addWidget(list, 1);
  return list;
}

/// What a sample is, for people; other files go by their names.
QString captionOf(const QFileInfo& file) {
  struct Sample {
    const char *file, *caption;
  };
  constexpr std::array<Sample, 4> kSamples{{
      {"relief_f.ply",
       QT_TRANSLATE_NOOP("relievo::StartPage", "Acceptance relief: dome, step, ridge, grating")},
      {"coin.ply", QT_TRANSLATE_NOOP("relievo::StartPage", "Coin, 24 mm across")},
      {"panel.ply", QT_TRANSLATE_NOOP("relievo::StartPage", "Carved panel with undercuts")},
      {"ruin.ply", QT_TRANSLATE_NOOP("relievo::StartPage", "Ruin, 400 m across")},
  }};
  for (const Sample& sample : kSamples) {
    if (file.fileName() == QLatin1String(sample.file)) return StartPage::tr(sample.caption);
  }
  return shownName(file.filePath());
}

/// Its name, and below it its folder, short for home: two files may have one name.
QString nameAndFolder(const QFileInfo& file) {
  if (isAddress(file.filePath())) return shownName(file.filePath()) + '\n' + file.filePath();
  QString folder = shownPath(file.absolutePath());
  const QString home = shownPath(QDir::homePath());
  if (folder == home || folder.startsWith(home + '/')) folder.replace(0, home.size(), '~');
  return shownName(file.filePath()) + '\n' + folder;
}

/// A folder, drawn small, where there is no picture: a project, or a scan not seen before.
void setPicture(QListWidgetItem* item, const QImage& picture) {
  QPixmap shown(kIconSize);
  shown.fill(Qt::transparent);
  if (!picture.isNull()) {
    QPainter painter(&shown);
    const QImage small = picture.scaled(kIconSize, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    painter.drawImage((kIconSize.width() - small.width()) / 2,
                      (kIconSize.height() - small.height()) / 2, small);
  } else {
    QPainter painter(&shown);
    const QSize size = kIconSize / 3;
    painter.drawPixmap((kIconSize.width() - size.width()) / 2,
                       (kIconSize.height() - size.height()) / 2,
                       icon(Icon::open).pixmap(size.height(), size.height()));
  }
  item->setIcon(shown);
}

void fill(QListWidget* list, const QStringList& files, bool captions) {
  list->clear();
  for (const QString& file : files) {
    auto* item = new QListWidgetItem(
        captions ? captionOf(QFileInfo(file)) : nameAndFolder(QFileInfo(file)), list);
    item->setData(Qt::UserRole, file);
    item->setToolTip(shownAsTip(file));
    setPicture(item, ReliefPictures::kept(file));
  }
}

}  // namespace

QStringList scanPatterns() {
  QStringList patterns;
  for (const std::string_view ending : offeredEndings()) {
    patterns << QStringLiteral("*.%1").arg(
        QLatin1String(ending.data(), static_cast<int>(ending.size())));
  }
  return patterns;
}

QStringList sampleFiles() {
  const QString program = QCoreApplication::applicationDirPath();
  QStringList folders;
  const QByteArray chosen = qgetenv("RELIEVO_DATA_PATH");
  if (!chosen.isEmpty()) folders << QString::fromLocal8Bit(chosen);
  // Installed; then in a build tree, build/PRESET/bin.
  for (const char* folder : {"/../../share/relievo/data", "/../../../data/samples"}) {
    folders << program + QLatin1String(folder);
  }
  QStringList files;
  for (const QString& folder : folders) {
    // The dense reference surfaces beside the samples are for measuring, not for looking.
    const auto entries =
        QDir(folder).entryInfoList({QStringLiteral("*.ply")}, QDir::Files, QDir::Name);
    for (const QFileInfo& entry : entries) {
      if (entry.fileName().contains(QLatin1String("truncated"))) continue;
      files << entry.canonicalFilePath();
    }
  }
  files.removeDuplicates();
  return files;
}

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("start_page"));
  setAccessibleName(tr("Start"));
  auto* outer = new QHBoxLayout(this);
  auto* content = new QWidget;
  content->setMaximumWidth(static_cast<int>(1000 * textScale()));
  content->setMaximumHeight(static_cast<int>(640 * textScale()));
  outer->addStretch(1);
  outer->addWidget(content, 6);
  outer->addStretch(1);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(24, 48, 24, 32);
  column->setSpacing(14);
  addBeginning(column);
  addLists(column);
  setRecent({});
  later_.setSingleShot(true);
  later_.setInterval(kPicturesAfterMs);
  connect(&later_, &QTimer::timeout, this, [this] {
    if (isVisible()) pictures_.make(sampleFiles());
  });
  connect(&pictures_, &ReliefPictures::made, this, &StartPage::showPicture);
}

void StartPage::addBeginning(QBoxLayout* column) {
  auto* title = new QLabel(tr("Open a scan to see and touch it"));
  QFont font = title->font();
  font.setPointSizeF(font.pointSizeF() * 1.7);
  title->setFont(font);
  title->setWordWrap(true);
  column->addWidget(title);
  auto* hint = new QLabel(
      tr("Point clouds and meshes (%1), height maps (TIFF, PNG, ASCII grid), projects and figures. "
         "You can also drop a file on this window.")
          .arg(QString::fromStdString(scanFormatList())));
  hint->setWordWrap(true);
  column->addWidget(hint);
  auto* open = new QPushButton(icon(Icon::open), tr("&Open\u2026"));
  open->setObjectName(QStringLiteral("start_open"));
  open->setAccessibleName(tr("Open"));
  open->setToolTip(tr("Open a scan (Ctrl+O)"));
  open->setIconSize({20, 20});
  open->setMinimumHeight(34);
  open->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(open, &QPushButton::clicked, this, &StartPage::openAsked);
  setFocusProxy(open);
  column->addWidget(open);
  column->addSpacing(8);
}

void StartPage::addLists(QBoxLayout* column) {
  auto* lists = new QHBoxLayout;
  lists->setSpacing(20);
  auto* samples_box = new QWidget;
  auto* samples_column = new QVBoxLayout(samples_box);
  samples_column->setContentsMargins(0, 0, 0, 0);
  samples_ = fileList(tr("Samples"), samples_column);
  samples_->setObjectName(QStringLiteral("start_samples"));
  recent_box_ = new QWidget;
  auto* recent_column = new QVBoxLayout(recent_box_);
  recent_column->setContentsMargins(0, 0, 0, 0);
  recent_ = fileList(tr("Recent"), recent_column);
  recent_->setObjectName(QStringLiteral("start_recent"));
  lists->addWidget(samples_box, 1);
  lists->addWidget(recent_box_, 1);
  column->addLayout(lists, 1);

  const QStringList files = sampleFiles();
  fill(samples_, files, true);
  samples_box->setVisible(!files.isEmpty());
  for (QListWidget* list : {samples_, recent_}) {
    connect(list, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
      Q_EMIT fileChosen(item->data(Qt::UserRole).toString());
    });
    connect(list, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
      Q_EMIT fileChosen(item->data(Qt::UserRole).toString());
    });
  }
}

void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  later_.start();
}

void StartPage::showPicture(const QString& file, const QImage& picture) {
  for (QListWidget* list : {samples_, recent_}) {
    for (int i = 0; i < list->count(); ++i) {
      QListWidgetItem* item = list->item(i);
      if (item->data(Qt::UserRole).toString() == file) setPicture(item, picture);
    }
  }
}

void StartPage::setRecent(const QStringList& files) {
  fill(recent_, files, false);
  recent_box_->setVisible(!files.isEmpty());
}

}  // namespace relievo
