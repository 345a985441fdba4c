// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "tests/emulator/haply/haply_world.h"

namespace relievo::emulator {

/// The mock Inverse Service on a port of this computer: GET /version, and sessions by WebSocket.
/// Time goes on by itself: an order that is not renewed ends, as does one whose session closes.
class InverseService {
 public:
  /// @param port  0: any that is free; `events_port` likewise  @throw std::exception  it is taken
  explicit InverseService(std::uint16_t port = 0, std::uint16_t events_port = 0);
  ~InverseService();  ///< All threads are joined on return.
  InverseService(const InverseService&) = delete;
  InverseService& operator=(const InverseService&) = delete;

  std::uint16_t port() const;
  std::uint16_t eventsPort() const;  ///< Of its channel of events, which only tells.
  /// Alone with the world. [any thread]
  template <class Act>
  decltype(auto) with(Act act) {
    const Alone alone(*this);
    return act(world());
  }

 private:
  struct Impl;
  class Alone {
   public:
    explicit Alone(InverseService& service);
    ~Alone();
    Alone(const Alone&) = delete;
    Alone& operator=(const Alone&) = delete;

   private:
    InverseService& service_;
  };
  HaplyWorld& world();

  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo::emulator
