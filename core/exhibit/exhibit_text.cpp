// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/exhibit/exhibit.h"
#include "core/file/atomic_file.h"
#include "core/provenance/name_text.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Where a folder really is: "up" from one behind a symbolic link is not where the link lies.
fs::path realFolder(const fs::path& absolute) {
  std::error_code unknown;
  const fs::path real = fs::weakly_canonical(absolute.parent_path(), unknown);
  return unknown ? absolute.parent_path() : real;
}

/// From the folder of the exhibit, if it lies there or in the folder above.
std::string placeText(const fs::path& place, const fs::path& exhibit_file) {
  const fs::path absolute = fs::absolute(place).lexically_normal();
  const fs::path folder = realFolder(fs::absolute(exhibit_file).lexically_normal());
  const fs::path from_there =
      (realFolder(absolute) / absolute.filename()).lexically_relative(folder);
  const auto up = std::count(from_there.begin(), from_there.end(), "..");
  const bool is_near = up == 0 || (up == 1 && folder.has_relative_path());
  return textOfName((is_near ? from_there : absolute).native());
}

Json textsJson(const ExhibitTexts& texts, const std::vector<std::string>& languages) {
  Json json = Json::object();
  for (const std::string& language : languages) {
    const auto text = texts.find(language);
    json[language] = text == texts.end() ? "" : text->second;
  }
  return json;
}

bool hasWords(const ExhibitTexts& texts, const std::vector<std::string>& languages) {
  return std::any_of(languages.begin(), languages.end(), [&](const std::string& language) {
    const auto text = texts.find(language);
    return text != texts.end() && !text->second.empty();
  });
}

Json objectJson(const ExhibitObject& object, const Exhibit& exhibit) {
  Json json{{"file", object.file.empty() ? "" : placeText(object.file, exhibit.file)}};
  if (object.unit) json["unit"] = name(*object.unit);
  if (object.view) json["view"] = *object.view;
  json["title"] = textsJson(object.title, exhibit.languages);
  if (hasWords(object.description, exhibit.languages)) {
    json["description"] = textsJson(object.description, exhibit.languages);
  }
  return json;
}

Json speechJson(const ExhibitSpeech& speech) {
  Json json{{"volume_percent", speech.volume_percent},
            {"loudest_percent", speech.loudest_percent},
            {"words_per_minute", speech.words_per_minute}};
  if (speech.room_loudest_percent) json["room_loudest_percent"] = *speech.room_loudest_percent;
  return json;
}

Json touchJson(const ExhibitTouch& touch) {
  return {{"device", touch.device},
          {"strength_percent", touch.strength_percent},
          {"limit_n", touch.limit_n},
          {"introduction", touch.introduction},
          {"guide", touch.guide},
          {"sounds_percent", touch.sounds_percent},
          {"felt_patterns", touch.felt_patterns},
          {"one_button", touch.one_button}};
}

}  // namespace

std::string exhibitText(const Exhibit& exhibit) {
  Json objects = Json::array();
  for (const ExhibitObject& object : exhibit.objects) {
    objects.push_back(objectJson(object, exhibit));
  }
  const ExhibitTimes& times = exhibit.times;
  Json json{{"relievo_exhibit", 1},
            {"languages", exhibit.languages},
            {"objects", objects},
            {"idle",
             {{"still_there_s", times.still_there_s},
              {"goodbye_s", times.goodbye_s},
              {"chime_s", times.chime_s}}},
            {"speech", speechJson(exhibit.speech)},
            {"touch", touchJson(exhibit.touch)}};
  if (!exhibit.pin.salt.empty()) {
    json["staff_pin"] = {{"salt", exhibit.pin.salt}, {"sha256", exhibit.pin.sha256}};
  }
  if (!exhibit.records.empty()) json["records"] = placeText(exhibit.records, exhibit.file);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeExhibit(const Exhibit& exhibit) {
  AtomicFile file(exhibit.file);
  file.write(exhibitText(exhibit));
  file.commit();
}

}  // namespace relievo
