// SPDX-License-Identifier: BSD-3-Clause
#include "ui/video/video_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <QRect>
#include <vector>

#include "core/base/error.h"
#include "core/relief/relief_image.h"
#include "core/session/large/tiled_surface.h"
#include "ui/figure/hand_signs.h"
#include "ui/figure/plot_strip.h"
#include "ui/video/video_surface.h"
#include "ui/vtk/ball_size.h"
#include "ui/vtk/frame_renderer.h"

namespace relievo {
namespace {

constexpr double kMargin = 0.04;       // Around the whole object, of its longer side.
constexpr double kMarkHeightPx = 720;  // Marks and lines are as thick as at this height, in ratio.

struct Box {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Where detail, overview and plots stand. Empty: not drawn.
struct Places {
  Box detail, overview, plots;
};

Places layOut(const VideoRequest& v, bool with_plots) {
  const int w = v.width_px, h = v.height_px;
  Places p;
  if (!with_plots && !v.overview) {
    p.detail = {0, 0, w, h};
  } else if (5 * w >= 7 * h) {  // Beside each other.
    p.detail = {0, 0, h, h};
    const int column = w - h;
    const int split = !v.overview ? 0 : with_plots ? h * 9 / 20 : h;
    p.overview = {h, 0, column, split};
    if (with_plots) p.plots = {h, split, column, h - split};
  } else {  // Below each other.
    const int top = std::min(w, h * 3 / 5);
    p.detail = {0, 0, w, top};
    const int split = !v.overview ? 0 : with_plots ? w * 2 / 5 : w;
    p.overview = {0, top, split, h - top};
    if (with_plots) p.plots = {split, top, w - split, h - top};
  }
  return p;
}

void paste(const RgbaImage& part, const Box& box, RgbaImage& page) {
  for (int row = 0; row < part.height; ++row) {
    const auto from = part.rgba.begin() + static_cast<std::ptrdiff_t>(4) * row * part.width;
    std::copy(
        from, from + static_cast<std::ptrdiff_t>(4) * part.width,
        page.rgba.begin() + static_cast<std::ptrdiff_t>(4) * ((box.y + row) * page.width + box.x));
  }
}

std::string words(const TouchRow& row, double t_s, int levels) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%.2f s   z %.2f mm   %.2f N   Resolution %d of %d", t_s,
                row.proxy.z, norm(row.force), row.detail, levels);
  return text.data();
}

std::vector<ForcePoint> curveOf(const TouchRecording& recording, const VideoTimes& times) {
  const double last = times.ofFrame(times.frames - 1) + 1e-9;
  std::vector<ForcePoint> rows;
  for (const TouchRow& row : recording.rows) {
    const double t = row.t_s - recording.startS();
    if (t < times.from_s - 1e-9 || t > last) continue;
    rows.push_back(forcePoint(row));
    rows.back().t_s = t;
  }
  if (rows.empty()) rows.push_back({times.from_s, 0, 0, 0});
  return rows;
}

}  // namespace

struct VideoFrames::Impl {
  const Surface& surface;
  const TouchRecording* recording;
  const VideoRequest& request;
  const Task task;
  VideoTimes times;
  Places places;
  FrameRenderer detail;
  std::optional<FrameRenderer> overview;
  std::optional<PlotStrip> plots;
  VideoSurface shown;
  std::optional<Region> overview_region;
  RgbaImage left, page, right_page, eye_page;
  bool keeps_eyes;
  std::array<RgbaImage, 2> eyes;  ///< The detail, left and right; if they are kept.
  bool legend = false;            ///< Over the detail.

  Impl(const Surface& s, const TouchRecording* r, const VideoRequest& v, const Task& t)
      : surface(s),
        recording(r),
        request(v),
        task(t),
        times(timesOf(v, r)),
        places(layOut(v, r != nullptr && v.plots)),
        detail(places.detail.width, places.detail.height),
        shown(s, v.look),
        keeps_eyes(v.eye != FigureEye::both) {
    page = {
        v.width_px, v.height_px,
        std::vector<std::uint8_t>(
            4 * static_cast<std::size_t>(v.width_px) * static_cast<std::size_t>(v.height_px), 255)};
    right_page = {page.width, page.height, {}};
    task.check();
    prepareScene(detail.scene());
    detail.scene().setScaleBar(v.scale_bar);
    if (places.overview.width > 0) startOverview();
    task.check();
    if (places.plots.width > 0) {
      plots.emplace(curveOf(*r, times), places.plots.width, places.plots.height);
    }
  }

  void prepareScene(ReliefScene& scene) const {
    scene.setBackground(1, 1, 1);
    scene.setLight(request.look.light);
    scene.setMarkScale(std::max(1.0, request.height_px / kMarkHeightPx));
    scene.setColourless(request.stereo == StereoPrint::grey);
  }

  void startOverview() {
    overview.emplace(places.overview.width, places.overview.height);
    task.check();
    prepareScene(overview->scene());
    VideoSurface whole(surface, request.look);
    const DetailLadder& map = surface.ladder;
    const double margin = kMargin * std::max(map.width_mm, map.height_mm);
    const RectMm rect{map.left_mm - margin, map.bottom_mm - margin, map.width_mm + 2 * margin,
                      map.height_mm + 2 * margin};
    whole.showPart(overview->scene(), rect, 1);
    overview->scene().setCamera({.rect = rect});
  }

  /// The window under the hand, where there is no path.
  ViewState recordedView(const TouchRow& row) const {
    ViewState view;
    view.region = wholeRegion(surface.ladder);
    const TouchedWindow* window = windowOf(*recording, row);
    if (window != nullptr && window->region.level.value < surface.ladder.levels()) {
      view.region = window->region;
      view.gain = window->gain;
    }
    return view;
  }

  void drawDetail(const ViewState& view, const std::optional<Probe>& probe) {
    ReliefScene& scene = detail.scene();
    const Region& r = view.region;
    const RectMm rect{r.x_mm, r.y_mm, r.side_mm, r.side_mm};
    if (request.path) {
      shown.showPart(scene, seenAround(rect), view.gain);
    } else {
      shown.showWindow(scene, r, view.gain);
    }
    scene.setCamera({rect, view.azimuth_deg, view.elevation_deg});
    scene.setProbe(probe, kBallOfSide * r.side_mm);
    scene.setStereo({.mode = StereoMode::off, .zero_plane_mm = shown.midHeightMm()});
    legend = probe && request.stereo == StereoPrint::grey;
    if (request.stereo == StereoPrint::off) {
      scene.setEyeTurn(0);
      paste(detail.draw(task), places.detail, page);
      if (!keeps_eyes) return;
    }
    const double red = (request.swap_eyes ? 0.5 : -0.5) * request.eye_angle_deg;
    scene.setEyeTurn(red);
    left = detail.draw(task);
    scene.setEyeTurn(-red);
    const RgbaImage& right = detail.draw(task);
    if (keeps_eyes) eyes = {left, right};
    if (request.stereo == StereoPrint::off) return;
    if (isPair(request.stereo)) {
      right_page.rgba.assign(page.rgba.begin(), page.rgba.end());
      paste(right, places.detail, right_page);
    } else {
      mixAnaglyph(request.stereo, left.rgba, right.rgba);
    }
    paste(left, places.detail, page);
  }

  const RgbaImage& ofEye(FigureEye eye) {
    eye_page.width = page.width;
    eye_page.height = page.height;
    eye_page.rgba.assign(page.rgba.begin(), page.rgba.end());
    paste(eyes.at(eye == FigureEye::left ? 0 : 1), places.detail, eye_page);
    addLegend(eye_page);
    return eye_page;
  }

  void addLegend(RgbaImage& whole) const {
    const Box& d = places.detail;
    if (legend) paintHandLegend(whole, QRect(d.x, d.y, d.width, d.height));
  }

  /// The whole page twice, what lies beside the surface in the plane of the screen.
  const RgbaImage& paired() {
    left = page;
    copyOthers(right_page);
    pairPictures(request.stereo, left.rgba, right_page.rgba,
                 {.width = page.width, .height = page.height});
    return left;
  }

  void copyOthers(RgbaImage& to) const {
    for (const Box& box : {places.overview, places.plots}) {
      for (int row = box.y; row < box.y + box.height; ++row) {
        const auto at = static_cast<std::ptrdiff_t>(4) * (row * page.width + box.x);
        std::copy_n(page.rgba.begin() + at, 4 * box.width, to.rgba.begin() + at);
      }
    }
  }

  /// What a picture of another shape than the square shows of the surface.
  RectMm seenAround(const RectMm& square) const {
    const double shorter = std::min(places.detail.width, places.detail.height);
    const double w = square.width_mm * places.detail.width / shorter;
    const double h = square.height_mm * places.detail.height / shorter;
    return {square.x_mm + 0.5 * (square.width_mm - w), square.y_mm + 0.5 * (square.height_mm - h),
            w, h};
  }

  void drawOverview(const Region& region) {
    if (!overview || overview_region == region) return;
    overview_region = region;
    overview->scene().setPinkWindow(
        RectMm{region.x_mm, region.y_mm, region.side_mm, region.side_mm}, false);
    paste(overview->draw(task), places.overview, page);
  }
};

VideoFrames::VideoFrames(const Surface& surface, const TouchRecording* recording,
                         const VideoRequest& request, const Task& task) {
  check(request);
  impl_ = std::make_unique<Impl>(surface, recording, request, task);
}

VideoFrames::~VideoFrames() = default;

void VideoFrames::keepEyes() {
  impl_->keeps_eyes = true;
}

const RgbaImage& VideoFrames::ofEye(FigureEye eye) {
  return impl_->ofEye(eye);
}

const VideoTimes& VideoFrames::times() const {
  return impl_->times;
}

const RgbaImage& VideoFrames::draw(std::uint64_t frame) {
  const double t = impl_->times.ofFrame(frame);
  const TouchRow* row = nullptr;
  std::optional<Probe> probe;
  if (impl_->recording != nullptr) {
    row = &rowAt(*impl_->recording, impl_->recording->startS() + t);
    probe = probeOf(*row, 0);
  }
  const auto& path = impl_->request.path;
  const ViewState view = path ? viewAt(*path, impl_->surface.ladder, t) : impl_->recordedView(*row);
  impl_->drawDetail(view, probe);
  impl_->drawOverview(view.region);
  if (impl_->plots) {
    paste(impl_->plots->draw(t, words(*row, t, impl_->surface.ladder.levels())),
          impl_->places.plots, impl_->page);
  }
  if (impl_->request.eye != FigureEye::both) return impl_->ofEye(impl_->request.eye);
  impl_->addLegend(impl_->page);
  return isPair(impl_->request.stereo) ? impl_->paired() : impl_->page;
}

}  // namespace relievo
