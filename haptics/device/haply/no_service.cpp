// SPDX-License-Identifier: BSD-3-Clause
// Instead of beast_service.cpp, in a build without Boost.
#include "core/base/failure.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::haply {

namespace {
class NoService : public Service {
 public:
  std::string address() const override { return {}; }
  Connection connect(const std::stop_token& /*stop*/) override {
    throw failure<MessageId::haply_not_built>();
  }
  std::int64_t now() const override { return monotonicNs(); }
  void sleepUntil(std::int64_t time_ns) override { relievo::sleepUntil(time_ns); }
};
}  // namespace

std::unique_ptr<Service> inverseService(ServiceAddress /*address*/) {
  return std::make_unique<NoService>();
}

std::unique_ptr<Port> eventPort(const ServiceAddress& /*address*/,
                                const std::stop_token& /*stop*/) {
  return nullptr;
}

bool hasInverseService() {
  return false;
}

}  // namespace relievo::haply
