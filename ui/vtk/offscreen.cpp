// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/offscreen.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>

#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "core/base/failure.h"
#include "core/relief/stereo.h"
#include "ui/vtk/gl_session.h"

namespace relievo {
namespace {

constexpr int kSamples = 8;

constexpr double kMostPixels = 1U << 29U;

/// Reads the window into its place in a picture. @return false: the driver drew nothing
bool readTile(vtkRenderWindow* window, const PictureTile& tile, bool opaque, RgbaImage& image) {
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, tile.width - 1, tile.height - 1, 0, pixels);
  const auto count = static_cast<vtkIdType>(tile.width) * tile.height;
  if (pixels->GetNumberOfTuples() != count) return false;
  const unsigned char* in = pixels->GetPointer(0);
  const bool drawn = anythingDrawn({in, 4 * static_cast<std::size_t>(count)});
  for (int row = 0; row < tile.height; ++row) {
    const auto from_top = static_cast<std::size_t>(image.height - 1 - tile.y - row);
    std::uint8_t* out = image.rgba.data() + 4 * (from_top * static_cast<std::size_t>(image.width) +
                                                 static_cast<std::size_t>(tile.x));
    for (int col = 0; col < tile.width; ++col, in += 4) {
      *out++ = in[0];
      *out++ = in[1];
      *out++ = in[2];
      *out++ = opaque ? 255 : in[3];
    }
  }
  return drawn;
}

/// Without it the driver fails to load or crashes, and says something else or nothing. Measured:
/// 280 MB are enough for a small relief; with a million samples it crashes below 450 MB.
constexpr std::size_t kDriverBytes = 512U << 20U;

/// @throw GraphicsError  a limit leaves the driver no room; asked before it is loaded
void requireRoomForDriver() {
  static std::atomic<bool> had_room = false;  // From then on the driver is there.
  if (had_room) return;
  void* const room =
      mmap(nullptr, kDriverBytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) {
    throw failure<MessageId::no_memory_to_draw>();
  }
  munmap(room, kDriverBytes);
  had_room = true;
}

}  // namespace

OffscreenWindow::OffscreenWindow() {
  requireRoomForDriver();
  if (!connection_.isOpen()) {
    throw failure<MessageId::no_display>();
  }
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(0);
  window_->SetSize(16, 16);
}

int OffscreenWindow::sizeLimitPx() {
  window_->Start();  // Makes the context.
  window_->MakeCurrent();
  std::array<GLint, 2> viewport{};
  GLint texture = 0, buffer = 0;
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
  return std::min({viewport[0], viewport[1], texture, buffer});
}

RgbaImage renderPicture(const ReliefScene& scene, const PictureOptions& options, const Task& task) {
  const int width = options.width, height = options.height;
  if (width < 1 || height < 1) throw failure<MessageId::picture_without_size>();
  if (static_cast<double>(width) * height > kMostPixels) {
    throw failure<MessageId::picture_too_large>(width, height, static_cast<int>(kMostPixels / 1e6));
  }
  OffscreenWindow window;
  const int side = std::min(options.tile_px, window.sizeLimitPx());
  const std::unique_ptr<ReliefScene> copy = scene.copy();
  task.check();
  copy->setTransparent(options.transparent);
  if (options.transparent) window.get()->SetAlphaBitPlanes(1);
  // Then every pixel of an opaque picture has an alpha, whatever its colour, unless drawing failed.
  copy->renderer()->SetBackgroundAlpha(options.transparent ? 0 : 1);
  copy->stopBy(task.stop);
  copy->attachTo(window.get(), kSamples);
  RgbaImage image{width, height,
                  std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) *
                                            static_cast<std::size_t>(height))};
  bool drawn = false;
  for (int y = 0; y < height; y += side) {
    for (int x = 0; x < width; x += side) {
      task.check();
      task.report("Picture", static_cast<double>(y) / height);
      const PictureTile tile{x, y, std::min(side, width - x), std::min(side, height - y)};
      window.get()->SetSize(tile.width, tile.height);
      copy->prepare(width, height, tile);
      window.get()->Render();
      task.check();  // Else it may be cut.
      const bool tile_drawn = readTile(window.get(), tile, !options.transparent, image);
      drawn = drawn || tile_drawn;
      if (!tile_drawn && !options.transparent) drawn = false, y = height, x = width;
    }
  }
  if (!drawn && !(options.transparent && scene.isEmpty())) {
    throw failure<MessageId::black_picture_of>(width, height);
  }
  return image;
}

std::vector<std::uint8_t> storedBytes(const RgbaImage& image) {
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque = opaque && image.rgba[i] == 255;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(opaque ? image.rgba.size() / 4 * 3 : image.rgba.size());
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    const int alpha = image.rgba[i + 3];
    for (std::size_t k = 0; k < 3; ++k) {
      const int value = alpha == 0 ? 0 : (image.rgba[i + k] * 255 + alpha / 2) / alpha;
      bytes.push_back(static_cast<std::uint8_t>(std::min(value, 255)));
    }
    if (!opaque) bytes.push_back(static_cast<std::uint8_t>(alpha));
  }
  return bytes;
}

namespace {

/// Each eye's picture by itself, mixed as on paper.
RgbaImage renderBothEyes(const ReliefScene& scene, const PictureOptions& size, const Task& task) {
  const StereoOptions stereo = scene.stereo();
  const std::unique_ptr<ReliefScene> eye = scene.copy();
  StereoOptions one_eye = stereo;
  one_eye.mode = StereoMode::off;
  eye->setColourless(stereo.mode == StereoMode::anaglyph);  // As in the mixed picture.
  eye->setStereo(one_eye);
  const double half_deg = (stereo.swap_eyes ? -0.5 : 0.5) * stereo.eye_angle_deg;
  eye->setEyeTurn(-half_deg);
  RgbaImage left = renderPicture(*eye, size, task);
  eye->setEyeTurn(half_deg);
  joinEyes(printed(stereo.mode), left.rgba, renderPicture(*eye, size, task).rgba,
           {.width = left.width, .height = left.height});
  return left;
}

}  // namespace

RgbImage renderOffscreen(const ReliefScene& scene, int width, int height, const Task& task) {
  const PictureOptions size{.width = width, .height = height};
  const RgbaImage picture = scene.stereo().mode == StereoMode::off
                                ? renderPicture(scene, size, task)
                                : renderBothEyes(scene, size, task);
  RgbImage image{width, height, {}};
  image.rgb.reserve(picture.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    image.rgb.insert(image.rgb.end(), {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
  }
  return image;
}

bool anythingDrawn(std::span<const std::uint8_t> rgba) {
  return std::any_of(rgba.begin(), rgba.end(), [](std::uint8_t v) { return v != 0; });
}

}  // namespace relievo
