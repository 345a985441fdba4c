// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QPen>
#include <QPointF>
#include <QStringList>
#include <QVector>

class QWidget;
class QwtPlot;
class QwtPlotCurve;
class QwtPlotItem;
class QwtPlotMarker;

namespace relievo {

/// One Qwt plot of curves over the last seconds. Its .cpp is C++17: Qwt 6.1's headers are not
/// valid C++20, and nothing newer may be seen here. [GUI thread]
class StripPlot {
 public:
  /// @param parent  owns the widget
  StripPlot(const QString& name, const QString& axis, const QStringList& curves, double seconds,
            QWidget* parent);

  QWidget* widget() const;
  /// Axes and legend in a little less than this size.
  void takeFont(const QFont& text);
  void setColours(const QColor& background, const QColor& grid, const QColor& text,
                  const QVector<QPen>& pens);
  /// Another part of time than the last seconds.
  void setTimes(double low_s, double high_s);
  /// A line across the plot at a time.
  void setCursor(double x_s);
  void setCursorColour(const QColor& colour);
  /// Something happened at these times: a small triangle at the upper edge for each.
  void setEvents(const QVector<double>& times_s);
  /// x in seconds before now, [-seconds, 0], unless setTimes() says otherwise.
  void setCurve(int index, const QVector<QPointF>& points);
  void setRange(double low, double high);
  /// As high as the curves, and at least so much: a rounding must not look like a jump.
  void setRangeFromCurves(double least);
  void replot();

 private:
  QwtPlot* plot_;
  QVector<QwtPlotCurve*> curves_;    ///< Owned by the plot.
  QwtPlotMarker* cursor_ = nullptr;  ///< Likewise; null: never set.
  QwtPlotItem* events_ = nullptr;    ///< Likewise.
};

}  // namespace relievo
