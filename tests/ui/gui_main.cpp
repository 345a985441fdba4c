// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <QVTKOpenGLNativeWidget.h>
#include <clocale>
#include <iostream>
#include <QSurfaceFormat>
#include <QTemporaryDir>

#include "ui/views/surface_view.h"
#include "ui/vtk/offscreen.h"
#include "ui/window/guarded_application.h"
#include "ui/work/file_names.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  relievo::keepBytesOfNames();
  const relievo::DisplayGuard display;
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  qputenv("QT_QPA_PLATFORM", "xcb");
  relievo::GuardedApplication app(argc, argv);
  // What the program would survive fails here, unless a test asks for it.
  app.tellTo([](const QString& sentence) { ADD_FAILURE() << sentence.toStdString(); });
  std::setlocale(LC_NUMERIC, "C");
  QLocale::setDefault(QLocale(QLocale::English));
  relievo::installAccessibleViews();
  return RUN_ALL_TESTS();
}
