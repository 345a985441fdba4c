// SPDX-License-Identifier: BSD-3-Clause
// fuzz_seeds FOLDER: writes FOLDER/<target>/<name>, small good files for the fuzzers to start from.
#include <fcntl.h>
#include <ogr_spatialref.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/io/raster/gdal_session.h"
#include "core/io/raster/raster.h"
#include "core/io/worker/scan_transport.h"
#include "core/message/catalogue.h"
#include "core/prepare/transport.h"
#include "tests/core/io/e57_sample.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/sample_files.h"
#include "tests/emulator/made_image.h"

namespace {

using namespace relievo;
using namespace relievo::test;
using namespace std::string_literals;

class Seeds {
 public:
  explicit Seeds(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path add(const std::string& target, const std::string& name,
                            const std::string& bytes) const {
    std::filesystem::create_directories(folder_ / target);
    std::filesystem::path file = folder_ / target / name;
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }

 private:
  std::filesystem::path folder_;
};

/// Points alone, which PCL's reader and ours both read.
void addBoth(const Seeds& seeds) {
  const std::string colour = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  for (const std::string order : {"binary_little_endian", "binary_big_endian"}) {
    seeds.add("bothply", order,
              plyHeader(order, "3") + binaryRows<float>(3, order != "binary_little_endian"));
    seeds.add(
        "bothply", order + "_double",
        plyHeader(order, "3", "double") + binaryRows<double>(3, order != "binary_little_endian"));
    seeds.add("bothply", order + "_short",
              plyHeader(order, "3", "short") + binaryRows<std::int16_t>(3));
    seeds.add("bothply", order + "_colour",
              plyHeader(order, "1", "float", colour) + binaryRows<float>(1) + "\1\2\3");
  }
  PcdWords words;
  words.points = "3";
  words.data = "binary";
  seeds.add("bothpcd", "binary", pcdHeader(words) + binaryRows<float>(3));
  words.size = "8 8 8";
  seeds.add("bothpcd", "double", pcdHeader(words) + binaryRows<double>(3));
  words.points = "2";
  words.fields = "x y z rgb";
  words.size = "4 4 4 4";
  words.type = "F F F U";
  words.count = "1 1 1 1";
  seeds.add("bothpcd", "colour", pcdHeader(words) + std::string(32, '\x3F'));
}

void addPly(const Seeds& seeds) {
  const std::string le = "binary_little_endian";
  const std::string lists = "property list uchar int neighbours\n";
  seeds.add("ply", "ascii", plyHeader("ascii", "3") + textRows(3));
  seeds.add("ply", "ascii_faces",
            plyHeader("ascii", "3", "double", kPlyFaces) + textRows(3) + "3 0 1 2\n4 0 1 2 1\n");
  seeds.add("ply", "le", plyHeader(le, "3") + binaryRows<float>(3));
  seeds.add("ply", "le_faces",
            plyHeader(le, "5", "float", kPlyFaces) + binaryRows<float>(5) +
                plyTriangles({0, 1, 2, 2, 3, 4}));
  seeds.add("ply", "be_double",
            plyHeader("binary_big_endian", "3", "double") + binaryRows<double>(3, true));
  seeds.add("ply", "short", plyHeader(le, "3", "short") + binaryRows<std::int16_t>(3));
  seeds.add("ply", "list",
            plyHeader(le, "2", "float", lists) + binaryRows<float>(1) + "\1"s + bytesOf(7) +
                binaryRows<float>(1) + "\0"s);
  seeds.add("ply", "faces_first",
            "ply\nformat ascii 1.0\nobj_info x\nelement face 1\nproperty list uchar int "
            "vertex_index\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
            "z\nproperty uchar red\nend_header\n3 0 1 2\n0 0 0 1\n1 0 0 2\n0 1 0 3\n");
  seeds.add("stream", "ply", plyHeader(le, "3") + binaryRows<float>(3));
  seeds.add("stream", "ply_be",
            plyHeader("binary_big_endian", "3", "double") + binaryRows<double>(3, true));
}

void addPcd(const Seeds& seeds) {
  PcdWords words;
  words.points = "3";
  seeds.add("pcd", "ascii", pcdHeader(words) + textRows(3));
  words.data = "binary";
  seeds.add("pcd", "binary", pcdHeader(words) + binaryRows<float>(3));
  words.size = "8 8 8";
  seeds.add("pcd", "double", pcdHeader(words) + binaryRows<double>(3));
  words.size = "4 4 4";
  words.data = "binary_compressed";
  // LZF: literals of at most 32 bytes, each after its length - 1.
  std::string columns;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 3; ++i) columns += bytesOf(static_cast<float>(i + axis));
  }
  const std::string packed = "\x1F" + columns.substr(0, 32) + "\x03" + columns.substr(32);
  seeds.add("pcd", "compressed",
            pcdHeader(words) + bytesOf(static_cast<std::uint32_t>(packed.size())) +
                bytesOf(static_cast<std::uint32_t>(columns.size())) + packed);
  seeds.add("bothpcd", "compressed",
            pcdHeader(words) + bytesOf(static_cast<std::uint32_t>(packed.size())) +
                bytesOf(static_cast<std::uint32_t>(columns.size())) + packed);
  words.data = "binary";
  words.points = "2";
  words.fields = "t x y z";
  words.size = "8 4 4 4";
  words.type = "U F F F";
  words.count = "2 1 1 1";
  seeds.add("pcd", "wide",
            pcdHeader(words) + std::string(16, 't') + binaryRows<float>(1) + std::string(16, 't') +
                binaryRows<float>(1));
}

void addText(const Seeds& seeds) {
  seeds.add("obj", "mesh",
            "# x\nmtllib a\nv 0 0 0\nv 1 0 0.5 1 1 1\nv 0 1 0.25\nvt 0 0\n"
            "vn 0 0 1\ng a\nf 1 2 3\nf 1/1/1 2//2 -1\nf 1 2 \\\n3\n");
  seeds.add("text", "xyz", textRows(3));
  seeds.add("text", "pts", "3\n" + textRows(3));
  seeds.add("text", "csv", "x,y,z,\"red\"\n1,2,3,4\n1.5,,NULL,2\n");
  seeds.add("text", "semicolons", "i;z;y;x\n1;1,5;2,5;3,5\n2;1;2;3\n");
  seeds.add("text", "decimal_commas", "1,5 2,5 3,5\n// x\n#y\n1,0 2,5 1e3\n");
  const std::string ptx_head =
      "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n";
  seeds.add("ptx", "one", ptx_head + "1 2 3 0.5\n0 0 0 0.5\n");
  seeds.add("ptx", "two", ptx_head + "1 2 3 0.5\n0 0 1 0.5\n" + ptx_head + "1 2 3 1\n4 5 6 1\n");
  seeds.add("stl", "binary", binaryStl(2, 2));
  seeds.add("stl", "ascii", asciiStl());
}

void addThreeDs(const Seeds& seeds) {
  const auto chunk = [](std::uint16_t kind, const std::string& body) {
    return bytesOf(kind) + bytesOf(static_cast<std::uint32_t>(6 + body.size())) + body;
  };
  const std::string vertices = chunk(0x4110, bytesOf(std::uint16_t{3}) + binaryRows<float>(3));
  std::string face;
  for (const int corner : {0, 1, 2, 7}) face += bytesOf(static_cast<std::uint16_t>(corner));
  const std::string faces = chunk(0x4120, bytesOf(std::uint16_t{1}) + face);
  const std::string object = chunk(0x4000, "a\0"s + chunk(0x4100, vertices + faces));
  seeds.add("3ds", "mesh", chunk(0x4D4D, chunk(0x3D3D, object + object)));
}

void addLas(const Seeds& seeds) {
  Las las = withRecord(geoKeys({{1024, 0, 1, 1}, {3076, 0, 1, 9003}, {4099, 0, 1, 9001}}));
  las.count = 3;
  las.promised = 3;
  las.legacy_promised = 3;
  const auto both = [&](const std::string& name) {
    seeds.add("las", name, lasFile(las));
    seeds.add("stream", name, lasFile(las));
  };
  both("geo_keys");
  las.minor = 4;
  las.format = 6;
  const std::string text =
      R"(COMPD_CS["d",PROJCS["a",GEOGCS["b",UNIT["degree",0.017]],UNIT["metre",1]],VERT_CS["e",UNIT["US survey foot",0.3048006096012192]]])";
  las.variable_records = variableRecord(2112, text);
  both("wkt");
}

void addLaz(const Seeds& seeds) {
  for (const int format : {0, 1, 3, 4, 5, 6, 7, 8, 9, 10}) {
    Laz laz;
    laz.how = {.format = format, .extra_bytes = format == 3 || format == 8 ? 2U : 0U};
    laz.records = wanderingRecords(laz.how, 40, format == 8 ? 3 : 1);
    laz.chunk_points = 25;
    const std::string bytes = lazFile(laz).bytes;
    seeds.add("laz", "format_" + std::to_string(format), bytes);
    seeds.add("stream", "laz_" + std::to_string(format), bytes);
    if (format < 6) continue;
    laz.chunk_points = ~std::uint32_t{0};
    laz.chunks = {10, 5, 12, 13};
    laz.levels = {0, 1, 2, 2};
    seeds.add("copc", "format_" + std::to_string(format), lazFile(laz).bytes);
  }
  for (const int format : {3, 5}) {
    Laz old;
    old.how = {.format = format, .extra_bytes = 1, .version = 1};
    old.records = wanderingRecords(old.how, 40);
    old.one_stream = format == 3;
    old.chunk_points = 25;
    seeds.add("laz", "first_version_" + std::to_string(format), lazFile(old).bytes);
  }
  Laz cut;
  cut.how = {.format = 7};
  cut.records = wanderingRecords(cut.how, 60);
  cut.chunk_points = 25;
  const LazBytes whole = lazFile(cut);
  seeds.add("laz", "cut", whole.bytes.substr(0, whole.chunks_at.back() + 3));
  Laz stream;
  stream.records = wanderingRecords(stream.how, 20);
  stream.one_stream = true;
  seeds.add("laz", "one_stream", lazFile(stream).bytes);
}

void addE57(const Seeds& seeds) {
  PackedBits bits;
  for (int i = 0; i < 5; ++i) bits.add(static_cast<std::uint64_t>(i), 5);
  const std::string whole =
      R"(type="ScaledInteger" minimum="-4" maximum="20" scale="0.5" offset="1")";
  const std::string pose =
      "<pose><rotation><w>0</w><x>0</x><y>0</y><z>1</z></rotation><translation><x>1</x>"
      "<y>2</y><z>3</z></translation></pose>";
  const std::string real = R"(type="Float")";
  const std::string single = R"(type="Float" precision="single")";
  std::string doubles, floats;
  for (int i = 0; i < 5; ++i) {
    doubles += bytesOf(i * 0.5);
    floats += bytesOf(static_cast<float>(i));
  }
  E57Sample sample;
  sample.add({"5",
              {{"cartesianX", whole, bits.bytes()},
               {"cartesianY", real, doubles},
               {"cartesianZ", single, floats}},
              pose,
              {}});
  seeds.add("e57", "cartesian", sample.file());
  // Numbers of 12 bits: one changed digit of the text away from other widths.
  std::string wide = sample.xml();
  wide.replace(wide.find("maximum=\"20\""), 12, "maximum=\"4000\"");
  seeds.add("e57", "wide", sample.fileWith(wide));
  sample.add({"5",
              {{"sphericalRange", real, doubles},
               {"sphericalAzimuth", real, doubles},
               {"sphericalElevation", single, floats},
               {"sphericalInvalidState", R"(type="Integer" minimum="0" maximum="2")", "\x24\0"s}},
              {},
              {},
              16});
  seeds.add("e57", "two_scans", sample.file());
}

/// 4 x 3 whole numbers of another program, some of them no heights.
void addForeign(const std::filesystem::path& file, GDALDataType type, const char* driver,
                bool scaled) {
  GDALDriverManager& drivers = *GetGDALDriverManager();
  const Dataset cells(drivers.GetDriverByName("MEM")->Create("", 4, 3, 1, type, nullptr));
  std::array<std::int16_t, 12> numbers{1, 2, 3, 9, 5, 6, 7, 8, 9, 10, 11, 12};
  GDALRasterBand& band = *cells->GetRasterBand(1);
  const CPLErr written =
      band.RasterIO(GF_Write, 0, 0, 4, 3, numbers.data(), 4, 3, GDT_Int16, 0, 0, nullptr);
  if (written != CE_None) throw WriteError("a seed's cells");
  if (scaled) {
    band.SetScale(2);
    band.SetOffset(1);
  } else {
    band.SetNoDataValue(9);
  }
  const Dataset copy(drivers.GetDriverByName(driver)->CreateCopy(file.c_str(), cells.get(), 0,
                                                                 nullptr, nullptr, nullptr));
  if (!copy) throw WriteError("a seed");
}

/// Metres in a projected system, heights in metres too.
void addProjected(const std::filesystem::path& file) {
  addForeign(file, GDT_Int16, "GTiff", false);
  const Dataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
  if (!dataset) throw WriteError("a seed");
  OGRSpatialReference system;
  system.SetProjCS("seed");
  system.SetWellKnownGeogCS("WGS84");
  system.SetUTM(33);
  dataset->SetSpatialRef(&system);
  std::array<double, 6> transform{500'000, 2, 0, 4'000'000, 0, -2};
  dataset->SetGeoTransform(transform.data());
  dataset->GetRasterBand(1)->SetUnitType("m");
}

void addForeignRasters(const std::filesystem::path& folder) {
  GDALRegister_MEM();
  addProjected(folder / "projected.tif");
  addForeign(folder / "nodata.tif", GDT_Int16, "GTiff", false);
  addForeign(folder / "scaled.tif", GDT_Int16, "GTiff", true);
  addForeign(folder / "bytes.png", GDT_Byte, "PNG", false);
  addForeign(folder / "words.png", GDT_UInt16, "PNG", false);
  // What GDAL keeps beside a PNG is no seed.
  for (const char* name : {"bytes.png.aux.xml", "words.png.aux.xml"}) {
    std::filesystem::remove(folder / name);
  }
}

void addRasters(const Seeds& seeds, const std::filesystem::path& folder) {
  seeds.add("raster", "grid",
            "ncols 3\nnrows 2\nxllcorner 5\nyllcorner 6\ncellsize 0.5\nNODATA_value -9\n1 2 3\n4 "
            "-9 6\n");
  seeds.add("raster", "more_cells",
            "ncols 2\nnrows 5\nxllcorner 5\nyllcorner 6\ncellsize 0.5\n1 2\n3 4\n5 6\n7 8\n"
            "9 8\n7 6\n5 4\n3 2\n");
  DepthMap map{.frame = {.size = {3, 2}, .spacing_mm = 0.5},
               .heights_mm = {1, 2, 3, 4, 5, 6},
               .origins = std::vector<CellStatus>(6, CellStatus::measured)};
  map.origins[2] = CellStatus::outside;
  std::filesystem::create_directories(folder / "raster");
  writeMap(folder / "raster" / "map.tif", map, {});
  addForeignRasters(folder / "raster");
}

void addAnswers(const Seeds& seeds) {
  const auto open = [&](const std::string& name) {
    return OwnedFd(::open(seeds.add("answer", name, "").c_str(), O_WRONLY | O_CLOEXEC));
  };
  Scan scan;
  scan.info.format = "PLY";
  scan.info.points = 4;
  scan.info.finite_points = 3;
  scan.info.faces = 1;
  scan.info.unit = LengthUnit::ft;
  scan.info.warnings = {said<MessageId::quoted>("One."), said<MessageId::raster_bands>(2)};
  scan.info.bounds = FileBounds{{0, 0, 0}, {1, 1, 0}};
  scan.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scan.triangles = {{0, 1, 2}};
  sendAnswer(open("scan").get(), scan);
  sendAnswer(open("refusal").get(), WorkerRefusal{"Cannot read it.", "E101"});
  RasterEnd raster{.head = {}, .has_origins = true};
  raster.head.size = {3, 2};
  raster.head.info.bounds = FileBounds{{0, 0, 0}, {2, 1, 5}};
  const std::array<float, 3> row{0, std::numeric_limits<float>::quiet_NaN(), 5};
  const std::array<CellStatus, 3> origins{CellStatus::measured, CellStatus::outside,
                                          CellStatus::measured};
  const OwnedFd file = open("raster");
  RasterAnswer answer(file.get());
  const RasterSink sink = answer.sink();
  sink.begin(raster.head, true);
  for (int i = 0; i < 2; ++i) sink.row(i, row.data(), origins.data());
  answer.finish(raster);
}

void addRecipes(const Seeds& seeds) {
  Align align;
  align.method = AlignMethod::points;
  align.pairs = {{.scan = 1, .point = {1, 2, 3}, .reference = {4, 5, 6}}};
  align.poses = {Pose{}, Pose{}};
  const CropOutline outline{.outline = {{0, 0}, {1, 0}, {0, 1}}};
  Recipe recipe{
      .scans = {{.file = "a.ply", .unit = LengthUnit::m}, {.file = "b/c.laz"}},
      .steps = {CropBox{.max = {1, 2, 3}}, outline, Classes{.keep = {2, 6}},
                Intensities{.low = 1, .high = 2}, Duplicates{}, Outliers{}, Lonely{},
                Sparse{.off_surface = 4}, align, Thin{.spacing_mm = 1}, Base{}, Normals{}}};
  seeds.add("recipe", "all", toJson(recipe));
  recipe.scans.clear();
  for (std::size_t i = 0; i < recipe.steps.size(); ++i) {
    seeds.add("recipe", std::to_string(i), toJson({.steps = {recipe.steps[i]}}, -1));
  }
}

/// What prepared_target's job of two scans of five points may be answered with.
void addPrepared(const Seeds& seeds) {
  const auto open = [&](const std::string& name) {
    return OwnedFd(::open(seeds.add("prepared", name, "").c_str(), O_RDWR | O_CLOEXEC));
  };
  PrepareAnswer answer;
  PointBits kept(10);
  for (const std::uint64_t left : {10U, 9U, 9U}) {
    StepResult step{.before = answer.steps.empty() ? 10 : answer.steps.back().after, .after = left};
    if (left == 9) kept.clear(3);
    step.kept = kept;
    step.notes = {said<MessageId::quoted>("A note.")};
    answer.steps.push_back(step);
  }
  answer.poses.resize(2);
  answer.normals.assign(9, {0, 0, 1});
  answer.warnings = {said<MessageId::quoted>("One.")};
  answer.align.emplace().scans.resize(2);
  answer.align->loops.push_back({});
  sendPrepareAnswer(open("answer").get(), answer);
  answer.align.reset();
  answer.normals.clear();
  sendPrepareAnswer(open("without").get(), answer);
  sendPrepareAnswer(open("refusal").get(),
                    PrepareRefusal{said<MessageId::quoted>("It cannot be done.")});
}

void addDevices(const Seeds& seeds) {
  // Line status, an answer, status alone, half an answer.
  seeds.add("protocol", "answers", "\x01`<IODAIBMPPPPAqA>\x01`\x01`<PPPACEP<AAAAAAAAAAAAAA>");
  for (const auto& [name, blocks] :
       {std::pair("blocks", std::vector<std::uint16_t>{900, 200, 4, 1}),
        std::pair("one", std::vector<std::uint16_t>{1100})}) {
    const std::vector<std::uint8_t> image = test::madeImage(blocks);
    seeds.add("image", name, {reinterpret_cast<const char*>(image.data()), image.size()});
  }
  // A gamepad of four buttons and two axes, and one of its reports.
  constexpr std::array<std::uint8_t, 43> kGamepad{
      39,   0x05, 0x01, 0x09, 0x05, 0xa1, 0x01, 0x85, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x04,
      0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x04, 0x81, 0x02, 0x95, 0x04, 0x81, 0x03, 0x05,
      0x01, 0x09, 0x30, 0x75, 0x08, 0x95, 0x02, 0x81, 0x02, 0xc0, 0x01, 0x05, 0x80};
  seeds.add("host_page", "answer",
            std::string(1, '\0') + "plugin\tName\t1\tMaker\tBSD\ndevice\tit.1\tIt\n");
  seeds.add("host_page", "page", std::string(1, '\1'));
  seeds.add("host_page", "rounds", std::string(1, '\2'));
  seeds.add("hid", "gamepad", {reinterpret_cast<const char*>(kGamepad.data()), kGamepad.size()});
  seeds.add("pad", "xbox",
            "\x19"
            "7cdb000000000000 0 0 0 0\n107030000 0\n");
  seeds.add("haply", "event",
            R"({"name":"device-safety-triggered","category":"device","level":"warning",)"
            R"("data":{"device_id":"049D","safety_type":"ebrake_triggered"},"message":"stop"})");
  seeds.add("haply", "version", R"({"project_version":"3.5.0.0"})");
  seeds.add("haply", "state",
            R"({"session_id":7,"inverse3":[{"device_id":"A1","config":{"type":"minverse",)"
            R"("preset":"p","basis":{"permutation":"XYZ"},"mount":{"scale":{"x":1}}},"state":)"
            R"({"cursor_position":{"x":0,"y":-1e-1,"z":0.1},"current_cursor_force":null,)"
            R"("transform":{}},"status":{"calibrated":true,"ready":true}}],"verse_grip":)"
            R"([{"state":{"button":true}}],"wireless_verse_grip":[{"state":{"buttons":)"
            R"({"a":true,"b":false}}}]})");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("fuzz_seeds FOLDER\n", stderr);
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  const Seeds seeds(folder);
  addBoth(seeds);
  addPly(seeds);
  addPcd(seeds);
  addText(seeds);
  addThreeDs(seeds);
  addLas(seeds);
  addLaz(seeds);
  addE57(seeds);
  addRasters(seeds, folder);
  addAnswers(seeds);
  addRecipes(seeds);
  addPrepared(seeds);
  addDevices(seeds);
  return 0;
}
