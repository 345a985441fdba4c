// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/control/foreign_files.h"
#include "ui/control/look_controller.h"
#include "ui/control/measure_controller.h"
#include "ui/control/open_controller.h"
#include "ui/control/output/exhibit_setup_controller.h"
#include "ui/control/output/export_controller.h"
#include "ui/control/output/package_controller.h"
#include "ui/control/output/picture_controller.h"
#include "ui/control/output/save_controller.h"
#include "ui/control/output/tiles_controller.h"
#include "ui/control/output/video_controller.h"
#include "ui/control/place_controller.h"
#include "ui/control/pointer_controller.h"
#include "ui/control/question_controller.h"
#include "ui/control/recordings_end.h"
#include "ui/control/replay_controller.h"
#include "ui/control/study_controller.h"
#include "ui/control/surface_controller.h"
#include "ui/control/touch_controller.h"
#include "ui/control/turn_controller.h"
#include "ui/control/web_controller.h"

namespace relievo {

class WorkArea;

/// All controllers of a window, each after those that it needs. [GUI thread]
struct Controllers {
  Controllers(const ControllerParts& parts, WorkArea& area);

  SaveController saving;
  ForeignFiles foreign;
  PackageController packages;
  OpenController opening;
  LookController look;
  MeasureController measure;
  TouchController touch;
  PlaceController places;
  ReplayController replays;
  VideoController videos;
  RecordingsEnd recordings_end;
  PictureController pictures;
  ExportController exports;
  TilesController tiles;
  QuestionController questions;
  PointerController pointer;
  SurfaceController surface;
  StudyController study;
  WebController web;
  TurnController turns;
  ExhibitSetupController exhibits;
};

}  // namespace relievo
