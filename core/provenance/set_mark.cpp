// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/set_mark.h"

#include <nlohmann/json.hpp>

#include "core/base/failure.h"
#include "core/hash/sha256.h"
#include "core/provenance/parameters_json.h"

namespace relievo {
namespace {

constexpr const char* kSet = "set";
constexpr const char* kCaption = "caption_sha256";

Json parsedState(std::string_view state, const std::string& source) {
  try {
    return parsedJson(state);
  } catch (const Json::exception&) {
    throw failure<MessageId::embedded_state_damaged>(source);
  } catch (const FileError&) {  // Nested too deep.
    throw failure<MessageId::embedded_state_damaged>(source);
  }
}

/// A member that is an object; else an empty one.
Json objectIn(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at != json.end() && at->is_object() ? *at : Json::object();
}

std::string textIn(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at != json.end() && at->is_string() ? at->get<std::string>() : std::string();
}

}  // namespace

SetMark setMark(std::string_view shared, std::string_view caption) {
  return {.id = sha256OfText(shared),
          .caption_sha256 = caption.empty() ? std::string() : sha256OfText(caption)};
}

std::string markedMade(std::string_view made, const SetMark& mark) {
  Json json = made.empty() ? Json::object() : Json::parse(made);
  json[kSet] = {{"id", mark.id}};
  if (!mark.caption_sha256.empty()) json[kSet][kCaption] = mark.caption_sha256;
  return json.dump();
}

SetMark markIn(std::string_view state, const std::string& source) {
  const Json json = parsedState(state, source);
  if (!json.is_object()) return {};
  const Json mark = objectIn(objectIn(json, "made"), kSet);
  return {.id = textIn(mark, "id"), .caption_sha256 = textIn(mark, kCaption)};
}

}  // namespace relievo
