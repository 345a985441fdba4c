// SPDX-License-Identifier: BSD-3-Clause
#include "ui/exhibit/visit_words.h"

#include <array>
#include <optional>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

using Words = std::vector<Message>;

Words welcome(const Exhibit& exhibit) {
  Words words{said<MessageId::exhibit_welcome>(), said<MessageId::exhibit_grip>(),
              said<MessageId::exhibit_volume>()};
  if (exhibit.languages.size() > 1) {
    words.push_back(said<MessageId::exhibit_take_language>());
    words.push_back(said<MessageId::exhibit_next_language>());
  }
  return words;
}

Words ofObject(const Exhibit& exhibit, std::size_t index, const std::string& language) {
  const ExhibitObject& object = exhibit.objects[index];
  Words words{said<MessageId::exhibit_object_of>(index + 1, exhibit.objects.size(),
                                                 object.title.at(language))};
  if (const auto found = object.description.find(language); found != object.description.end()) {
    words.push_back(said<MessageId::quoted>(found->second));
  }
  words.push_back(said<MessageId::exhibit_take_object>());
  if (exhibit.objects.size() > 1) words.push_back(said<MessageId::exhibit_next_object>());
  return words;
}

/// What a button does while touching; nothing: none was pressed.
std::optional<MessageId> ofButton(VisitPress press) {
  switch (press) {
    case VisitPress::centre:
      return MessageId::exhibit_button_middle;
    case VisitPress::plus:
    case VisitPress::help:
      return MessageId::exhibit_button_plus;
    case VisitPress::minus:
      return MessageId::exhibit_button_minus;
    case VisitPress::forward:
      return MessageId::exhibit_button_forward;
    default:
      return std::nullopt;
  }
}

/// What the pressed one does, and the next one.
Words explained(const Visit::Order& order) {
  constexpr std::array<MessageId, Visit::kExplained> kButtons{
      MessageId::exhibit_button_middle, MessageId::exhibit_button_plus,
      MessageId::exhibit_button_minus, MessageId::exhibit_button_forward,
      MessageId::exhibit_button_stop};
  const MessageId next = kButtons.at(order.index);
  Words words;
  const auto pressed = ofButton(order.press);
  if (pressed && *pressed != next) words.push_back({*pressed, {}});
  if (order.index == 0) words.push_back(said<MessageId::exhibit_try_buttons>());
  words.push_back({next, {}});
  return words;
}

/// Between the opening of an object and its end.
Words whileTouching(const Visit::Order& order) {
  using Do = Visit::Do;
  switch (order.what) {
    case Do::say_homing:
      return {said<MessageId::exhibit_nothing_pulls>(), said<MessageId::exhibit_push_in>()};
    case Do::explain:
      return explained(order);
    case Do::offer_guide:
      return {said<MessageId::exhibit_offer_guide>(), said<MessageId::exhibit_offer_answer>()};
    case Do::begin_touch:
      return {said<MessageId::exhibit_hold>(), said<MessageId::exhibit_buttons>(),
              said<MessageId::exhibit_buttons_more>(), said<MessageId::exhibit_help>()};
    case Do::begin_free:
      return {said<MessageId::exhibit_touch_freely>(), said<MessageId::exhibit_help>(),
              said<MessageId::exhibit_buttons_more>()};
    case Do::say_let_go:
      return {said<MessageId::exhibit_take_grip>()};
    case Do::say_forces_off:
      return {said<MessageId::exhibit_forces_off>()};
    case Do::say_help:
      return {said<MessageId::exhibit_buttons>(), said<MessageId::exhibit_buttons_more>(),
              said<MessageId::exhibit_help_volume>(), said<MessageId::exhibit_help_again>()};
    default:
      return {};
  }
}

}  // namespace

Words visitWords(const Visit::Order& order, const Exhibit& exhibit, const std::string& language) {
  using Do = Visit::Do;
  switch (order.what) {
    case Do::welcome:
      return welcome(exhibit);
    case Do::offer_language:
      return {said<MessageId::exhibit_take_language>(), said<MessageId::exhibit_next_language>()};
    case Do::offer_object:
      return ofObject(exhibit, order.index, language);
    case Do::say_failed:
      return {said<MessageId::exhibit_object_failed>()};
    case Do::say_needs_help:
      return {said<MessageId::exhibit_needs_help>()};
    case Do::ask_still_there:
      return {said<MessageId::exhibit_still_there>()};
    case Do::say_goodbye:
      return {said<MessageId::exhibit_goodbye>()};
    default:
      return whileTouching(order);
  }
}

}  // namespace relievo
