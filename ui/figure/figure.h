// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/task.h"
#include "core/file/output_set.h"
#include "core/project/project.h"
#include "core/session/surface.h"
#include "ui/vtk/offscreen.h"

namespace relievo {

/// What a figure is and how it came out; for reports and for the dialog.
struct FigureFacts {
  int width_px = 0, height_px = 0;
  double width_mm = 0, height_mm = 0;  ///< Of the paper.
  double mm_per_pixel = 0;             ///< On the object, in the region's panel.
  double paper_per_mm = 0;             ///< Of the region's panel.
  double eye_angle_deg = 0;            ///< As drawn.
  double parallax_deg = 0;             ///< At reading distance; 0 without stereo.
  bool measured = false;               ///< Measurements are drawn.
  double zero_plane_mm = 0;            ///< Of zero parallax, whether or not there is any.
  /// Values at the colours' ends; nothing: stone or grey.
  std::optional<std::array<double, 2>> range;
  std::string_view range_unit;  ///< "mm", "\u00b0" or empty.
  std::string left_out;  ///< A sentence on marks without room, or empty; in the caption, too.
  std::string caption;
};

/// Text is drawn by Qt; a program without a window needs this for as long as it draws figures. Does
/// nothing where there is an application already. [main thread]
class FigureSession {
 public:
  FigureSession();
  ~FigureSession();
  FigureSession(const FigureSession&) = delete;
  FigureSession& operator=(const FigureSession&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Draws project.figure of a surface, off screen and independent of any window: the same request
/// gives the same pixels from the dialog and from the command line. [any thread that may use
/// OpenGL and shows no text: Qt 5's FreeType engine leaves the subpixel place of the last letter it
/// drew on screen in the font's face, one for each thread, and outlines taken afterwards lie up to
/// 3/8192 of the text's size beside theirs]
/// @param surface  the one that project.options make
/// @throw ArgumentError, FileError (recording), GraphicsError, Cancelled
struct Figure {
  RgbaImage image;
  FigureFacts facts;
};
Figure drawFigure(const Surface& surface, const Project& project, const Task& task = {});
/// A smaller picture of exactly what drawFigure would draw, at most `longest_px` long. Its facts
/// are those of the figure that drawFigure would give.
Figure previewFigure(const Surface& surface, const Project& project, int longest_px,
                     const Task& task = {});

/// Draws and writes by the name's ending: .png, .tif or .tiff (pixels); .pdf, .svg (text and plots
/// as vectors around the pictures). All carry the caption and the project, from which the state
/// comes back (core/provenance/embedded.h).
/// @throw as drawFigure; WriteError
FigureFacts writeFigure(const Surface& surface, const Project& project, const OutputFile& file,
                        const Task& task = {});

/// The two eyes' pictures of the region as files NAME.left.png and NAME.right.png.
struct EyeFiles {
  std::vector<std::filesystem::path> files;
  double eye_angle_deg = 0, parallax_deg = 0;  ///< As drawn.
};
EyeFiles writeEyes(const Surface& surface, const Project& project, const OutputFile& file,
                   const Task& task = {});

/// The region's heights as a 16-bit TIFF of the region's panel, outside as 0; the step in mm and
/// the height of value 1 stand in the file's description.
/// @param figure  whose heights they are; it may be written later
/// @throw WriteError, ArgumentError
void writeHeightsTiff(const Surface& surface, const Project& project, const OutputFile& file,
                      const std::filesystem::path& figure);

/// The files that one figure is written as; an empty name: not that one.
struct FigureFiles {
  std::filesystem::path figure = {};   ///< As writeFigure.
  bool both_eyes = false;              ///< As writeEyes, beside the figure and named after it.
  std::filesystem::path heights = {};  ///< As writeHeightsTiff.
  std::filesystem::path caption = {};  ///< The caption as text.
};
/// Their names, in the order in which they are written.
std::vector<std::filesystem::path> namesOf(const FigureFiles& files);
/// @throw ArgumentError  an ending that says another kind of file, or one name for two files
void check(const FigureFiles& files);

/// What was written beside how it came out.
struct FigureWritten {
  FigureFacts facts;
  std::optional<EyeFiles> eyes;
};
/// What `relievo figure` and the dialog "Figure..." write: all of it or nothing, the figure last.
/// @param set  of which the files become members; null: they take their places here
/// @param told  how many of namesOf(files) are there, once they are, on the calling thread
/// @throw as writeFigure, check(files)
FigureWritten writeFigureFiles(const Surface& surface, const Project& project,
                               const FigureFiles& files, const Task& task = {},
                               const std::function<void(std::size_t)>& told = {},
                               OutputSet* set = nullptr);

}  // namespace relievo
