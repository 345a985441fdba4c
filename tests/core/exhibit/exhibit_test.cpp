// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/exhibit.h"

#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const std::vector<std::string> kKnown{"en", "de", "hi"};

class ExhibitTest : public testing::Test {
 protected:
  ExhibitTest() {
    folder_ = fs::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
    std::ofstream(folder_ / "coin.ply") << "ply";
    std::ofstream(folder_ / "panel.ply") << "ply";
    const StaffPin pin = staffPinOf("2580", "salt");
    whole_ = {{"relievo_exhibit", 1},
              {"languages", {"en", "de"}},
              {"objects",
               {{{"file", "coin.ply"},
                 {"unit", "mm"},
                 {"view", "top"},
                 {"title", {{"en", "A coin"}, {"de", "Eine Münze"}}},
                 {"description", {{"en", "Struck."}, {"de", "Geprägt."}}}},
                {{"file", "panel.ply"}, {"title", {{"en", "A panel"}, {"de", "Eine Tafel"}}}}}},
              {"idle", {{"still_there_s", 40}, {"goodbye_s", 10.5}, {"chime_s", 0}}},
              {"speech",
               {{"volume_percent", 60},
                {"loudest_percent", 80},
                {"room_loudest_percent", 55},
                {"words_per_minute", 180}}},
              {"touch",
               {{"device", "falcon"},
                {"strength_percent", 30},
                {"limit_n", 2.5},
                {"introduction", false},
                {"guide", false},
                {"sounds_percent", 0},
                {"one_button", true}}},
              {"staff_pin", {{"salt", pin.salt}, {"sha256", pin.sha256}}},
              {"records", "counted"}};
  }
  ~ExhibitTest() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "exhibit.json"; }
  void write(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }
  /// The sentences about the whole exhibit with one change.
  std::vector<std::string> faultsAfter(const std::function<void(Json&)>& change) const {
    Json changed = whole_;
    change(changed);
    write(changed.dump());
    std::vector<std::string> faults;
    for (const Message& fault : checkExhibit(file(), kKnown).faults) {
      faults.push_back(englishText(fault));
    }
    return faults;
  }
  std::string refusalOf(const std::string& text) const {
    write(text);
    try {
      readExhibit(file(), kKnown);
    } catch (const FileError& error) {
      return error.what();
    }
    return {};
  }

  fs::path folder_;
  Json whole_;
};

TEST_F(ExhibitTest, ItIsReadAsItIsWritten) {
  write(whole_.dump());
  const Exhibit e = readExhibit(file(), kKnown);
  EXPECT_EQ(e.languages, (std::vector<std::string>{"en", "de"}));
  ASSERT_EQ(e.objects.size(), 2U);
  EXPECT_EQ(e.objects[0].file, folder_ / "coin.ply") << "from the folder of the exhibit";
  EXPECT_EQ(e.objects[0].id, "coin");
  EXPECT_EQ(e.objects[0].unit, LengthUnit::mm);
  EXPECT_EQ(e.objects[0].view, "top");
  EXPECT_EQ(e.objects[0].title.at("de"), "Eine Münze");
  EXPECT_EQ(e.objects[0].description.at("en"), "Struck.");
  EXPECT_TRUE(e.objects[1].description.empty());
  EXPECT_EQ(e.times.still_there_s, 40);
  EXPECT_EQ(e.times.goodbye_s, 10.5);
  EXPECT_EQ(e.times.chime_s, 0);
  EXPECT_EQ(e.speech.volume_percent, 60);
  EXPECT_EQ(e.speech.loudest_percent, 80);
  EXPECT_EQ(e.speech.room_loudest_percent, 55);
  EXPECT_EQ(e.speech.words_per_minute, 180);
  EXPECT_EQ(e.touch.device, "falcon");
  EXPECT_EQ(e.touch.strength_percent, 30);
  EXPECT_EQ(e.touch.limit_n, 2.5);
  EXPECT_FALSE(e.touch.introduction);
  EXPECT_FALSE(e.touch.guide);
  EXPECT_EQ(e.touch.sounds_percent, 0);
  EXPECT_TRUE(e.touch.one_button);
  EXPECT_EQ(recordsFolder(e), folder_ / "counted");
}

TEST_F(ExhibitTest, WhatMayBeLeftOutHasDefaults) {
  for (const char* key : {"idle", "speech", "touch", "records"}) whole_.erase(key);
  write(whole_.dump());
  const Exhibit e = readExhibit(file(), kKnown);
  EXPECT_EQ(e.times.still_there_s, 60);
  EXPECT_EQ(e.times.goodbye_s, 15);
  EXPECT_EQ(e.times.chime_s, 45);
  EXPECT_FALSE(e.speech.room_loudest_percent);
  EXPECT_EQ(e.touch.strength_percent, 40);
  EXPECT_EQ(e.touch.limit_n, 4);
  EXPECT_TRUE(e.touch.introduction);
  EXPECT_TRUE(e.touch.guide);
  EXPECT_EQ(e.touch.sounds_percent, 50);
  EXPECT_EQ(recordsFolder(e).filename(), "exhibit");
}

TEST_F(ExhibitTest, TwoObjectsOfOneNameAreCountedApart) {
  whole_["objects"][1]["file"] = "./coin.ply";
  write(whole_.dump());
  EXPECT_EQ(readExhibit(file(), kKnown).objects[1].id, "coin-2");
}

struct Fault {
  const char* what;
  std::function<void(Json&)> change;
  const char* sentence;
};

TEST_F(ExhibitTest, EachFaultIsOneSentenceThatNamesItsPlace) {
  const std::vector<Fault> faults{
      {"no languages", [](Json& j) { j.erase("languages"); }, "languages is missing."},
      {"a misspelt key", [](Json& j) { j["langauges"] = 1; },
       "langauges means nothing here. There are relievo_exhibit, languages, "},
      {"a key of an object", [](Json& j) { j["objects"][0]["Title"] = 1; },
       "objects[0].Title means nothing here. There are file, unit, view, title, description."},
      {"languages as a text", [](Json& j) { j["languages"] = "en"; },
       "languages must be a list in square brackets."},
      {"an unknown language", [](Json& j) { j["languages"].push_back("fr"); },
       "languages[2]: relievo does not speak 'fr'. It speaks en, de, hi."},
      {"a language twice", [](Json& j) { j["languages"].push_back("en"); },
       "languages[2]: 'en' stands there twice."},
      {"a number as language", [](Json& j) { j["languages"].push_back(3); },
       "languages[2] must be a text."},
      {"a word for yes", [](Json& j) { j["touch"]["guide"] = "yes"; },
       "touch.guide must be true or false."},
      {"forces beyond the loop's", [](Json& j) { j["touch"]["limit_n"] = 9; },
       "touch.limit_n is 9; it must be from 0.5 to 6"},
      {"no objects", [](Json& j) { j["objects"] = Json::array(); }, "objects is empty."},
      {"too many objects", [](Json& j) { j["objects"] = Json(51, j["objects"][0]); },
       "objects has 51 entries; it can have 50."},
      {"an object that is none", [](Json& j) { j["objects"][1] = "coin.ply"; },
       "objects[1] must be a group in braces."},
      {"a file that is not there", [](Json& j) { j["objects"][1]["file"] = "gone.ply"; },
       "objects[1].file: there is no file "},
      {"a folder as file", [](Json& j) { j["objects"][1]["file"] = "."; },
       "objects[1].file: there is no file "},
      {"an unknown unit", [](Json& j) { j["objects"][0]["unit"] = "inch"; },
       "objects[0].unit: there is no 'inch'; there are mm, cm, m, in, ft, us-ft."},
      {"an unknown view", [](Json& j) { j["objects"][0]["view"] = "above"; },
       "objects[0].view: there is no 'above'; there are front, back"},
      {"no title in a language", [](Json& j) { j["objects"][0]["title"].erase("de"); },
       "objects[0].title has no text for the language 'de'."},
      {"a title of another language", [](Json& j) { j["objects"][0]["title"]["hi"] = "x"; },
       "objects[0].title has a text for 'hi', which is none of the exhibit's languages (en, de)."},
      {"a title without words", [](Json& j) { j["objects"][0]["title"]["de"] = " "; },
       "objects[0].title.de has no words."},
      {"a long title",
       [](Json& j) { j["objects"][0]["title"]["en"] = "1 2 3 4 5 6 7 8 9 10 11 12 13"; },
       "objects[0].title.en has 13 words; it can have 12."},
      {"a title as text", [](Json& j) { j["objects"][0]["title"] = "Coin"; },
       "objects[0].title must be a group in braces."},
      {"a description in one language", [](Json& j) { j["objects"][0]["description"].erase("en"); },
       "objects[0].description has no text for the language 'en'."},
      {"a time out of range", [](Json& j) { j["idle"]["still_there_s"] = 9; },
       "idle.still_there_s is 9; it must be from 10 to 600."},
      {"a time as text", [](Json& j) { j["idle"]["goodbye_s"] = "5"; },
       "idle.goodbye_s must be a number."},
      {"a volume that is not whole", [](Json& j) { j["speech"]["volume_percent"] = 50.5; },
       "speech.volume_percent must be a whole number."},
      {"a room that bears more than ears",
       [](Json& j) { j["speech"]["room_loudest_percent"] = 90; },
       "speech.room_loudest_percent is 90, above speech.loudest_percent, which is 80."},
      {"louder than the loudest", [](Json& j) { j["speech"]["volume_percent"] = 90; },
       "speech.volume_percent is 90, above speech.loudest_percent, which is 80."},
      {"no strength", [](Json& j) { j["touch"]["strength_percent"] = 0; },
       "touch.strength_percent is 0; it must be from 1 to 100."},
      {"no PIN", [](Json& j) { j.erase("staff_pin"); }, "staff_pin is missing."},
      {"a PIN in clear", [](Json& j) { j["staff_pin"]["sha256"] = "2580"; },
       "staff_pin must hold a salt of up to 64 characters and 64 hexadecimal digits."},
      {"no salt", [](Json& j) { j["staff_pin"].erase("salt"); }, "staff_pin.salt is missing."},
      {"records as a number", [](Json& j) { j["records"] = 1; }, "records must be a text."}};
  for (const Fault& fault : faults) {
    const auto sentences = faultsAfter(fault.change);
    ASSERT_EQ(sentences.size(), 1U) << fault.what << ": " << testing::PrintToString(sentences);
    EXPECT_THAT(sentences.front(), HasSubstr(fault.sentence)) << fault.what;
  }
}

TEST_F(ExhibitTest, WhatIsWrittenIsReadAgain) {
  write(whole_.dump());
  Exhibit e = readExhibit(file(), kKnown);
  fs::create_directories(folder_ / "moved");
  e.file = folder_ / "moved/exhibit.json";
  e.records = "/var/lib/counts";
  writeExhibit(e);
  std::ifstream in(e.file);
  const Json written = Json::parse(in);
  EXPECT_EQ(written["objects"][0]["file"], "../coin.ply") << "both can be moved together";
  EXPECT_EQ(written["records"], "/var/lib/counts");
  Json before = whole_, after = written;
  for (Json* one : {&before, &after}) {
    one->erase("records");
    for (Json& object : (*one)["objects"]) object.erase("file");
    (*one)["touch"].erase("felt_patterns");  // Not said before, and false.
  }
  EXPECT_EQ(nlohmann::json(before), nlohmann::json(after));
  EXPECT_EQ(exhibitText(readExhibit(e.file, kKnown)), exhibitText(e));
}

TEST_F(ExhibitTest, AFolderBehindALinkFindsItsObjects) {
  write(whole_.dump());
  Exhibit e = readExhibit(file(), kKnown);
  fs::create_directories(folder_ / "disk/museum");
  std::ofstream(folder_ / "disk/near.ply") << "ply";
  fs::create_directory_symlink(folder_ / "disk/museum", folder_ / "link");
  e.objects[1].file = folder_ / "disk/near.ply";
  e.file = folder_ / "link/exhibit.json";
  writeExhibit(e);
  const Exhibit read = readExhibit(e.file, kKnown);  // Throws where one is not found.
  EXPECT_TRUE(fs::equivalent(read.objects[0].file, folder_ / "coin.ply"))
      << "beside the link, not beside what it leads to: " << read.objects[0].file;
  EXPECT_EQ(read.objects[1].file, folder_ / "link/../near.ply");
}

TEST_F(ExhibitTest, WhatIsWrongIsWrittenAndFound) {
  Exhibit e;
  e.file = file();
  e.languages = {"de"};
  e.objects.resize(2);
  e.objects[0].file = folder_ / "gone.ply";
  e.objects[0].title = {{"en", "A coin"}};
  e.speech.loudest_percent = 50;
  std::vector<std::string> faults;
  for (const Message& fault : checkExhibitText(exhibitText(e), e.file, kKnown).faults) {
    faults.push_back(englishText(fault));
  }
  EXPECT_THAT(faults, testing::UnorderedElementsAre(
                          HasSubstr("objects[0].file: there is no file"),
                          "objects[0].title.de has no words.", "objects[1].file has no words.",
                          "objects[1].title.de has no words.",
                          "speech.volume_percent is 70, above speech.loudest_percent, which is 50.",
                          "staff_pin is missing."));
}

TEST_F(ExhibitTest, EachNewPinHasASaltOfItsOwn) {
  const StaffPin one = newStaffPin("2580"), other = newStaffPin("2580");
  EXPECT_NE(one.salt, other.salt);
  EXPECT_EQ(one.sha256, staffPinOf("2580", one.salt).sha256);
}

TEST_F(ExhibitTest, AllFaultsAreSaidTogether) {
  const auto faults = faultsAfter([](Json& j) {
    j["languages"].push_back("fr");
    j["objects"][1]["file"] = "gone.ply";
    j["speech"]["loudest_percent"] = 500;
  });
  EXPECT_EQ(faults.size(), 3U) << testing::PrintToString(faults);
  std::ifstream in(file());
  const std::string written{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(refusalOf(written),
              testing::AllOf(HasSubstr("exhibit.json cannot be shown as an exhibit. languages[2]"),
                             HasSubstr("objects[1].file"), HasSubstr("speech.loudest_percent")));
}

TEST_F(ExhibitTest, WhatIsNoExhibitIsRefusedAtOnce) {
  EXPECT_EQ(refusalOf("{\n\"relievo_exhibit\": 1,\n,}"),
            "exhibit.json is not JSON: line 3 cannot be read.");
  EXPECT_THAT(refusalOf("[]"), HasSubstr("exhibit.json is no exhibit"));
  EXPECT_THAT(refusalOf("{}"), HasSubstr("exhibit.json is no exhibit"));
  EXPECT_THAT(refusalOf("{\"relievo_exhibit\": 2}"),
              HasSubstr("is an exhibit of version 2. This program reads version 1."));
  EXPECT_THAT(refusalOf("{\"relievo_exhibit\": \"1\"}"), HasSubstr("is an exhibit of version"));
  EXPECT_THAT(refusalOf(std::string(1000, '[')), HasSubstr("exhibit.json is no exhibit"));
  fs::remove(file());
  EXPECT_THROW(readExhibit(file(), kKnown), FileError);
}

}  // namespace
}  // namespace relievo
