// SPDX-License-Identifier: BSD-3-Clause
#include "app/host.h"

#include <vector>

#include "core/region/edges.h"
#include "core/session/finer_heights.h"
#include "ui/detail_view.h"

namespace relievo {

WindowHost::WindowHost(MainWindow& window) : window_(window) {
  connect(&window_, &MainWindow::windowShown, this, &Host::windowShown);
  connect(&window_, &MainWindow::closing, this, &Host::closing);
  connect(&window_, &MainWindow::handMoved, this, [this](const ViewMm& position, bool inside) {
    Q_EMIT handMoved({position, inside});
  });
}

void WindowHost::addPanel(const QString& title, QWidget* panel) {
  window_.addPanel(title, panel);
}

void WindowHost::addAction(const QString& menu, QAction* action) {
  window_.addToMenu(menu, action);
}

void WindowHost::showProbe(const Probe& probe) {
  window_.showProbe(probe);
}

void WindowHost::plot(std::span<const PlotSample> samples) {
  std::vector<TouchPlotPoint> points;
  points.reserve(samples.size());
  for (const PlotSample& s : samples) {
    points.push_back({s.t_s, s.hip_z_mm, s.proxy_z_mm, s.force_n});
  }
  window_.plot(points);
}

void WindowHost::showStatus(const TouchStatus& status) {
  TouchReadout readout;
  readout.device = status.device;
  readout.rate_hz = status.rate_hz;
  readout.worst_period_ms = status.worst_period_ms;
  readout.late_ticks = status.late_ticks;
  readout.realtime = status.realtime;
  readout.realtime_note = status.realtime_note;
  readout.forces_on = status.forces_on;
  readout.recording = status.recording;
  readout.recorded_samples = status.recorded_samples;
  window_.showTouch(readout);
}

void WindowHost::announce(const QString& text) {
  window_.announce(text);
}

bool WindowHost::run(const QString& command) {
  return window_.runCommand(command);
}

std::shared_ptr<const RegionWindow> WindowHost::shownWindow() const {
  return window_.document().window();
}

std::vector<float> WindowHost::finerHeights(const RegionWindow& window) const {
  const auto surface = window_.document().surface();
  if (!surface) return {};
  return relievo::finerHeights(*surface, window.region, window.gain);
}

bool WindowHost::showRegion(const Region& region) {
  return window_.document().zoomTo(region);
}

std::uint8_t WindowHost::edges() const {
  const Document& document = window_.document();
  return document.isOpen() ? edgesOf(document.surface()->ladder, document.state().region)
                           : std::uint8_t{0};
}

void WindowHost::turnView(double azimuth_deg, double elevation_deg) {
  if (window_.document().isOpen()) window_.detailView().turnBy(azimuth_deg, elevation_deg);
}

QString WindowHost::recordingHeader(const QString& file) const {
  return window_.recordingHeader(file);
}

}  // namespace relievo
