// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>

#include "core/message/message.h"
#include "core/region/region_window.h"

namespace relievo {

class TiledMap;
class TilePrefetcher;
class WindowsAhead;

/// Windows of a map by tiles for whoever must not wait for a network, and what will be needed next
/// loaded ahead. Of a map from the web the window is at first of the finest level whose tiles are
/// here, and the wanted one follows (docs/adr/0201). [GUI thread]
class TilesAhead : public QObject {
  Q_OBJECT
 public:
  explicit TilesAhead(std::shared_ptr<const TiledMap> map);
  ~TilesAhead() override;

  /// What can be shown of a region now. @throw FileError
  static std::shared_ptr<const RegionWindow> now(const TiledMap& map, const Region& region,
                                                 double gain);
  /// This is shown now of that wish.
  void around(const Region& wanted, const RegionWindow& shown);

 Q_SIGNALS:
  /// A finer window of the last wish, or the same, whose colours have come.
  void better(const std::shared_ptr<const relievo::RegionWindow>& window);
  void said(const relievo::Message& message);  ///< As WindowsAhead says.

 private:
  void take(const std::shared_ptr<const RegionWindow>& window, bool coloured);

  std::shared_ptr<const TiledMap> map_;
  Region shown_;  ///< Its level is that of the window.
  double gain_ = 1;
  bool coloured_ = true;
  std::unique_ptr<TilePrefetcher> files_;  ///< Of a map in files.
  std::unique_ptr<WindowsAhead> web_;      ///< Of others. Last: it calls until it is gone.
};

}  // namespace relievo
