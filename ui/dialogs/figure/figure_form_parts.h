// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QString>

#include "core/project/figure_request.h"
#include "core/session/surface.h"
#include "ui/figure/figure.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace relievo {

class FigureFormRows;
class FigureNumber;

// The parts of the form of a figure. Each adds its rows, shows its part of a request, writes it
// into one, and says which of its fields are of no use and why. [GUI thread]

/// What stands beside what, and how large it is on paper.
class FigurePageRows {
 public:
  explicit FigurePageRows(FigureFormRows& rows);
  void show(const FigureRequest& request);
  void writeTo(FigureRequest& request) const;
  void limit();
  FigureLayout layout() const;
  QLineEdit* file() const { return file_; }

 private:
  QLineEdit* file_;
  QComboBox* layout_;
  QLineEdit* recording_;
  FigureNumber* width_;
  QCheckBox* to_scale_;
  FigureNumber* scale_;
  FigureNumber* dpi_;
  FigureNumber* text_;
};

/// How heights are painted.
class FigureReliefRows {
 public:
  /// @param surface  kinds of relief that it has nothing for cannot be chosen
  FigureReliefRows(FigureFormRows& rows, const Surface& surface);
  void show(const FigureRequest& request);
  void writeTo(FigureRequest& request) const;
  void limit();
  /// The ends of the colours as they are drawn, while none were chosen.
  void showAutomatic(const FigureFacts& facts);

 private:
  void addRange(FigureFormRows& rows);

  QComboBox* relief_;
  QComboBox* colours_;
  FigureNumber* azimuth_;
  FigureNumber* elevation_;
  FigureNumber* radius_;
  FigureNumber* shading_;
  QCheckBox* own_range_ = nullptr;
  FigureNumber *range_low_ = nullptr, *range_high_ = nullptr;
  int shown_relief_ = 0;  // Kind that the colours' ends are values of.
};

/// Two eyes.
class FigureStereoRows {
 public:
  explicit FigureStereoRows(FigureFormRows& rows);
  void show(const FigureRequest& request);
  void writeTo(FigureRequest& request) const;
  /// @param both_eyes  each is written as a file
  void limit(bool both_eyes);
  StereoPrint stereo() const;
  /// The height that lies in the plane of the paper, while none was chosen.
  void showAutomatic(const FigureFacts& facts);

 private:
  QComboBox* stereo_;
  FigureNumber* eye_;
  QCheckBox* comfort_;
  QCheckBox* own_zero_plane_;
  FigureNumber* zero_plane_;
  QCheckBox* swap_;
};

/// What is drawn over the relief, and what lies behind it.
class FigureMarkRows {
 public:
  explicit FigureMarkRows(FigureFormRows& rows);
  void show(const FigureRequest& request);
  void writeTo(FigureRequest& request) const;
  void limit(FigureLayout layout, StereoPrint stereo);

 private:
  std::array<QCheckBox*, 8> marks_{};
  QCheckBox* transparent_;
};

/// What is written beside the figure.
class FigureFileRows {
 public:
  explicit FigureFileRows(FigureFormRows& rows);
  void limit();
  bool bothEyes() const;
  /// @param figure  path of the figure itself
  FigureFiles files(const QString& figure) const;
  /// Beside the figure and named after it, until they are given names of their own.
  void suggestNames(const QString& file);

 private:
  QCheckBox* both_eyes_;
  QCheckBox* heights_too_;
  QLineEdit* heights_file_;
  QCheckBox* caption_too_;
  QLineEdit* caption_file_;
};

}  // namespace relievo
