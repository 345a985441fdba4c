// SPDX-License-Identifier: BSD-3-Clause
// A published map is the map that was published, from a folder and over the web; what is damaged or
// gone is said and never used.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <mutex>
#include <random>
#include <span>

#include "core/base/failure.h"
#include "core/tiles/level_files.h"
#include "core/tiles/published/publish.h"
#include "core/tiles/published/published_tiles.h"
#include "core/tiles/published/windows_ahead.h"
#include "core/tiles/tile_layout.h"
#include "tests/core/tiles/slow_web_server.h"
#include "tests/core/tiles/tile_fixtures.h"
#include "tests/core/tiles/vast_map.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

void writeMapTo(const fs::path& file, GridSize size) {
  const GridFrame frame{.size = size, .spacing_mm = 0.1, .first_x_mm = 0.05, .first_y_mm = 0.05};
  LevelFiles files(file, frame, {.factor = 2});
  std::mt19937 random(5);
  std::uniform_real_distribution<float> rough(0, 0.05F);
  std::vector<float> heights(static_cast<std::size_t>(size.cols));
  std::vector<CellStatus> origins(heights.size());
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const bool outside = col < size.cols / 3 && row < size.rows / 3;
      const auto i = static_cast<std::size_t>(col);
      heights[i] =
          outside ? 0 : 2 + std::sin(0.02F * static_cast<float>(col + row)) + rough(random);
      origins[i] = outside ? CellStatus::outside : CellStatus::measured;
    }
    files.add(heights.data(), origins.data());
  }
  files.finish({}, "a state");
}

/// A map, its published folder, and a place of its own for what is kept.
class Publishing : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    ::unsetenv("RELIEVO_MAP_CACHE_MB");
  }
  void publishMap(GridSize size) {
    writeMapTo(map(), size);
    done_ = publish(TiledMap(map()), published(),
                    {.title = "Relief", .licence = "CC-BY-4.0", .citation = "A Museum, 2026"});
  }
  fs::path map() const { return folder_ / "map.tif"; }
  fs::path published() const { return folder_ / "web"; }

  test::TileFolder folder_;
  Published done_;
};

Region at(double x, double y, double side, int level) {
  return {.x_mm = x, .y_mm = y, .side_mm = side, .level = {level}};
}

void expectSameWindows(const TiledMap& a, const TiledMap& b) {
  ASSERT_EQ(a.frames().size(), b.frames().size());
  EXPECT_EQ(a.ladder().spacings_mm, b.ladder().spacings_mm);
  EXPECT_EQ(a.shares(), b.shares());
  EXPECT_EQ(a.heights().max_mm, b.heights().max_mm);
  EXPECT_EQ(a.state(), b.state());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-10, 150);
  for (int i = 0; i < 12; ++i) {
    const Region region =
        at(place(random), place(random), 20, i % static_cast<int>(a.frames().size()));
    const RegionWindow one = a.window(region, 1.5), other = b.window(region, 1.5);
    ASSERT_EQ(one.heights_mm, other.heights_mm) << i;
    ASSERT_EQ(one.origins, other.origins) << i;
    EXPECT_EQ(one.id, other.id);
  }
}

template <class Failure>
std::string refusalOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Failure& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST_F(Publishing, GivesTheWindowsOfTheMapFromTheFolderAndTheWeb) {
  publishMap({.cols = 1300, .rows = 1100});
  EXPECT_GT(done_.outside_tiles, 0U);
  EXPECT_LT(done_.bytes, done_.bytes_of_tiles);
  const TiledMap original(map());
  const TiledMap from_folder(published() / "map.json");
  EXPECT_FALSE(from_folder.isRemote());
  EXPECT_EQ(from_folder.published()->licence, "CC-BY-4.0");
  expectSameWindows(original, from_folder);

  test::SlowWebServer server(published(), {});
  const WebMap web = webMap(server.address());
  EXPECT_FALSE(web.from_before);
  const TiledMap from_web(web.manifest);
  EXPECT_TRUE(from_web.isRemote());
  EXPECT_EQ(from_web.place(), server.address());
  expectSameWindows(original, from_web);
  // The second time nothing but map.json is asked for.
  const TiledMap again(webMap(server.address()).manifest);
  const int before = server.requests();
  expectSameWindows(original, again);
  EXPECT_EQ(server.requests(), before);
  // And without the server at all.
  server.stop();
  const WebMap kept = webMap(server.address() + "/map.json");
  EXPECT_TRUE(kept.from_before);
  expectSameWindows(original, TiledMap(kept.manifest));
}

/// Sets what the process that fetches finds in its environment, and takes it back.
class StoreEnvironment {
 public:
  explicit StoreEnvironment(const std::string& server_address) {
    set("AWS_S3_ENDPOINT", server_address.substr(std::string("http://").size()));
    set("AWS_HTTPS", "NO");
    set("AWS_VIRTUAL_HOSTING", "FALSE");
    set("AWS_EC2_METADATA_DISABLED", "true");
    set("AWS_REGION", "eu-central-1");
  }
  ~StoreEnvironment() {
    for (const std::string& name : names_) ::unsetenv(name.c_str());
  }
  StoreEnvironment(const StoreEnvironment&) = delete;
  StoreEnvironment& operator=(const StoreEnvironment&) = delete;
  void set(const std::string& name, const std::string& value) {
    ::setenv(name.c_str(), value.c_str(), 1);
    names_.insert(name);
  }

 private:
  std::set<std::string> names_;
};

TEST_F(Publishing, GivesTheWindowsOfTheMapFromAnObjectStore) {
  fs::create_directory(folder_ / "bucket");
  writeMapTo(map(), {.cols = 1300, .rows = 1100});
  publish(TiledMap(map()), folder_ / "bucket" / "relief", {});
  test::SlowWebServer store(folder_.path(), {.key = "A-KEY"});
  StoreEnvironment environment(store.address());
  const auto refused = [&] { return refusalOf<FileError>([] { webMap("s3://bucket/relief"); }); };
  // A key that is missing or wrong is no matter of the network: nothing is asked for again.
  EXPECT_NE(refused().find("has no file map.json"), std::string::npos) << refused();
  environment.set("AWS_ACCESS_KEY_ID", "ANOTHER");
  environment.set("AWS_SECRET_ACCESS_KEY", "secret");
  EXPECT_NE(refused().find("has no file map.json"), std::string::npos) << refused();
  environment.set("AWS_ACCESS_KEY_ID", "A-KEY");
  const TiledMap from_store(webMap("s3://bucket/relief/").manifest);
  EXPECT_TRUE(from_store.isRemote());
  EXPECT_EQ(from_store.place(), "s3://bucket/relief");
  expectSameWindows(TiledMap(map()), from_store);
  EXPECT_NE(
      refusalOf<FileError>([] { webMap("s3://bucket/elsewhere"); }).find("has no file map.json"),
      std::string::npos);
  store.stop();
  EXPECT_TRUE(webMap("s3://bucket/relief").from_before);
}

TEST_F(Publishing, ReplacesNothingAndLeavesNothingHalfDone) {
  publishMap({.cols = 300, .rows = 300});
  const TiledMap original(map());
  const auto files = [&] {
    std::set<fs::path> names;
    for (const auto& one : fs::directory_iterator(folder_.path())) names.insert(one.path());
    return names;
  };
  const auto before = files();
  const auto into = [&](const fs::path& place) {
    return refusalOf<WriteError>([&] { publish(original, place, {}); });
  };
  EXPECT_NE(into(published()).find("there is something already"), std::string::npos);
  EXPECT_NE(into(map()).find("there is something already"), std::string::npos);
  EXPECT_NE(into(folder_ / "none" / "web").find("Cannot write"), std::string::npos);
  std::stop_source stop;
  stop.request_stop();
  Task stopped;
  stopped.stop = stop.get_token();
  EXPECT_THROW(publish(original, folder_ / "other", {}, stopped), Cancelled);
  EXPECT_EQ(files(), before);
  // Into an empty folder.
  fs::create_directory(folder_ / "empty");
  EXPECT_EQ(publish(original, folder_ / "empty", {}).tiles, done_.tiles);
}

/// Other heights in the place of a tile that unpack as well: only its checksum tells.
/// @return  whether some were found that take as many bytes
bool falsify(std::string& pack, const TileRecord& record) {
  const std::span stored(reinterpret_cast<const std::byte*>(pack.data()) + record.at, record.bytes);
  auto tile = unpackedTile(stored, TilePart::heights);
  for (std::size_t cell = 0; tile && cell < 300; ++cell) {
    std::vector<std::byte> other = *tile;
    other[4 * cell] ^= std::byte{1};  // The last bit of one height.
    const std::vector<std::byte> bytes = packedTile(other, TilePart::heights);
    if (bytes.size() != record.bytes) continue;
    std::memcpy(pack.data() + record.at, bytes.data(), bytes.size());
    return true;
  }
  return false;
}

TEST_F(Publishing, RefusesATileThatUnpacksAndIsNotTheOneThatWasPublished) {
  publishMap({.cols = 2300, .rows = 2300});
  const Region fine = at(100, 80, 20, 0);
  EXPECT_NO_THROW(TiledMap(published() / "map.json").window(fine));
  const fs::path file = published() / "L0.p0.tiles";
  std::string pack;
  {
    std::ifstream in(file, std::ios::binary);
    pack.assign(std::istreambuf_iterator<char>(in), {});
  }
  int falsified = 0;
  for (std::size_t tile = 0; tile < kPackTiles; ++tile) {
    TileRecord record;  // Heights come first of the two parts.
    std::memcpy(&record, pack.data() + 2 * tile * sizeof(record), sizeof(record));
    falsified += record.bytes > 0 && falsify(pack, record) ? 1 : 0;
  }
  ASSERT_GT(falsified, 20);
  std::ofstream(file, std::ios::binary).write(pack.data(), static_cast<long>(pack.size()));
  const auto refusal =
      refusalOf<FileError>([&] { TiledMap(published() / "map.json").window(fine); });
  EXPECT_NE(refusal.find("damaged"), std::string::npos) << refusal;
  test::SlowWebServer server(published(), {});
  const TiledMap web(webMap(server.address()).manifest);
  EXPECT_THROW(web.window(fine), FileError) << "nor over the web";
}

TEST_F(Publishing, RefusesWhatIsDamagedOrGone) {
  publishMap({.cols = 2300, .rows = 2300});
  const Region fine = at(100, 80, 20, 0);
  test::SlowWebServer server(published(), {});
  const TiledMap web(webMap(server.address()).manifest);
  server.damage("L0.p0.tiles");
  EXPECT_NE(refusalOf<FileError>([&] { web.window(fine); }).find("damaged"), std::string::npos);
  server.damage("");
  EXPECT_EQ(web.window(fine).id, TiledMap(map()).window(fine).id);

  // Every byte of map.json and of the list counts; of a pack those of the tiles that are read.
  for (const char* const name : {"map.json", "packs.bin", "L0.p0.tiles"}) {
    const fs::path file = published() / name;
    std::string good;
    {
      std::ifstream in(file, std::ios::binary);
      good.assign(std::istreambuf_iterator<char>(in), {});
    }
    std::mt19937 random(9);
    for (int i = 0; i < 6; ++i) {
      std::string bad = good;
      const std::size_t place = random() % bad.size();
      if (i % 3 == 0) {
        bad.resize(place);
      } else {
        bad[place] ^= static_cast<char>(1U << (random() % 8));
      }
      std::ofstream(file, std::ios::binary).write(bad.data(), static_cast<long>(bad.size()));
      try {
        const TiledMap damaged(published() / "map.json");
        // A title may have another letter; heights never.
        if (std::string(name) == "packs.bin") ADD_FAILURE() << "byte " << place << " is not seen";
        EXPECT_EQ(damaged.window(fine).heights_mm, TiledMap(map()).window(fine).heights_mm);
      } catch (const FileError& error) {
        EXPECT_FALSE(std::string(error.what()).empty());
      }
    }
    std::ofstream(file, std::ios::binary).write(good.data(), static_cast<long>(good.size()));
  }
  fs::remove(published() / "L0.p0.tiles");
  EXPECT_NE(refusalOf<FileError>([&] {
              TiledMap(published() / "map.json").window(fine);
            }).find("has no file L0.p0.tiles"),
            std::string::npos);
  // A server that has something else there.
  std::ofstream(published() / "map.json") << "<html>";
  EXPECT_NE(refusalOf<FileError>([&] { webMap(server.address()); }).find("no published map"),
            std::string::npos);
  EXPECT_NE(refusalOf<FileError>([&] {
              webMap(server.address() + "/elsewhere");
            }).find("has no file map.json"),
            std::string::npos);
}

TEST_F(Publishing, KeepsNoMoreThanItsLimit) {
  KeptTiles kept(folder_ / "kept", "map", 10'000);
  const std::vector<std::byte> tile(3000, std::byte{7});
  for (int i = 0; i < 6; ++i) kept.put(std::to_string(i), tile);
  EXPECT_LE(kept.bytes(), 10'000U);
  EXPECT_FALSE(kept.get("0", 3000));
  EXPECT_EQ(kept.get("5", 3000), tile);
  // Those of before count, and go first.
  KeptTiles next(folder_ / "kept", "other", 10'000);
  EXPECT_EQ(next.bytes(), 9000U);
  next.put("new", tile);
  EXPECT_LE(next.bytes(), 10'000U);
  EXPECT_EQ(next.get("new", 3000), tile);
}

/// What WindowsAhead gives and says, to be waited for.
class Heard {
 public:
  WindowsAhead::Calls calls() {
    return {.give =
                [this](const WindowsAhead::Given& given) {
                  const std::scoped_lock lock(mutex_);
                  given_.push_back(given);
                  changed_.notify_all();
                },
            .say =
                [this](const Message& message) {
                  const std::scoped_lock lock(mutex_);
                  said_.push_back(message.id);
                  changed_.notify_all();
                }};
  }
  bool waitToHear(std::initializer_list<MessageId> any_of) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [&] {
      return std::find_first_of(said_.begin(), said_.end(), any_of.begin(), any_of.end()) !=
             said_.end();
    });
  }
  /// The newest window once it is as asked for, as it was then: others may follow. Null: none was.
  std::shared_ptr<const RegionWindow> waitForWindow(
      const std::function<bool(const RegionWindow&)>& is_right) {
    std::unique_lock lock(mutex_);
    const bool came = changed_.wait_for(
        lock, kPatience, [&] { return !given_.empty() && is_right(*given_.back().window); });
    return came ? given_.back().window : nullptr;
  }

 private:
  static constexpr std::chrono::minutes kPatience{2};

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<WindowsAhead::Given> given_;
  std::vector<MessageId> said_;
};

// The words of a connection that fails name the port, and 404 is no answer there.
TEST_F(Publishing, DigitsOfAPortAreNoAnswer) {
  EXPECT_NE(refusalOf<WebLost>([] { webMap("http://127.0.0.1:40404/relief"); }),
            "nothing was refused");
}

TEST_F(Publishing, ACoarserWindowComesAtOnceAndTheRestWhenTheServerIsBack) {
  publishMap({.cols = 2600, .rows = 2600});
  const TiledMap original(map());
  test::SlowWebServer server(published(), {.delay = std::chrono::milliseconds(50)});
  auto web = std::make_shared<const TiledMap>(webMap(server.address()).manifest);
  const Region here = at(120, 120, 20, 0), there = at(220, 200, 20, 0);
  Heard heard;
  WindowsAhead ahead(web, heard.calls());
  ahead.want(here);
  const auto complete = [&](const Region& region) {
    return heard.waitForWindow(
        [&region](const RegionWindow& window) { return window.region == region; });
  };
  const auto arrived = complete(here);
  ASSERT_TRUE(arrived);
  EXPECT_EQ(arrived->id, original.window(here).id);
  EXPECT_TRUE(heard.waitToHear({MessageId::web_level_coarser}));
  EXPECT_TRUE(heard.waitToHear({MessageId::web_level_complete}));

  server.stop();
  ahead.want(there);
  ASSERT_TRUE(heard.waitToHear({MessageId::web_server_lost}));
  const auto coarser = heard.waitForWindow(
      [&](const RegionWindow& window) { return window.region.x_mm == there.x_mm; });
  ASSERT_TRUE(coarser);
  EXPECT_GT(coarser->region.level.value, 0);
  Region as_given = there;
  as_given.level = coarser->region.level;
  EXPECT_EQ(coarser->id, original.window(as_given).id);
  EXPECT_NE(refusalOf<WebLost>([&] { web->window(there); }).find("cannot be fetched now"),
            std::string::npos);

  server.start();
  const auto back = complete(there);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->id, original.window(there).id);
  EXPECT_TRUE(heard.waitToHear({MessageId::web_server_back}));
}

TEST_F(Publishing, ADamagedTileIsSaidAndTheCoarserLevelStays) {
  publishMap({.cols = 2600, .rows = 2600});
  test::SlowWebServer server(published(), {});
  auto web = std::make_shared<const TiledMap>(webMap(server.address()).manifest);
  const Region region = at(120, 120, 20, 0);
  web->part({0}, {.col = 0, .row = 0}, {.cols = 10, .rows = 10});  // The records are good.
  server.damage("L0.p0");
  Heard heard;
  WindowsAhead ahead(web, heard.calls());
  ahead.want(region);
  ASSERT_TRUE(
      heard.waitToHear({MessageId::published_tile_damaged, MessageId::published_file_damaged}));
  const auto coarser = heard.waitForWindow([](const RegionWindow&) { return true; });
  ASSERT_TRUE(coarser);
  EXPECT_GT(coarser->region.level.value, 0);
}

TEST_F(Publishing, AMapOfTenToTheTwelveCellsIsOpenedByItsListAlone) {
  test::publishVastMap(published(), 3, [](double, double) { return 3.0; });
  const TiledMap map(published() / "map.json");
  ASSERT_EQ(map.frames().front().size.cols, test::kVastSide);
  for (int level = 0; level < static_cast<int>(map.frames().size()); ++level) {
    const GridFrame& frame = map.frames()[static_cast<std::size_t>(level)];
    const Cell middle{.col = frame.size.cols / 2, .row = frame.size.rows / 2};
    const double side = 20 * frame.spacing_mm;
    const RegionWindow window = map.window(
        at(frame.xMm(middle.col) - side / 2, frame.yMm(middle.row) - side / 2, side, level));
    EXPECT_GE(window.max_mm, 2.9F) << level;
  }
  EXPECT_EQ(map.window(at(10, 10, 200, 0)).max_mm, 0);
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  RecordProperty("peak_kB", std::to_string(used.ru_maxrss));
}

}  // namespace
}  // namespace relievo
