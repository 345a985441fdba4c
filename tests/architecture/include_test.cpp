// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/architecture/include_table.h"
#include "tests/architecture/source_tree.h"

namespace relievo::architecture {
namespace {

const IncludeTable& table() {
  static const IncludeTable kTable = [] {
    std::ifstream in(RELIEVO_SOURCE_DIR "/tests/architecture/allowed_includes.txt");
    return parseTable(std::string(std::istreambuf_iterator<char>(in), {}));
  }();
  return kTable;
}

std::size_t found(const std::string& path, const std::string& source) {
  return violations(table(), path, source).size();
}

TEST(Includes, OfTheWholeTreeAreInTheTable) {
  const auto sources = readTree(isCpp);
  ASSERT_GE(sources.size(), 1000U);
  for (const auto& [path, source] : sources) {
    for (const std::string& violation : violations(table(), path, source)) {
      ADD_FAILURE() << violation;
    }
  }
}

TEST(Includes, OfAHeavyLibraryStayInOneFile) {
  for (const std::string& spread : spreadLibraries(table(), readTree(isCpp))) {
    ADD_FAILURE() << spread;
  }
}

// What the check must catch: planted edges, one of each kind.
TEST(IncludeCheck, CatchesAnUpwardInclude) {
  EXPECT_EQ(found("core/depth/fill/fill.cpp", "#include \"ui/work/document.h\"\n"), 1U);
  EXPECT_EQ(found("core/base/grid.h", "#include \"core/depth/depth_map.h\"\n"), 1U);
  EXPECT_EQ(found("ui/work/document.cpp", "  #  include \"plugins/api/plugin.h\"\n"), 1U);
  EXPECT_EQ(found("haptics/loop/haptic_loop.cpp", "#include \"plugins/api/plugin.h\"\n"), 1U);
  EXPECT_EQ(found("ui/vtk/relief_scene.cpp", "#include \"ui/work/document.h\"\n"), 1U);
  EXPECT_EQ(found("plugins/haptics/panel.cpp", "#include \"ui/work/document.h\"\n"), 1U);
  EXPECT_EQ(found("ui/video/video.cpp", "#include \"core/tiles/tiled_map.h\"\n"), 1U);
  EXPECT_EQ(found("core/session/load.cpp", "#include \"core/project/project.h\"\n"), 1U);
}

TEST(IncludeCheck, CatchesALibraryInTheWrongModule) {
  EXPECT_EQ(found("core/depth/fill/fill.cpp", "#include <vtkRenderer.h>\n"), 1U);
  EXPECT_EQ(found("haptics/proxy/proxy.cpp", "#include <QString>\n"), 1U);
  EXPECT_EQ(found("core/cloud/load.cpp", "#include <pcl/io/ply_io.h>\n"), 1U);
  EXPECT_EQ(found("core/region/region.cpp", "#include <gdal_priv.h>\n"), 1U);
}

TEST(IncludeCheck, CatchesAHeavyLibraryInAHeader) {
  EXPECT_EQ(found("core/io/import.h", "#include <pcl/io/ply_io.h>\n"), 1U);
  EXPECT_EQ(found("core/io/read_pcl.cpp", "#include <pcl/io/ply_io.h>\n"), 0U);
  EXPECT_EQ(found("ui/views/detail_view.h", "#include <vtkRenderer.h>\n"), 1U);
  EXPECT_EQ(found("ui/vtk/relief_scene.h", "#include <vtkRenderer.h>\n"), 1U);
  EXPECT_EQ(found("ui/plots/time_plot.h", "#include <qwt_plot.h>\n"), 1U);
}

TEST(IncludeCheck, KeepsInternalHeadersInTheirModule) {
  EXPECT_EQ(found("ui/vtk/surface_mesh.h", "#include <vtkPolyData.h>\n"), 0U);
  EXPECT_EQ(found("ui/vtk/relief_scene.cpp", "#include \"ui/vtk/surface_mesh.h\"\n"), 0U);
  EXPECT_EQ(found("ui/views/detail_view.cpp", "#include \"ui/vtk/surface_mesh.h\"\n"), 1U);
  // Unless the table names another.
  EXPECT_EQ(found("core/project/project.cpp", "#include \"core/provenance/parameters_json.h\"\n"),
            0U);
  EXPECT_EQ(found("core/session/load.cpp", "#include \"core/provenance/parameters_json.h\"\n"), 1U);
}

TEST(IncludeCheck, CatchesARoomThatIncludesOneAboveIt) {
  EXPECT_EQ(found("ui/work/document.cpp", "#include \"ui/views/detail_view.h\"\n"), 1U);
  EXPECT_EQ(found("ui/dialogs/image_dialog.h", "#include \"ui/window/main_window.h\"\n"), 1U);
  EXPECT_EQ(found("ui/views/detail_view.cpp", "#include \"ui/work/document.h\"\n"), 0U);
  EXPECT_EQ(found("ui/control/look_controller.h", "#include \"ui/window/controller.h\"\n"), 0U);
  EXPECT_EQ(found("ui/window/controllers.h", "#include \"ui/control/look_controller.h\"\n"), 0U);
  EXPECT_EQ(found("ui/newroom/a.cpp", "#include \"ui/style/palette.h\"\n"), 1U) << "no room";
}

TEST(IncludeCheck, CatchesWhatTheTableDoesNotKnow) {
  EXPECT_EQ(found("core/base/grid.h", "#include <unheard/of.h>\n"), 1U);
  EXPECT_EQ(found("newfolder/a.h", "#include <vector>\n"), 1U);
  EXPECT_EQ(found("core/base/grid.h", "#include \"grid_detail.h\"\n"), 1U) << "not from the root";
}

TEST(IncludeCheck, CatchesALibraryThatSpreads) {
  const std::string uses_pcl = "#include <pcl/io/ply_io.h>\n";
  EXPECT_EQ(spreadLibraries(table(), {{"core/io/a.cpp", uses_pcl}}).size(), 0U);
  EXPECT_EQ(
      spreadLibraries(table(), {{"core/io/a.cpp", uses_pcl}, {"core/io/b.cpp", uses_pcl}}).size(),
      1U);
}

TEST(IncludeCheck, LetsAllowedEdgesPass) {
  EXPECT_EQ(found("core/depth/fill/fill.cpp",
                  "// #include \"ui/work/document.h\"\n#include \"core/base/grid.h\"\n"
                  "#include \"core/depth/fill/fill.h\"\n#include <vector>\n"),
            0U);
  EXPECT_EQ(
      found("ui/views/detail_view.cpp", "#include \"ui/vtk/relief_scene.h\"\n#include <QWidget>\n"),
      0U);
  EXPECT_EQ(found("app/cli/verbs/verb_touch.cpp", "#include \"haptics/loop/haptic_core.h\"\n"), 0U);
}

}  // namespace
}  // namespace relievo::architecture
