// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace relievo::falcon {

/// A Falcon that is plugged in, as far as can be seen without opening it.
struct SeenFalcon {
  std::string serial;  ///< Of its USB bridge; empty: it has none, or the system does not tell.
  std::string port;    ///< "1-2.4": bus 1, its port 2, port 4 of the hub there.
  int bus = 0, address = 0;
  int speed_mbit = 0;
};

/// Which Falcon is meant; what is empty does not matter.
struct FalconChoice {
  std::string serial, port;
  bool any() const { return serial.empty() && port.empty(); }
  friend bool operator==(const FalconChoice&, const FalconChoice&) = default;
};

/// Of an id: "falcon" and "falcon:0" (the only one), "falcon:SERIAL", "falcon:SERIAL@PORT",
/// "falcon:@PORT". Nothing: it names none.
std::optional<FalconChoice> falconChoice(std::string_view id);
std::string idOf(const FalconChoice& choice);
/// For people, in every language: "Falcon A1 (USB 1-2)".
std::string nameOf(const FalconChoice& choice);
/// The least that tells it from the others: its serial number, with the port if another one of
/// those has the same, or if it has none.
FalconChoice shortestChoice(const SeenFalcon& falcon, std::span<const SeenFalcon> seen);

/// Finds the one that is meant and never takes another in its place. Whoever asked for any has the
/// only one that was there at first, and keeps to it.
class FalconSearch {
 public:
  explicit FalconSearch(FalconChoice choice = {}) : choice_(std::move(choice)) {}
  const FalconChoice& choice() const { return choice_; }

  struct Found {
    const SeenFalcon* falcon = nullptr;  ///< Of those given; null: none.
    bool several = false;                ///< None, because more than one could be meant.
    std::string others;  ///< If none: the names of those that are there, "B2 (USB 1-3), …".
  };
  Found among(std::span<const SeenFalcon> seen) const;
  /// This one was opened: from now on it is meant.
  void keep(const SeenFalcon& falcon);

 private:
  FalconChoice choice_;
};

}  // namespace relievo::falcon
