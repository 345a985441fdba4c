// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <QObject>
#include <vector>

#include "core/exhibit/exhibit.h"
#include "core/message/message.h"
#include "ui/work/latest_worker.h"

namespace relievo {

/// Opens the objects of an exhibit beside the window, to know whether a visitor will find them.
/// [GUI thread]
class ObjectsCheck : public QObject {
  Q_OBJECT
 public:
  explicit ObjectsCheck(QObject* parent = nullptr);

  /// Opens those that were not opened since they last changed, and stops opening others.
  void look(const std::vector<ExhibitObject>& objects);
  /// Files are being opened.
  bool busy() const { return worker_.busy(); }
  /// Why a file cannot be opened; nothing: it can, or that is not known yet.
  std::optional<Message> refusalOf(const std::filesystem::path& file) const;

  LatestWorker& worker() { return worker_; }

 Q_SIGNALS:
  void looked();  ///< At one more file.

 private:
  struct Look {
    std::filesystem::file_time_type written;
    std::optional<Message> refusal;
  };
  void lookAtNext();

  std::vector<std::filesystem::path> files_;  ///< All that are wanted.
  std::map<std::filesystem::path, Look> known_;
  std::filesystem::path under_way_;
  LatestWorker worker_;
};

}  // namespace relievo
