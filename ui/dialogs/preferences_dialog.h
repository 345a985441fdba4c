// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QDialog>
#include <QTimer>
#include <vector>

#include "ui/work/settings.h"

class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QStackedWidget;

namespace relievo {

/// Every setting on pages, found by words from all of them. What is changed holds at once, or says
/// that it needs a restart. [GUI thread]
class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  PreferencesDialog(Settings& settings, QWidget* parent);

 Q_SIGNALS:
  /// A setting has another value; the key is that of Settings::choice.
  void changed(const QString& key);
  void restartAsked();
  void said(const QString& text);  ///< For speech and status bar.

 private:
  struct Row {
    int page;
    QWidget *label, *field;
    QString words;  ///< What the search looks through.
  };
  struct Field {
    const char* key;
    QString title, tip;
  };
  QFormLayout* addPage(const QString& title);
  void add(const Field& about, QWidget* field);
  void addChoice(const Field& about, const QVariant& fallback,
                 const std::vector<std::pair<QString, QVariant>>& choices);
  void addNumber(const Field& about, double fallback, double low, double high, double step,
                 const QString& suffix);
  void addSwitch(const Field& about, bool fallback);
  enum class PathKind { file, folder };
  /// @param shown  what holds where nothing was chosen
  void addPath(const Field& about, PathKind kind, const QString& shown = {});
  void set(const char* key, const QVariant& value);
  void search(const QString& words);
  void resetPage();

  void makeAppearance();
  void makeUnits();
  void makeStereo();
  void makeMouse();
  void makeDevice();
  void makeDevicePlugins();
  void makeRecording();

  Settings& settings_;
  QLineEdit* words_;
  QListWidget* pages_;
  QStackedWidget* stack_;
  QLabel* nothing_;
  QTimer tells_found_;   ///< Runs while somebody types what is searched.
  QString found_words_;  ///< What it found, to be said.
  std::vector<Row> rows_;
  std::vector<std::pair<int, std::function<void()>>> resets_;  ///< Page, back to the default.
};

}  // namespace relievo
