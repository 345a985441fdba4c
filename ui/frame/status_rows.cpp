// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/status_rows.h"

#include <algorithm>
#include <QWidget>

namespace relievo {
namespace {

constexpr int kLeastCharacters = 20;  // Of a message.
constexpr int kSpareCharacters = 36;  // Of a message beside what is shown in spare room.

}  // namespace

StatusRows::StatusRows(QWidget* parent) : QLayout(parent) {
  setContentsMargins(0, 0, 0, 0);
}

StatusRows::~StatusRows() {
  for (QLayoutItem* item : items_) delete item;
}

void StatusRows::addItem(QLayoutItem* item) {
  items_.push_back(item);
}

int StatusRows::count() const {
  return static_cast<int>(items_.size());
}

QLayoutItem* StatusRows::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* StatusRows::takeAt(int index) {
  QLayoutItem* taken = itemAt(index);
  if (taken == nullptr) return nullptr;
  items_.erase(items_.begin() + index);
  if (static_cast<std::size_t>(index) < front_) --front_;
  return taken;
}

int StatusRows::rowHeight() const {
  // Hidden ones, too: were the bar to grow when work begins, both views would be drawn anew.
  int height = 0;
  for (QLayoutItem* item : items_) height = std::max(height, item->widget()->sizeHint().height());
  return height;
}

// Of the message alone: a second row must not come and go with work that is in progress.
int StatusRows::leastFront() const {
  return kLeastCharacters * parentWidget()->fontMetrics().averageCharWidth();
}

std::vector<std::vector<std::size_t>> StatusRows::rows(int width) const {
  std::vector<std::vector<std::size_t>> found(1);
  int used = 0;
  for (std::size_t i = items_.size(); i-- > front_;) {
    if (items_[i]->isEmpty() || i == spare_) continue;
    const int wanted = items_[i]->sizeHint().width();
    if (used > 0 && used + wanted > width) {
      found.insert(found.begin(), std::vector<std::size_t>());
      used = 0;
    }
    found.front().insert(found.front().begin(), i);
    used += wanted;
  }
  if (used > 0 && used + leastFront() > width) found.insert(found.begin(), {{}});
  return found;
}

QSize StatusRows::minimumSize() const {
  int width = 0;
  for (const QLayoutItem* item : items_) {
    const bool spare = spare_ && item == items_[*spare_];
    if (!item->isEmpty() && !spare) width = std::max(width, item->minimumSize().width());
  }
  return {std::min(width, leastFront()), height()};
}

QSize StatusRows::sizeHint() const {
  return {minimumSize().width(), height()};
}

void StatusRows::setSpareWanted(bool wanted) {
  spare_wanted_ = wanted;
  invalidate();
}

/// @param before  where it ends, and its height @return the width it takes
int StatusRows::placeSpare(int room, const QRect& before) {
  if (!spare_) return 0;
  QWidget* widget = items_[*spare_]->widget();
  const int wanted = widget->sizeHint().width();
  const int message = kSpareCharacters * parentWidget()->fontMetrics().averageCharWidth();
  const bool fits = spare_wanted_ && room - wanted >= message;
  if (widget->isHidden() == fits) widget->setVisible(fits);
  if (!fits) return 0;
  widget->setGeometry(before.left() - wanted, before.top(), wanted, before.height());
  return wanted;
}

void StatusRows::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  const auto shown = rows(rect.width());
  if (static_cast<int>(shown.size()) != shown_rows_) {
    shown_rows_ = static_cast<int>(shown.size());
    parentWidget()->updateGeometry();
  }
  const int height = rowHeight();
  int top = rect.top();
  bool first = true;
  for (const auto& row : shown) {
    int needed = 0;
    for (const std::size_t i : row) needed += items_[i]->sizeHint().width();
    int left = std::max(rect.left(), rect.right() + 1 - needed);
    if (first) {
      left -= placeSpare(left - rect.left(), {left, top, 0, height});
      int at = rect.left();
      for (std::size_t i = 0; i < front_; ++i) {
        if (items_[i]->isEmpty()) continue;
        const bool last = i + 1 == front_;
        const int width = last ? left - at : std::min(items_[i]->sizeHint().width(), left - at);
        items_[i]->setGeometry({at, top, std::max(0, width), height});
        at += width;
      }
      left = std::max(rect.left(), rect.right() + 1 - needed);
    }
    for (const std::size_t i : row) {
      const int width = std::min(items_[i]->sizeHint().width(), rect.right() + 1 - left);
      items_[i]->setGeometry({left, top, width, height});
      left += width;
    }
    top += height;
    first = false;
  }
}

}  // namespace relievo
