// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <QBuffer>
#include <QFile>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <set>

#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/io/formats/text_file.h"
#include "core/project/caption.h"
#include "core/provenance/embedded.h"
#include "core/provenance/name_text.h"
#include "core/provenance/set_mark.h"
#include "ui/figure/figure.h"
#include "ui/figure/figure_layout.h"
#include "ui/figure/figure_sheet.h"
#include "ui/figure/picture_libraries.h"
#include "ui/vtk/files/picture_file.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// What all files of one figure say.
SetMark setOf(const Project& project, const fs::path& figure, const std::string& caption = {}) {
  Project shown = relativeTo(project, figure);
  shown.made.clear();
  shown.figures.clear();
  return setMark(projectJson(shown), caption);
}

/// @param mark  the figure's set, and its caption if it is the figure itself
PictureText textOf(const Surface& surface, const Project& project, const FigureFacts& facts,
                   const fs::path& file, const SetMark& mark) {
  Project state = relativeTo(project, file);
  state.made = markedMade(withLibraries(madeText(surface), pictureLibraries()), mark);
  state.figures.clear();  // What else was drawn changes no figure.
  return {{"Title", escapedName(fs::path(project.file).filename().string())},
          {"Software", std::string("relievo ") + RELIEVO_VERSION_STRING},
          {"Description", facts.caption},
          {kStateEntry, projectJson(state)}};
}

std::string lowerEnding(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

void save(const QByteArray& bytes, const OutputFile& file) {
  writeTextFile(file, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

std::string entry(const PictureText& text, std::string_view key) {
  const auto found =
      std::find_if(text.begin(), text.end(), [key](const auto& e) { return e.first == key; });
  return found == text.end() ? std::string() : found->second;
}

/// Title, caption and state as an XMP packet (ISO 16684-1), which every PDF may carry.
QByteArray xmpOf(const PictureText& text) {
  const auto words = [&](const char* key) {
    return "<rdf:Alt><rdf:li xml:lang=\"x-default\">" + markupText(entry(text, key)) +
           "</rdf:li></rdf:Alt>";
  };
  return QByteArray::fromStdString(
      "<?xpacket begin=\"\xef\xbb\xbf\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
      "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
      "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
      "<rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\""
      " xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\">\n"
      "<dc:title>" +
      words("Title") + "</dc:title>\n<dc:description>" + words("Description") +
      "</dc:description>\n<xmp:CreatorTool>" + markupText(entry(text, "Software")) +
      "</xmp:CreatorTool>\n" + stateElement(entry(text, kStateEntry)) +
      "\n</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"w\"?>\n");
}

/// Qt counts a page in whole points. The page is that large at least; its box is made exact here,
/// its upper left corner where Qt has it.
/// @param bytes  of a PDF of one page; as many afterwards, so that all its offsets stay true
void setExactPage(QByteArray& bytes, double width_pt, double height_pt, int top_pt) {
  constexpr const char* kBox = "/MediaBox [";
  const int start = bytes.indexOf(kBox) + static_cast<int>(std::strlen(kBox));
  const int room = bytes.indexOf(']', start) - start;
  const QByteArray box = "0 " + QByteArray::number(top_pt - height_pt, 'f', 3) + ' ' +
                         QByteArray::number(width_pt, 'f', 3) + ' ' + QByteArray::number(top_pt);
  if (room < 0 || box.size() > room) return;  // Not as Qt 5.15 writes it: whole points, then.
  bytes.replace(start, room, box.leftJustified(room, ' '));
}

QByteArray pdfOf(const Surface& surface, const Project& project, const DrawnSheet& sheet,
                 const PictureText& text) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(static_cast<int>(std::lround(sheet.dpi)));
  const double width_pt = sheet.facts.width_mm / kMmPerPoint;
  const double height_pt = sheet.facts.height_mm / kMmPerPoint;
  const auto whole = [](double points) { return static_cast<int>(std::ceil(points - 1e-6)); };
  writer.setPageSize(QPageSize(QSizeF(whole(width_pt), whole(height_pt)), QPageSize::Point,
                               QString(), QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF());
  writer.setTitle(QString::fromStdString(entry(text, "Title")));
  writer.setCreator(QStringLiteral("relievo " RELIEVO_VERSION_STRING));
  writer.setDocumentXmpMetadata(xmpOf(text));
  QPainter painter(&writer);
  painter.setRenderHint(QPainter::LosslessImageRendering);
  paintSheet(painter, surface, project, sheet, FigureInk::Target::vectors);
  painter.end();
  setExactPage(bytes, width_pt, height_pt, whole(height_pt));
  return bytes;
}

/// Qt counts an SVG's size in whole pixels; its millimetres are made exact here.
void setExactSize(QByteArray& bytes, double width_mm, double height_mm) {
  for (const auto& [attribute, mm] :
       {std::pair{"<svg width=\"", width_mm}, std::pair{"mm\" height=\"", height_mm}}) {
    const int found = bytes.indexOf(attribute);
    const int start = found + static_cast<int>(std::strlen(attribute));
    const int end = bytes.indexOf("mm\"", start);
    if (found < 0 || end < 0) return;  // Not as Qt 5.15 writes it: whole pixels, then.
    bytes.replace(start, end - start, QByteArray::number(mm, 'g', 9));
  }
}

QByteArray svgOf(const Surface& surface, const Project& project, const DrawnSheet& sheet,
                 const PictureText& text) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(static_cast<int>(std::lround(sheet.dpi)));
  generator.setSize({sheet.facts.width_px, sheet.facts.height_px});
  const double per_mm = sheet.dpi / 25.4;
  const QRectF page(0, 0, sheet.facts.width_mm * per_mm, sheet.facts.height_mm * per_mm);
  generator.setViewBox(page);
  // Qt writes both as they are.
  generator.setTitle(QString::fromStdString(markupText(entry(text, "Title"))));
  generator.setDescription(QString::fromStdString(markupText(entry(text, "Description"))));
  QPainter painter(&generator);
  if (!project.figure.transparent) painter.fillRect(page, Qt::white);
  paintSheet(painter, surface, project, sheet, FigureInk::Target::vectors);
  painter.end();
  setExactSize(bytes, sheet.facts.width_mm, sheet.facts.height_mm);
  // Qt has no call for metadata; they stand before what is drawn.
  const int at = bytes.indexOf("<defs>");
  return bytes.insert(
      at, QByteArray::fromStdString("<metadata>" + stateElement(entry(text, kStateEntry)) +
                                    "</metadata>\n"));
}

fs::path eyeFile(const fs::path& figure, int eye) {
  return eyeFile(figure, eye < 0 ? FigureEye::left : FigureEye::right, ".png");
}

/// In errors; a folder is named whole.
std::string named(const fs::path& file) {
  return file.has_filename() ? file.filename().string() : file.string();
}

/// The endings that writeFigure takes.
void checkFigureName(const fs::path& file) {
  const std::string ending = lowerEnding(file);
  if (pictureFormatOf(file) || ending == ".pdf" || ending == ".svg") return;
  throw failure<MessageId::figure_name>(named(file));
}

/// What the file of one eye shows: the region as that one sees it and nothing over it.
Project ofEye(const Surface& surface, const Project& project, int eye) {
  Project one = project;
  FigureRequest& f = one.figure;
  f.layout = FigureLayout::detail;
  if (f.stereo == StereoPrint::off || isAnaglyph(f.stereo)) f.stereo = StereoPrint::side_by_side;
  f.eye = eye < 0 ? FigureEye::left : FigureEye::right;
  f.look = figureLook(surface, project);
  f.scale_bar = f.height_bar = f.up_mark = f.window_outline = false;
  f.legend = f.letters = f.measurements = false;
  return one;
}

}  // namespace

FigureFacts writeFigure(const Surface& surface, const Project& project, const OutputFile& place,
                        const Task& task) {
  const fs::path& file = place.path;
  checkFigureName(file);
  if (const auto pixels = pictureFormatOf(file)) {
    const Figure figure = drawFigure(surface, project, task);
    const PictureText text =
        textOf(surface, project, figure.facts, file, setOf(project, file, figure.facts.caption));
    if (pixels == PictureFormat::png) {
      writePng(place, figure.image, project.figure.dpi, text);
    } else {
      writeTiff(place, figure.image, project.figure.dpi, text);
    }
    return figure.facts;
  }
  const bool pdf = lowerEnding(file) == ".pdf";
  Project whole = project;
  whole.figure.dpi = std::round(project.figure.dpi);  // Both writers count whole dots.
  const DrawnSheet sheet = drawPictures(surface, whole, whole.figure.dpi, task);
  const PictureText text =
      textOf(surface, whole, sheet.facts, file, setOf(project, file, sheet.facts.caption));
  save(pdf ? pdfOf(surface, whole, sheet, text) : svgOf(surface, whole, sheet, text), place);
  return sheet.facts;
}

EyeFiles writeEyes(const Surface& surface, const Project& project, const OutputFile& file,
                   const Task& task) {
  if (file.set == nullptr) {
    OutputSet set;
    EyeFiles both = writeEyes(surface, project, set.file(file.path), task);
    set.commit();
    return both;
  }
  EyeFiles eyes;
  struct Drawn {
    Figure figure;
    PictureText text;
  };
  std::vector<Drawn> drawn;
  for (const int eye : {-1, 1}) {
    const Project one = ofEye(surface, project, eye);
    Figure figure = drawFigure(surface, one, task);
    eyes.files.push_back(eyeFile(file.path, eye));
    eyes.eye_angle_deg = figure.facts.eye_angle_deg;
    eyes.parallax_deg = figure.facts.parallax_deg;
    const PictureText text =
        textOf(surface, one, figure.facts, eyes.files.back(), setOf(project, file.path));
    drawn.push_back({std::move(figure), text});
  }
  task.check();
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    writePng(file.set->file(eyes.files[i]), drawn[i].figure.image, project.figure.dpi,
             drawn[i].text);
  }
  return eyes;
}

void writeHeightsTiff(const Surface& surface, const Project& project, const OutputFile& file,
                      const fs::path& figure) {
  const FigureRequest& f = project.figure;
  check(f);
  const Region& r = project.region;
  const FigureSheet sheet = layOut(surface, project);
  const double paper_mm = r.side_mm * sheet.paper_per_mm;
  const int side = std::max(2, static_cast<int>(std::lround(paper_mm / 25.4 * f.dpi)));
  const RectMm rect{r.x_mm, r.y_mm, r.side_mm, r.side_mm};
  const DepthMap map = cutOut(surface, r.level, rect, 1, project.gain);
  std::vector<std::optional<double>> heights;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      const double x = r.x_mm + (col + 0.5) * r.side_mm / side;
      const double y = r.y_mm + r.side_mm - (row + 0.5) * r.side_mm / side;
      const auto point = surfacePoint(map, {.x = x, .y = y});
      heights.push_back(point ? std::optional(point->at.z) : std::nullopt);
      if (!point) continue;
      low = std::min(low, point->at.z);
      high = std::max(high, point->at.z);
    }
  }
  if (!(low <= high)) low = high = 0;
  constexpr double kSteps = 65534;  // Value 0 is outside.
  // Below a nanometre there is only rounding.
  const double step_mm = high - low > 1e-6 ? (high - low) / kSteps : 1;
  GreyPicture picture{side, side, {}};
  for (const auto& height : heights) {
    const double value = height ? 1 + std::round((*height - low) / step_mm) : 0;
    picture.values.push_back(static_cast<std::uint16_t>(std::min(value, kSteps + 1)));
  }
  FigureFacts facts;
  facts.paper_per_mm = sheet.paper_per_mm;
  facts.mm_per_pixel = r.side_mm / side;
  facts.caption = "Heights: value 0 is outside; value v is " + shortNumber(low, 9) +
                  " mm + (v - 1) x " + shortNumber(step_mm, 9) + " mm. " +
                  figureCaption(surface, project, facts);
  writeTiff(file, picture, f.dpi,
            textOf(surface, project, facts, file.path, setOf(project, figure)));
}

std::vector<fs::path> namesOf(const FigureFiles& files) {
  std::vector<fs::path> names{files.figure};
  if (files.both_eyes) {
    for (const int eye : {-1, 1}) names.push_back(eyeFile(files.figure, eye));
  }
  for (const fs::path& other : {files.heights, files.caption}) {
    if (!other.empty()) names.push_back(other);
  }
  return names;
}

void check(const FigureFiles& files) {
  checkFigureName(files.figure);
  if (!files.heights.empty() && pictureFormatOf(files.heights) != PictureFormat::tiff) {
    throw failure<MessageId::heights_name>(named(files.heights));
  }
  std::set<fs::path> taken;
  for (const fs::path& name : namesOf(files)) {
    requireReplaceable(name);
    if (taken.insert(fs::absolute(name).lexically_normal()).second) continue;
    throw failure<MessageId::figure_files_are_one>(name);
  }
}

FigureWritten writeFigureFiles(const Surface& surface, const Project& project,
                               const FigureFiles& files, const Task& task,
                               const std::function<void(std::size_t)>& told, OutputSet* set) {
  if (set == nullptr) {
    OutputSet own;
    FigureWritten written = writeFigureFiles(surface, project, files, task, {}, &own);
    task.check();
    own.commit();
    if (told) told(namesOf(files).size());
    return written;
  }
  check(files);
  for (const fs::path& name : namesOf(files)) {
    requireNotAnInput(name, {FileRead{.file = project.file}});
  }
  if (files.both_eyes) layOut(surface, ofEye(surface, project, -1));  // Refused before the work.
  FigureWritten written;
  // What lies beside the figure comes first: it is missed less where a program is killed.
  if (files.both_eyes) {
    written.eyes = writeEyes(surface, project, {files.figure, set}, task);
  }
  if (!files.heights.empty())
    writeHeightsTiff(surface, project, {files.heights, set}, files.figure);
  OutputSet figure;
  written.facts = writeFigure(surface, project, figure.file(files.figure), task);
  if (!files.caption.empty()) {
    writeTextFile({files.caption, set}, written.facts.caption + "\n");
  }
  set->takes(figure);
  return written;
}

}  // namespace relievo
