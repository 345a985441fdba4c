// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "haptics/device/falcon/link/link_status.h"

namespace relievo {

/// What to do with the grip until its place is known, as a picture: the Falcon from the side, its
/// grip where it is to go, an arrow that way, and the light that it shows meanwhile. Its words are
/// for those who do not see it. [GUI thread]
class HomingPicture : public QWidget {
  Q_OBJECT
 public:
  explicit HomingPicture(QWidget* parent = nullptr);

  void show(falcon::LinkState state);
  falcon::LinkState state() const { return state_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  falcon::LinkState state_ = falcon::LinkState::absent;
};

}  // namespace relievo
