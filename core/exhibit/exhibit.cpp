// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/exhibit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string_view>

#include "core/base/failure.h"
#include "core/base/json_nesting.h"
#include "core/depth/view.h"
#include "core/io/file_check.h"
#include "core/io/formats/text_file.h"
#include "core/provenance/name_text.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 1U << 20U;
constexpr int kDeepest = 16;
constexpr int kSchema = 1;
constexpr std::size_t kMostSalt = 64, kMostDevice = 64;
constexpr std::size_t kChecksumDigits = 64;

std::string listOf(std::span<const std::string_view> words) {
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  return list;
}

std::string listOf(std::span<const std::string> words) {
  const std::vector<std::string_view> views(words.begin(), words.end());
  return listOf(std::span<const std::string_view>(views));
}

std::size_t wordsIn(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  std::size_t count = 0;
  while (words >> word) ++count;
  return count;
}

/// "10" and "0.5".
std::string shortNumber(double number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

/// Reads what a file says and notes what is wrong with it; a place that is wrong keeps its default.
class Reader {
 public:
  Reader(const fs::path& file, std::span<const std::string> known_languages)
      : known_languages_(known_languages) {
    check_.exhibit.file = file;
  }

  ExhibitCheck read(const Json& json) {
    knowsOnly(json, "",
              {"relievo_exhibit", "languages", "objects", "idle", "speech", "touch", "staff_pin",
               "records"});
    readLanguages(json);
    readObjects(json);
    if (const Json* idle = part(json, "", "idle", false)) readIdle(*idle);
    if (const Json* speech = part(json, "", "speech", false)) readSpeech(*speech);
    if (const Json* touch = part(json, "", "touch", false)) readTouch(*touch);
    if (const Json* pin = part(json, "", "staff_pin", true)) readPin(*pin);
    std::string records;
    if (text(json, "", "records", false, records)) check_.exhibit.records = placeOf(records);
    return std::move(check_);
  }

 private:
  enum class Kind { text, number, whole, truth, list, object };

  template <MessageId id, class... Given>
  void note(Given&&... given) {
    check_.faults.push_back(said<id>(std::forward<Given>(given)...));
  }

  static std::string inside(const std::string& place, const std::string& key) {
    return place.empty() ? key : place + "." + key;
  }

  void knowsOnly(const Json& json, const std::string& place,
                 std::initializer_list<std::string_view> known) {
    for (const auto& [key, value] : json.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      note<MessageId::exhibit_key_unknown>(
          escapedName(inside(place, key)),
          listOf(std::span<const std::string_view>(known.begin(), known.size())));
    }
  }

  static Message kindWords(Kind kind) {
    switch (kind) {
      case Kind::text:
        return said<MessageId::exhibit_kind_text>();
      case Kind::number:
        return said<MessageId::exhibit_kind_number>();
      case Kind::whole:
        return said<MessageId::exhibit_kind_whole>();
      case Kind::truth:
        return said<MessageId::exhibit_kind_truth>();
      case Kind::list:
        return said<MessageId::exhibit_kind_list>();
      case Kind::object:
        break;
    }
    return said<MessageId::exhibit_kind_object>();
  }

  static bool is(const Json& json, Kind kind) {
    switch (kind) {
      case Kind::text:
        return json.is_string();
      case Kind::number:
        return json.is_number();
      case Kind::whole:
        return json.is_number_integer();
      case Kind::truth:
        return json.is_boolean();
      case Kind::list:
        return json.is_array();
      case Kind::object:
        break;
    }
    return json.is_object();
  }

  /// What stands at a key; null: nothing, or something else, which is noted.
  const Json* value(const Json& json, const std::string& place, const char* key, bool required,
                    Kind kind) {
    const auto found = json.find(key);
    if (found == json.end()) {
      if (required) note<MessageId::exhibit_key_missing>(inside(place, key));
      return nullptr;
    }
    if (is(*found, kind)) return &*found;
    note<MessageId::exhibit_wrong_kind>(inside(place, key), WordsArgument(kindWords(kind)));
    return nullptr;
  }

  const Json* part(const Json& json, const std::string& place, const char* key, bool required) {
    return value(json, place, key, required, Kind::object);
  }

  bool text(const Json& json, const std::string& place, const char* key, bool required,
            std::string& into) {
    const Json* found = value(json, place, key, required, Kind::text);
    if (found == nullptr) return false;
    into = found->get<std::string>();
    if (wordsIn(into) > 0) return true;
    note<MessageId::exhibit_text_empty>(inside(place, key));
    return false;
  }

  void truth(const Json& json, const std::string& place, const char* key, bool& into) {
    if (const Json* found = value(json, place, key, false, Kind::truth)) into = found->get<bool>();
  }

  template <class Number>
  void number(const Json& json, const std::string& place, const char* key, double least,
              double most, Number& into) {
    constexpr Kind kKind = std::is_integral_v<Number> ? Kind::whole : Kind::number;
    const Json* found = value(json, place, key, false, kKind);
    if (found == nullptr) return;
    const double given = found->get<double>();
    if (!(given >= least && given <= most)) {
      note<MessageId::exhibit_out_of_range>(inside(place, key), found->dump(), shortNumber(least),
                                            shortNumber(most));
      return;
    }
    into = static_cast<Number>(given);
  }

  fs::path placeOf(const std::string& name) const {
    const fs::path given = nameFromText(name);
    const fs::path folder = check_.exhibit.file.parent_path();
    return given.is_absolute() || folder.empty() ? given : folder / given;
  }

  void readLanguages(const Json& json) {
    const Json* list = value(json, "", "languages", true, Kind::list);
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
      const Json& entry = (*list)[i];
      const std::string place = "languages[" + std::to_string(i) + "]";
      if (!entry.is_string()) {
        note<MessageId::exhibit_wrong_kind>(place, WordsArgument(kindWords(Kind::text)));
        continue;
      }
      const auto tag = entry.get<std::string>();
      auto& languages = check_.exhibit.languages;
      if (std::find(known_languages_.begin(), known_languages_.end(), tag) ==
          known_languages_.end()) {
        note<MessageId::exhibit_language_unknown>(place, escapedName(tag),
                                                  listOf(known_languages_));
      } else if (std::find(languages.begin(), languages.end(), tag) != languages.end()) {
        note<MessageId::exhibit_twice>(place, tag);
      } else {
        languages.push_back(tag);
      }
    }
    if (list->empty()) note<MessageId::exhibit_list_empty>("languages");
  }

  void readObjects(const Json& json) {
    const Json* list = value(json, "", "objects", true, Kind::list);
    if (list == nullptr) return;
    if (list->empty()) note<MessageId::exhibit_list_empty>("objects");
    if (list->size() > kMostExhibitObjects) {
      note<MessageId::exhibit_list_long>("objects", list->size(), kMostExhibitObjects);
      return;
    }
    std::set<std::string> ids;
    for (std::size_t i = 0; i < list->size(); ++i) {
      const std::string place = "objects[" + std::to_string(i) + "]";
      const Json& entry = (*list)[i];
      if (!entry.is_object()) {
        note<MessageId::exhibit_wrong_kind>(place, WordsArgument(kindWords(Kind::object)));
        continue;
      }
      ExhibitObject object = objectFrom(entry, place);
      // Counts of two objects must not become one.
      const std::string stem = object.id;
      for (int n = 2; !ids.insert(object.id).second; ++n)
        object.id = stem + "-" + std::to_string(n);
      check_.exhibit.objects.push_back(std::move(object));
    }
  }

  ExhibitObject objectFrom(const Json& json, const std::string& place) {
    knowsOnly(json, place, {"file", "unit", "view", "title", "description"});
    ExhibitObject object;
    std::string given;
    if (text(json, place, "file", true, given)) {
      object.file = placeOf(given);
      object.id = escapedName(object.file.stem().string());
      std::error_code unknown;
      if (!fs::is_regular_file(object.file, unknown)) {
        note<MessageId::exhibit_file_missing>(inside(place, "file"), PathArgument(object.file));
      }
    }
    if (text(json, place, "unit", false, given)) {
      object.unit = lengthUnit(given);
      if (!object.unit) {
        note<MessageId::exhibit_none_of>(inside(place, "unit"), escapedName(given),
                                         "mm, cm, m, in, ft, us-ft");
      }
    }
    if (text(json, place, "view", false, given)) {
      if (std::find(kViewNames.begin(), kViewNames.end(), given) == kViewNames.end()) {
        note<MessageId::exhibit_none_of>(inside(place, "view"), escapedName(given),
                                         listOf(std::span<const std::string_view>(kViewNames)));
      } else {
        object.view = given;
      }
    }
    object.title = textsFrom(json, place, "title", true, kMostTitleWords);
    object.description = textsFrom(json, place, "description", false, kMostDescriptionWords);
    return object;
  }

  ExhibitTexts textsFrom(const Json& json, const std::string& place, const char* key, bool required,
                         int most_words) {
    ExhibitTexts texts;
    const Json* found = part(json, place, key, required);
    if (found == nullptr) return texts;
    const std::string here = inside(place, key);
    const auto& languages = check_.exhibit.languages;
    if (languages.empty()) return texts;  // That is said already, once.
    for (const auto& [tag, entry] : found->items()) {
      if (std::find(languages.begin(), languages.end(), tag) == languages.end()) {
        note<MessageId::exhibit_text_of_other>(here, escapedName(tag), listOf(languages));
      }
    }
    for (const std::string& tag : languages) {
      if (!found->contains(tag)) {
        note<MessageId::exhibit_text_missing>(here, tag);
        continue;
      }
      std::string words;
      if (!text(*found, here, tag.c_str(), true, words)) continue;
      const std::size_t count = wordsIn(words);
      if (count > static_cast<std::size_t>(most_words)) {
        note<MessageId::exhibit_text_long>(inside(here, tag), count, most_words);
      }
      texts[tag] = std::move(words);
    }
    return texts;
  }

  void readIdle(const Json& json) {
    constexpr double kLeastStill = 10, kMostStill = 600, kLeastBye = 5, kMostBye = 120;
    constexpr double kLeastChime = 10, kMostChime = 3600;
    knowsOnly(json, "idle", {"still_there_s", "goodbye_s", "chime_s"});
    ExhibitTimes& times = check_.exhibit.times;
    number(json, "idle", "still_there_s", kLeastStill, kMostStill, times.still_there_s);
    number(json, "idle", "goodbye_s", kLeastBye, kMostBye, times.goodbye_s);
    const auto chime = json.find("chime_s");
    if (chime != json.end() && *chime == 0) {
      times.chime_s = 0;
    } else {
      number(json, "idle", "chime_s", kLeastChime, kMostChime, times.chime_s);
    }
  }

  void readSpeech(const Json& json) {
    constexpr double kLeastVolume = 10, kMostVolume = 100, kSlowest = 100, kFastest = 449;
    knowsOnly(json, "speech",
              {"volume_percent", "loudest_percent", "room_loudest_percent", "words_per_minute"});
    ExhibitSpeech& speech = check_.exhibit.speech;
    number(json, "speech", "volume_percent", kLeastVolume, kMostVolume, speech.volume_percent);
    number(json, "speech", "loudest_percent", kLeastVolume, kMostVolume, speech.loudest_percent);
    if (json.contains("room_loudest_percent")) {
      int& room = speech.room_loudest_percent.emplace(speech.loudest_percent);
      number(json, "speech", "room_loudest_percent", kLeastVolume, kMostVolume, room);
      if (room > speech.loudest_percent) {
        note<MessageId::exhibit_too_loud>("speech.room_loudest_percent", room,
                                          "speech.loudest_percent", speech.loudest_percent);
      }
    }
    number(json, "speech", "words_per_minute", kSlowest, kFastest, speech.words_per_minute);
    if (speech.volume_percent > speech.loudest_percent) {
      note<MessageId::exhibit_too_loud>("speech.volume_percent", speech.volume_percent,
                                        "speech.loudest_percent", speech.loudest_percent);
    }
  }

  void readTouch(const Json& json) {
    constexpr double kMostPercent = 100, kLeastLimit = 0.5, kMostLimit = 6;
    knowsOnly(json, "touch",
              {"device", "strength_percent", "limit_n", "introduction", "guide", "sounds_percent",
               "felt_patterns", "one_button"});
    ExhibitTouch& touch = check_.exhibit.touch;
    if (text(json, "touch", "device", false, touch.device) && touch.device.size() > kMostDevice) {
      note<MessageId::exhibit_text_long>("touch.device", touch.device.size(), kMostDevice);
    }
    number(json, "touch", "strength_percent", 1, kMostPercent, touch.strength_percent);
    number(json, "touch", "limit_n", kLeastLimit, kMostLimit, touch.limit_n);
    truth(json, "touch", "introduction", touch.introduction);
    truth(json, "touch", "guide", touch.guide);
    truth(json, "touch", "felt_patterns", touch.felt_patterns);
    truth(json, "touch", "one_button", touch.one_button);
    number(json, "touch", "sounds_percent", 0, kMostPercent, touch.sounds_percent);
  }

  void readPin(const Json& json) {
    knowsOnly(json, "staff_pin", {"salt", "sha256"});
    StaffPin& pin = check_.exhibit.pin;
    const bool has_salt = text(json, "staff_pin", "salt", true, pin.salt);
    const bool has_sum = text(json, "staff_pin", "sha256", true, pin.sha256);
    const bool is_hex = std::all_of(pin.sha256.begin(), pin.sha256.end(), [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
    });
    if ((has_salt && pin.salt.size() > kMostSalt) ||
        (has_sum && (!is_hex || pin.sha256.size() != kChecksumDigits))) {
      note<MessageId::exhibit_pin_form>();
    }
  }

  std::span<const std::string> known_languages_;
  ExhibitCheck check_;
};

}  // namespace

ExhibitCheck checkExhibit(const fs::path& file, std::span<const std::string> known_languages) {
  return checkExhibitText(readTextFile(file, kMostBytes), file, known_languages);
}

ExhibitCheck checkExhibitText(const std::string& text, const fs::path& file,
                              std::span<const std::string> known_languages) {
  const std::string name = shownName(file);
  if (isNestedDeeper(text, kDeepest)) throw failure<MessageId::exhibit_none>(name);
  Json json;
  try {
    json = Json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::string_view before =
        std::string_view(text).substr(0, std::max<std::size_t>(error.byte, 1) - 1);
    throw failure<MessageId::exhibit_no_json>(name,
                                              1 + std::count(before.begin(), before.end(), '\n'));
  }
  const auto schema = json.is_object() ? json.find("relievo_exhibit") : json.end();
  if (!json.is_object() || schema == json.end()) throw failure<MessageId::exhibit_none>(name);
  if (!schema->is_number_integer() || *schema != kSchema) {
    throw failure<MessageId::exhibit_of_another_version>(name, printable(schema->dump()));
  }
  return Reader(file, known_languages).read(json);
}

Exhibit readExhibit(const fs::path& file, std::span<const std::string> known_languages) {
  ExhibitCheck check = checkExhibit(file, known_languages);
  if (check.faults.empty()) return std::move(check.exhibit);
  throw failure<MessageId::exhibit_faults>(shownName(file),
                                           WordsArgument::sentences(std::move(check.faults)));
}

fs::path recordsFolder(const Exhibit& exhibit) {
  if (!exhibit.records.empty()) return exhibit.records;
  const auto folderOf = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value == nullptr ? "" : value);
  };
  // As the XDG specification asks, a relative one is ignored.
  const fs::path state = folderOf("XDG_STATE_HOME");
  return (state.is_absolute() ? state : folderOf("HOME") / ".local/state") / "relievo" / "exhibit";
}

}  // namespace relievo
