// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/question_controller.h"

#include <algorithm>
#include <cmath>
#include <QIcon>
#include <QLocale>
#include <QPainter>

#include "core/depth/rules/rasterize.h"
#include "core/message/catalogue.h"
#include "core/session/source/unit_guess.h"
#include "ui/dialogs/raster_scale_dialog.h"
#include "ui/language/unit_doubt.h"
#include "ui/message/message_text.h"
#include "ui/style/text.h"
#include "ui/work/pictures/depth_map_picture.h"

namespace relievo {
namespace {

constexpr int kFaceCells = 96;
constexpr int kFacePx = 56;

QString countText(std::uint64_t count) {
  return QLocale().toString(static_cast<qulonglong>(count));
}

/// Never "100" of what has something left.
QString shareText(double share_of_box) {
  return numberText(std::min(std::floor(1000 * share_of_box) / 10, 99.9), 1);
}

}  // namespace

QuestionController::QuestionController(const ControllerParts& parts) : Controller(parts) {
  commands_.on(Command::units, this, [this] {
    const Surface* surface = document_.surface().get();
    const bool is_placed = surface == nullptr || !surface->raster_scale ||
                           surface->raster_scale->is_placed || !document_.source().raster;
    if (is_placed) {
      askUnit();
    } else {
      chooseScale();
    }
  });
  connect(&messages_, &WindowMessages::dismissed, this, &QuestionController::askNext);
  // An answer made the surface anew; two at a time would undo each other.
  connect(&document_, &Document::surfaceChanged, this, &QuestionController::askNext,
          Qt::QueuedConnection);
}

void QuestionController::begin(bool restored, std::size_t withheld) {
  questions_.clear();
  if (restored && withheld > 0) tellWithheld(static_cast<int>(withheld));
  const Surface& surface = *document_.surface();
  if (surface.strays.points > 0 && !restored) questions_.emplace_back([this] { askStrays(); });
  if (surface.strays.grouped > 0 && !restored) questions_.emplace_back([this] { askGroups(); });
  if (surface.suspect_height) questions_.emplace_back([this] { askNodata(); });
  if (surface.raster_scale && surface.raster_scale->isOpen()) {
    questions_.emplace_back([this] { askScale(); });
  } else if (surface.unit_source == UnitSource::assumed ||
             surface.unit_source == UnitSource::guessed) {
    questions_.emplace_back([this] { askUnit(); });
  }
  const auto& view = document_.project().options.view;
  const bool automatic = !view || view->name == "auto";
  if (surface.view_is_weak && automatic && !restored) drawFaces();
  askNext();
}

void QuestionController::askNext() {
  if (questions_.empty() || document_.loader().busy() || !messages_.shown().isEmpty()) return;
  const std::function<void()> ask = questions_.front();
  questions_.erase(questions_.begin());
  ask();
}

void QuestionController::answerStrays(StrayRule rule) {
  document_.choices().setStrays(rule);
  askNext();  // If that was the answer already.
}

void QuestionController::askStrays() {
  const Strays& strays = document_.surface()->strays;
  // Vertices that no face uses have their own sentence, but for those that stay.
  const std::uint64_t unused = strays.kept ? 0 : strays.unused;
  const std::uint64_t points = strays.points - unused;
  const QString few = countText(points);
  const QString all = countText(strays.all);
  const QString share = shareText(strays.share_of_box);
  // What was said of groups stays.
  const bool without_groups = document_.project().options.strays == StrayRule::drop_groups;
  const StrayRule without = without_groups ? StrayRule::drop_groups : StrayRule::drop;
  const MessageStrip::Button keep{tr("&Keep them"), [this] { answerStrays(StrayRule::keep); }};
  const MessageStrip::Button drop{tr("&Leave them out"),
                                  [this, without] { answerStrays(without); }};
  const bool one = points == 1;
  const QString found =
      one ? tr("One of %1 points lies %2 % of the box away from all others.").arg(all, share)
          : tr("%1 of %2 points lie %3 % of the box away from all others.").arg(few, all, share);
  if (strays.kept) {
    const QString kept = tr("Kept, and so most of the map is empty.");
    messages_.show(QStringLiteral("%1 %2").arg(found, kept), {drop, keep});
    return;
  }
  QStringList left;
  if (points > 0) left << found << tr("Left out.");
  if (unused > 0) {
    left << messageText(said<MessageId::unused_vertices_left_out>(CountArgument::grouped(unused)));
  }
  messages_.show(left.join(' '), {keep, drop});
}

void QuestionController::askGroups() {
  const Strays& strays = document_.surface()->strays;
  const QString found = tr("%1 of %2 points lie together, %3 % of the box away from all others.")
                            .arg(countText(strays.grouped), countText(strays.all),
                                 shareText(strays.share_of_box_grouped));
  const StrayRule with = strays.kept ? StrayRule::keep : StrayRule::drop;
  const MessageStrip::Button keep{tr("&Keep them"), [this, with] { answerStrays(with); }};
  const MessageStrip::Button drop{tr("&Leave them out"),
                                  [this] { answerStrays(StrayRule::drop_groups); }};
  if (strays.groups_kept) {
    const QString kept = tr("Kept, as they may belong to the object.");
    messages_.show(QStringLiteral("%1 %2").arg(found, kept), {drop, keep});
  } else {
    messages_.show(QStringLiteral("%1 %2").arg(found, tr("Left out.")), {keep, drop});
  }
}

void QuestionController::askNodata() {
  const SuspectHeight suspect = *document_.surface()->suspect_height;
  const auto answer = [this](const NodataChoice& nodata) { document_.choices().setNodata(nodata); };
  messages_.show(
      tr("%1 of %2 heights are %3, which often stands for a missing one. They were left out.")
          .arg(countText(suspect.count), countText(suspect.all),
               QString::fromStdString(heightText(suspect.value))),
      {{tr("&Keep as heights"), [answer] { answer(NodataChoice{}); }},
       {tr("&Take as missing"),
        [answer, value = suspect.value] { answer(NodataChoice{.value = value}); }}});
}

void QuestionController::drawFaces() {
  const std::shared_ptr<const Scan> scan = document_.source().scan;
  const std::shared_ptr<const Surface> shown = document_.surface();
  if (!scan) return;
  using Faces = std::vector<std::pair<std::string, QImage>>;
  const auto faces = std::make_shared<Faces>();
  SurfaceOptions options = document_.project().options;
  options.cells = kFaceCells;
  options.spacing_mm.reset();
  options.engine = "cpu";
  face_worker_.start(
      [scan, options, faces](const Task& task) mutable {
        for (const std::string_view name : kViewNames) {
          if (!standardRotation(name)) continue;
          options.view = ViewChoice{.name = std::string(name), .rotation = std::nullopt};
          QImage picture;
          const SurfaceOutcome outcome = outcomeOf([&] {
            auto surface =
                std::make_shared<const Surface>(makeSurface(*scan, options, rasterize, task));
            picture = pictureOf(*surface, task).shaded;
            return surface;
          });
          if (outcome.cancelled) return;
          // From where all lies on a line there is no picture.
          if (picture.isNull()) continue;
          faces->emplace_back(
              std::string(name),
              picture.scaled(kFacePx, kFacePx, Qt::KeepAspectRatio, Qt::SmoothTransformation));
        }
      },
      [this, shown, faces] {
        if (document_.surface() != shown || faces->size() < 2) return;
        questions_.emplace_back([this, faces] { askFace(*faces); });
        askNext();
      });
}

void QuestionController::askFace(const std::vector<std::pair<std::string, QImage>>& faces) {
  std::vector<MessageStrip::Button> buttons;
  for (const auto& [name, picture] : faces) {
    const bool is_shown = name == document_.surface()->view_name;
    QPixmap pixels(kFacePx, kFacePx);
    pixels.fill(Qt::transparent);
    QPainter painter(&pixels);
    painter.drawImage((kFacePx - picture.width()) / 2, (kFacePx - picture.height()) / 2, picture);
    painter.end();
    const MessageStrip::Button button{viewText(QString::fromStdString(name)),
                                      [this, name = name] {
                                        if (name == document_.surface()->view_name) {
                                          askNext();
                                        } else {
                                          document_.choices().setView({name, {}});
                                        }
                                      },
                                      QIcon(pixels)};
    buttons.insert(is_shown ? buttons.begin() : buttons.end(), button);  // For Ctrl+Return.
  }
  messages_.show(tr("How this object stands is not certain. From where shall it be seen?"),
                 buttons);
}

void QuestionController::askUnit() {
  const Surface& surface = *document_.surface();
  if (!surface.info.bounds) return;
  const bool assumed =
      surface.unit_source == UnitSource::assumed || surface.unit_source == UnitSource::guessed;
  const LengthUnit likely = assumed ? guessUnit(surface.info).unit : surface.unit;
  std::vector<MessageStrip::Button> buttons;
  const std::vector<LengthUnit> units = unitsToOffer(surface);
  for (const LengthUnit unit : units) {
    QString text = unitText(unit);
    text[0] = text[0].toUpper();
    const MessageStrip::Button button{text, [this, unit] { chooseUnit(unit); }};
    buttons.insert(unit == likely ? buttons.begin() : buttons.end(), button);  // For Ctrl+Return.
  }
  messages_.show(
      assumed ? unitDoubt(surface)
              : tr("%1: %2. Which unit?").arg(unitlessSize(surface), sizesInUnits(surface, units)),
      buttons);
}

// A picture of heights says neither how far apart its pixels lie nor how high a step is.
void QuestionController::askScale() {
  const ScaleInUse& scale = *document_.surface()->raster_scale;
  const DepthMap& map = document_.surface()->map;
  const HeightRange heights = heightRange(map);
  const QString size =
      sizeText({map.frame.spacing_mm * (map.frame.size.cols - 1),
                map.frame.spacing_mm * (map.frame.size.rows - 1), heights.max_mm - heights.min_mm});
  const auto mm = [](double v) { return QLocale().toString(v, 'g', 4); };
  const QString shown =
      tr("This picture of heights does not say how large it is. Shown with pixels "
         "of %1 mm and steps of %2 mm: %3.")
          .arg(mm(scale.pixel_mm), mm(scale.height_mm), size);
  const bool guessed = scale.height_source == UnitSource::guessed;
  const QString why = guessed ? tr("The steps are a guess: with 1 mm it would be higher than it is "
                                   "long.")
                              : tr("Both are a guess.");
  messages_.show(QStringLiteral("%1 %2").arg(shown, why),
                 {{tr("&Say how large\u2026"), [this] { chooseScale(); }},
                  {tr("&Keep it so"), [this, scale] {
                     document_.choices().setRasterScale(
                         {.pixel_mm = scale.pixel_mm, .height_mm = scale.height_mm, .zero = {}});
                   }}});
}

void QuestionController::chooseScale() {
  const auto& raster = document_.source().raster;
  const auto& scale = document_.surface()->raster_scale;
  if (!raster || !scale) return;
  auto* dialog = new RasterScaleDialog(*raster, *scale, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &RasterScaleDialog::chosen, this, [this](const RasterScale& chosen) {
    messages_.close();
    document_.choices().setRasterScale(chosen);
  });
  dialog->open();
}

void QuestionController::chooseUnit(LengthUnit unit) {
  settings_.rememberUnit(document_.file(), unit);
  messages_.close();
  document_.choices().setUnit(unit);
}

void QuestionController::tellWithheld(int count) {
  questions_.emplace_back([this, count] {
    messages_.show(
        tr("%n file(s) that this project names were not read. They stay named in it, and "
           "are offered for no package and no figure.",
           nullptr, count));
  });
}

}  // namespace relievo
