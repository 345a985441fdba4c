// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QObject>
#include <QString>
#include <QStringList>
#include <span>

class QUrl;
class QWidget;

namespace relievo {

/// The page of docs/user that is about this widget, or about the nearest around it that one is
/// about: "depth_map"; nothing where none is. [GUI thread]
QString manualTopic(const QWidget* widget);
/// A part of the window, by its class without the namespace, and the page about it.
struct ManualTopic {
  const char* part;
  const char* page;
};
std::span<const ManualTopic> manualTopics();

/// Where the pages may lie as a site: $RELIEVO_MANUAL_PATH, installed, in a build tree.
QStringList manualFolders();
/// The page about the topic, or the site's first page where there is none about it; empty: none of
/// the folders has pages.
QString manualPage(const QString& topic, const QStringList& folders);

/// What came of opening it.
struct ManualOpening {
  bool opened = false;
  QString sentence;  ///< What happened, or what to do instead.
};
/// @param open_url  whether a browser was started; QDesktopServices::openUrl
ManualOpening openManual(const QString& topic, const QStringList& folders,
                         const std::function<bool(const QUrl&)>& open_url);

/// The key of the manual in dialogs, which the window's own keys do not reach. [GUI thread]
class ManualKey : public QObject {
 public:
  using Show = std::function<void(const QWidget* about)>;
  ManualKey(Show show, QObject* parent);
  /// Shift+F1; F1 shows the keys.
  static constexpr int kKey = static_cast<int>(Qt::SHIFT) + static_cast<int>(Qt::Key_F1);
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Show show_;
};

}  // namespace relievo
