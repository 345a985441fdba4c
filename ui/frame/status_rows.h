// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QLayout>
#include <vector>

namespace relievo {

/// Places fields at the right of one row, or of as many rows as they need; what stretches (progress
/// and message) has the rest of the first row. The last row is filled first.
class StatusRows : public QLayout {
 public:
  explicit StatusRows(QWidget* parent);
  ~StatusRows() override;

  /// The widgets added so far, and none after, share the rest of the first row.
  void endOfFront() { front_ = items_.size(); }
  /// The widget added last is shown where the first row has room to spare: it takes no row, and
  /// little of the message; without room it is hidden.
  void lastIsSpare() { spare_ = items_.size() - 1; }
  /// Is there something in it to show?
  void setSpareWanted(bool wanted);

  void addItem(QLayoutItem* item) override;
  int count() const override;
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  QSize minimumSize() const override;
  QSize sizeHint() const override;
  Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
  void setGeometry(const QRect& rect) override;

 private:
  /// Indices of visible fields, first row first; the front is in none.
  std::vector<std::vector<std::size_t>> rows(int width) const;
  int rowHeight() const;
  int height() const { return shown_rows_ * rowHeight(); }
  int leastFront() const;  ///< Width, pixels.
  int placeSpare(int room, const QRect& before);

  std::vector<QLayoutItem*> items_;
  std::size_t front_ = 0;
  std::optional<std::size_t> spare_;
  bool spare_wanted_ = false;
  int shown_rows_ = 1;  ///< At the last width; a status bar asks for no height for a width.
};

}  // namespace relievo
