// SPDX-License-Identifier: BSD-3-Clause
#include "ui/spoken_error.h"

#include <array>
#include <QCoreApplication>
#include <QRegularExpression>

#include "core/base/error.h"

namespace relievo {
namespace {

// Sentences of core (base, io, measure, project, provenance, relief, replay, session),
// haptics/record, ui/figure, ui/vtk and ui/video with their parts as %1, %2, ...: core knows no
// languages, and its error carries the sentence alone. A sentence that was reworded there is shown
// in English until it is here; language_test provokes the errors.
constexpr std::array kSentences{
    // What is said of scans that are prepared.
    QT_TRANSLATE_NOOP("Core", "The reference."),
    QT_TRANSLATE_NOOP("Core", "As stored."),
    QT_TRANSLATE_NOOP("Core", "The pose that was found before was used."),
    QT_TRANSLATE_NOOP("Core", "%1 rms over %2 in common."),
    QT_TRANSLATE_NOOP("Core", "%1 rms over %2 in common. Weak %3: about %4."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 rms over %2 in common. Nothing in the shape holds it %3: there it lies "
                      "as it was placed by hand."),
    QT_TRANSLATE_NOOP("Core", "%1 was left out: Not aligned: %2."),
    QT_TRANSLATE_NOOP("Core", "Not aligned: %1."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: %2 picked pairs; three or more are needed. Nothing was aligned."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: the picked places lie nearly in one line, which leaves open how the "
                      "scan is turned about it. Nothing was aligned; pick one more place well "
                      "beside that line."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: the picked places are not equally far from each other on the two "
                      "scans. Nothing was aligned; look whether the pairs are in the same order "
                      "and the scans in the same unit."),
    QT_TRANSLATE_NOOP("Core", "%1 states no classes; all its points stay."),
    QT_TRANSLATE_NOOP("Core", "%1 states no pulses with several returns; all its points stay."),
    QT_TRANSLATE_NOOP("Core", "%1 states no intensities; all its points stay."),
    QT_TRANSLATE_NOOP("Core",
                      "No point is left after all steps. Nothing was written. Take a step out, or "
                      "widen its limits."),
    QT_TRANSLATE_NOOP("Core",
                      "'%1' has changed since it was read. Nothing was written. Close the dialog "
                      "and open the file again."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: there is no such file. Check the name and the folder."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: this account may not read it. Change its permissions, or copy "
        "it."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: it is a folder. Choose one of the files in it."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: it is empty (0 bytes). Copy or export it again."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: it has %2 points, none finite. Choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: its header has no end (%2). Copy or export it again."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: header promises %2 points, file ends at %3. Nothing was "
                      "loaded. Choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: header promises %2 points, file ends at %3. Nothing was "
                      "loaded. Load the %4 complete points, or choose another file."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: it is %2; this version reads %3. Convert it to one of these, "
        "or choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: the system stopped the import, probably for lack of memory. "
                      "Close other programs, or thin the scan out first."),
    QT_TRANSLATE_NOOP(
        "Core",
        "This needs about %1; %2 are free. Nothing was made. Choose cells of at least "
        "%3 (%4), or close other programs."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 has %2 cells, but the map is %3 mm: it is not a raster of the whole map, "
                      "and was not used. Cut it to the outline of the map."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 holds values outside 0 to 1, such as %2, and was not used. Scale them: 1 "
                      "where the ground is firm, 0 where it is softest."),
    QT_TRANSLATE_NOOP("Core",
                      "The output '%1' is the scan itself. Nothing was written. Choose another "
                      "name."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot write %1: %2. Check the folder, its permissions and the free space."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot write %1: what has this name is no regular file. It was left as it "
                      "is. Choose another name."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot write %1: it is read-only. It was left as it is. Choose another "
                      "name."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot write %1: its symbolic links lead in a circle. It was left as it is. "
                      "Choose another name."),
    QT_TRANSLATE_NOOP(
        "Core",
        "There is not enough memory to draw: the graphics driver needs 512 MB of "
        "address space, and a limit that was set (ulimit -v) leaves less. Nothing was "
        "drawn. Raise the limit."),
    QT_TRANSLATE_NOOP("Core",
                      "The outline crosses itself, so that it has no inside. Choose its corners in "
                      "order."),
    QT_TRANSLATE_NOOP("Core",
                      "The corners lie on one line, so that there is no area among them. Choose "
                      "others."),
    QT_TRANSLATE_NOOP("Core", "The plane does not cut the surface. Choose another plane."),
    QT_TRANSLATE_NOOP("Core", "The plane of '%1' does not cut the surface. Choose another plane."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: every height is the one that stands for none, so there is no surface. "
                      "Nothing was made. Choose another --nodata."),
    QT_TRANSLATE_NOOP("Core", "Two places, one above the other, give no plane. Choose another."),
    QT_TRANSLATE_NOOP("Core", "Three places on one line give no plane. Choose another."),
    QT_TRANSLATE_NOOP("Core",
                      "Recording stopped: disk full. %1 samples are saved and complete in \"%2\"."),
    QT_TRANSLATE_NOOP("Core",
                      "Video stopped: disk full. %1 s (%2 frames) are saved and complete in "
                      "\"%3\"."),
    QT_TRANSLATE_NOOP(
        "Core", "Cannot read %1: its points have no %2 coordinate. Export it with x, y and z."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: it holds no rows of numbers. Choose another file."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: it has 0 points. Choose another file."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: it holds 0 triangles. Choose another file."),
    QT_TRANSLATE_NOOP(
        "Core", "Cannot read %1: its header promises no vertices. Choose a file with points."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: its header names no format. Export it again."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: it is shorter than the header of a LAS file. Copy or export it again."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: it is shorter than the header of an E57 file. Copy or export it again."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: it is shorter than the header of an STL file. Copy or export it again."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: its points cannot be decoded. The file is damaged; export it again."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: it became shorter while it was read, or its disk failed. Try again."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: it was changed while it was read. Try again."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: it is a colour picture, not a height raster. Choose the "
                      "raster with one band of heights."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: its pixels are measured in degrees. Reproject it to metres, "
                      "for example %2"),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: it is not a whole zip file. Copy or download it again."),
    QT_TRANSLATE_NOOP(
        "Core", "The project %1 is damaged (line %2). Nothing was changed. Choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "The project %1 is damaged (a part is missing or has another form). Nothing "
                      "was changed. Choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "The project %1 is damaged (%2). Nothing was changed. Choose another file."),
    QT_TRANSLATE_NOOP(
        "Core",
        "The project %1 was written by another relievo (schema %2; this one reads %3). "
        "Nothing was changed. Use that version, or choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 is not a project of relievo. Nothing was changed. Choose another file."),
    QT_TRANSLATE_NOOP(
        "Core", "No cell of the grid was hit by the scan. Nothing was made. Choose another view."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot write %1 (%2). What was there is as before. Choose another folder or "
                      "free some space."),
    QT_TRANSLATE_NOOP("Core",
                      "The package %1 could not be written (%2). Nothing was left behind. Choose "
                      "another folder or free some space."),
    QT_TRANSLATE_NOOP(
        "Core",
        "A figure's name ends in .png, .tif, .pdf or .svg; '%1' does not. Nothing was drawn."),
    QT_TRANSLATE_NOOP(
        "Core", "The name of a figure's heights ends in .tif; '%1' does not. Nothing was drawn."),
    QT_TRANSLATE_NOOP("Core",
                      "Two of the figure's files would be '%1'. Nothing was drawn. Give one of "
                      "them another name."),
    QT_TRANSLATE_NOOP(
        "Core", "Cannot write the picture '%1' (%2). Choose another folder or free some space."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot write the picture '%1'. Choose another folder or free some space."),
    QT_TRANSLATE_NOOP("Core",
                      "The plane of zero parallax, %1 mm, lies far from the heights here, %2 to %3 "
                      "mm. Nothing was drawn. Choose one among them."),
    QT_TRANSLATE_NOOP("Core", "The colours' upper end must lie above their lower end."),
    QT_TRANSLATE_NOOP("Core", "The shading of a scan's own colours must lie between 0 and 1."),
    QT_TRANSLATE_NOOP("Core",
                      "The relief image 'natural' cannot be drawn: this surface has no colours. "
                      "Choose another, for example 'lit'."),
    QT_TRANSLATE_NOOP("Core",
                      "The relief image 'intensity' cannot be drawn: this surface has no "
                      "intensities. Choose another, for example 'lit'."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: it holds the colours of a map's cells, not heights. Open "
                      "the map beside it."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: it holds the intensities of a map's cells, not heights. "
                      "Open the map beside it."),
    QT_TRANSLATE_NOOP("Core", "There is nothing of the object in this region. Choose another."),
    QT_TRANSLATE_NOOP(
        "Core", "Level %1 has more than %2 samples across this region. Choose a coarser level."),
    QT_TRANSLATE_NOOP("Core",
                      "This figure would be %1 x %2 mm large. Nothing was drawn. Choose a smaller "
                      "scale or width."),
    QT_TRANSLATE_NOOP("Core",
                      "A picture of %1 x %2 pixels is more than this version can hold, %3 million "
                      "in all. Nothing was drawn. Choose a smaller one."),
    QT_TRANSLATE_NOOP("Core", "The graphics driver returned a black picture. Try a smaller one."),
    QT_TRANSLATE_NOOP(
        "Core",
        "The graphics driver cannot draw pictures of %1 x %2 pixels. Choose a smaller size."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Recording stopped: HDF5 could not write. %1 samples are saved and complete in \"%2\"."),
    QT_TRANSLATE_NOOP("Core",
                      "Recording stopped: %1. %2 samples are saved and complete in \"%3\"."),
    QT_TRANSLATE_NOOP("Core",
                      "The recording \"%1\" cannot be written: disk full. Nothing was kept. Free "
                      "some space or choose another place."),
    QT_TRANSLATE_NOOP("Core", "The recording \"%1\" cannot be written: %2. Choose another place."),
    QT_TRANSLATE_NOOP("Core", "The recording \"%1\" may be incomplete."),
    QT_TRANSLATE_NOOP("Core",
                      "The recording \"%1\" is being written by another program. Nothing was "
                      "recorded. Choose another name, or end the other one first."),
    QT_TRANSLATE_NOOP("Core",
                      "The recording is whole, but it cannot be called \"%1\": %2. It is in "
                      "\"%3\"."),
    QT_TRANSLATE_NOOP(
        "Core",
        "The folder \"%1\" for recordings cannot be made. Nothing is recorded. Choose "
        "another one."),
    QT_TRANSLATE_NOOP("Core", "The log \"%1\" cannot be read."),
    QT_TRANSLATE_NOOP("Core", "The log \"%1\" cannot be read as a log of this version."),
    QT_TRANSLATE_NOOP("Core",
                      "The log \"%1\" has other columns than this version's: it has no \"%2\"."),
    QT_TRANSLATE_NOOP("Core", "The log \"%1\" has a row that cannot be read: number %2."),
    QT_TRANSLATE_NOOP("Core",
                      "\"%1\" is no recording of relievo. Choose a .csv or .h5 file that it "
                      "recorded."),
    QT_TRANSLATE_NOOP("Core", "The log \"%1\" has no rows."),
    QT_TRANSLATE_NOOP(
        "Core", "'%1' is not there. Nothing was packed. Relink it, or take it out of the project."),
    QT_TRANSLATE_NOOP("Core",
                      "'%1' has changed since (checksum differs). Nothing was packed. Relink it, "
                      "or take it out of the project."),
    QT_TRANSLATE_NOOP("Core",
                      "'%1' is not there. Nothing was packed. It is needed to repeat '%2': put it "
                      "back, or take the recording out."),
    QT_TRANSLATE_NOOP("Core",
                      "'%1' has changed since (checksum differs). Nothing was packed. It is needed "
                      "to repeat '%2': put it back, or take the recording out."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: the picture is damaged. Nothing was restored."),
    QT_TRANSLATE_NOOP(
        "Core", "Cannot read %1: what it carries of relievo is cut off. Nothing was restored."),
    QT_TRANSLATE_NOOP(
        "Core", "The folder \"%1\" cannot be made. Nothing was written. Choose another place."),
    QT_TRANSLATE_NOOP(
        "Core",
        "The folder \"%1\" holds frames of a video already. Nothing was written. Choose another."),
    QT_TRANSLATE_NOOP("Core",
                      "There is nothing between %1 s and %2 s: the recording is %3 s long. Nothing "
                      "was made."),
    QT_TRANSLATE_NOOP(
        "Core",
        "There is nothing between %1 s and %2 s: the camera path is %3 s long. Nothing "
        "was made."),
    QT_TRANSLATE_NOOP("Core",
                      "This would be more than a million frames. Choose a part of the recording.")};

QRegularExpression formOf(const QString& sentence) {
  QString form = QRegularExpression::escape(sentence);
  for (int i = 1; i <= 4; ++i) form.replace(QStringLiteral("\\%%1").arg(i), QLatin1String("(.+)"));
  return QRegularExpression(QRegularExpression::anchoredPattern(form),
                            QRegularExpression::DotMatchesEverythingOption);
}

/// The parts in the translation's order, all at once: a part may itself contain "%1".
QString filled(const QString& sentence, const QStringList& parts) {
  QString text;
  for (int i = 0; i < sentence.size(); ++i) {
    const int number = i + 1 < sentence.size() ? sentence[i + 1].digitValue() : -1;
    if (sentence[i] == '%' && number >= 1 && number < parts.size()) {
      text += parts[number];
      ++i;
    } else {
      text += sentence[i];
    }
  }
  return text;
}

}  // namespace

QString spokenError(const QString& english) {
  for (const char* sentence : kSentences) {
    const auto match = formOf(QString::fromUtf8(sentence)).match(english);
    if (!match.hasMatch()) continue;
    return filled(QCoreApplication::translate("Core", sentence), match.capturedTexts());
  }
  return english;
}

QString spokenError(const std::exception& error) {
  return spokenError(QString::fromUtf8(error.what()));
}

QString shownError(const QString& english, const QString& code) {
  const QString text = spokenError(english);
  if (code.isEmpty() || text.contains(code)) return text;
  return QStringLiteral("%1 (%2)").arg(text, code);
}

QString shownError(const std::exception& error) {
  const auto* ours = dynamic_cast<const Error*>(&error);
  return shownError(QString::fromUtf8(error.what()),
                    ours != nullptr ? QString::fromStdString(ours->code) : QString());
}

}  // namespace relievo
