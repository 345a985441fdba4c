// SPDX-License-Identifier: BSD-3-Clause
// The session by WebSocket with a mock of the service on a port of this computer. How long things
// take is no matter here: the link is judged on a made-up clock (link_test).
#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "haptics/device/haply/haply_device.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/emulator/haply/inverse_service.h"

namespace relievo::haply {
namespace {

using emulator::HaplyFault;
using emulator::HaplyWorld;
using emulator::InverseService;

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kLong = 60'000 * kMs;  // For what hangs.

std::unique_ptr<Service> serviceAt(std::uint16_t port) {
  ServiceAddress address = *addressOf(std::to_string(port));
  address.patience_ns = kLong;
  return inverseService(std::move(address));
}

/// Descriptors of this process that are connected to that port.
std::vector<int> connectionsTo(std::uint16_t port) {
  std::vector<int> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int descriptor = std::stoi(entry.path().filename().string());
    sockaddr_in there{};
    socklen_t size = sizeof there;
    if (::getpeername(descriptor, reinterpret_cast<sockaddr*>(&there), &size) == 0 &&
        there.sin_family == AF_INET && ntohs(there.sin_port) == port) {
      found.push_back(descriptor);
    }
  }
  return found;
}

/// A port that is given to nobody else while no service listens there.
class HeldPort {
 public:
  HeldPort() {
    const int on = 1;
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof here;
    auto* const address = reinterpret_cast<sockaddr*>(&here);
    EXPECT_EQ(::setsockopt(descriptor_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on), 0);
    EXPECT_EQ(::bind(descriptor_, address, size), 0);
    EXPECT_EQ(::getsockname(descriptor_, address, &size), 0);
    port_ = ntohs(here.sin_port);
  }
  ~HeldPort() { ::close(descriptor_); }
  HeldPort(const HeldPort&) = delete;
  HeldPort& operator=(const HeldPort&) = delete;
  std::uint16_t port() const { return port_; }

 private:
  int descriptor_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  std::uint16_t port_ = 0;
};

class HaplySocket : public testing::Test {
 protected:
  InverseService mock_;
  std::unique_ptr<Service> service_ = serviceAt(mock_.port());

  void plant(HaplyFault fault) {
    mock_.with([&](HaplyWorld& world) { world.fault = fault; });
  }
  double shownN() {
    return mock_.with([](HaplyWorld& world) {
      return std::hypot(world.force()[0], world.force()[1], world.force()[2]);
    });
  }
  /// The mock takes what was sent when the computer lets it. @return false: it never was
  bool endsAtZero() {
    const std::int64_t give_up = monotonicNs() + kLong;
    while (shownN() > 0 && monotonicNs() < give_up) sleepUntil(monotonicNs() + kMs);
    return shownN() == 0;
  }
  /// Orders a force every millisecond until something is true. @return false: it never was
  static bool orderUntil(HaplyDevice& device, DeviceN force, const std::function<bool()>& done) {
    const std::int64_t give_up = monotonicNs() + kLong;
    for (std::int64_t now = monotonicNs(); now < give_up; now = monotonicNs()) {
      device.read(now);
      device.send(force, now);
      if (done()) return true;
      sleepUntil(now + kMs);
    }
    return false;
  }
};

TEST_F(HaplySocket, TellsItsVersionAndItsInventory) {
  Inventory inventory = lookAround(*service_, {});
  ASSERT_EQ(inventory.state, LinkState::ready);
  EXPECT_EQ(inventory.version.text.view(), "3.5.0.0");
  ASSERT_EQ(inventory.seen.told().size(), 1U);
  EXPECT_EQ(inventory.seen.told()[0].id.view(), "049D");
  EXPECT_EQ(service_->address(), "127.0.0.1:" + std::to_string(mock_.port()));
}

TEST_F(HaplySocket, AnswersOnceForEveryMessage) {
  Inventory inventory = lookAround(*service_, {});
  ASSERT_TRUE(inventory.port);
  MessageWriter writer;
  ServiceState state;
  for (int i = 0; i < 100; ++i) {
    const auto text = writer.question(inventory.seen.told()[0], i % 10 == 0);
    ASSERT_EQ(inventory.port->send(text, monotonicNs() + kLong), PortResult::ok);
    const Port::Incoming in = inventory.port->receive(monotonicNs() + kLong);
    ASSERT_EQ(in.result, PortResult::ok);
    ASSERT_TRUE(readState(in.text, state)) << in.text;
    EXPECT_EQ(state.told()[0].has_configuration, i % 10 == 0);
  }
  EXPECT_EQ(inventory.port->receive(monotonicNs()).result, PortResult::timeout) << "and no more";
}

TEST_F(HaplySocket, AnAnswerThatIsLateIsKept) {
  Inventory inventory = lookAround(*service_, {});
  ASSERT_TRUE(inventory.port);
  plant(HaplyFault::late_30_ms);
  MessageWriter writer;
  const auto text = writer.question(inventory.seen.told()[0], false);
  ASSERT_EQ(inventory.port->send(text, monotonicNs() + kLong), PortResult::ok);
  EXPECT_EQ(inventory.port->receive(monotonicNs()).result, PortResult::timeout);
  EXPECT_EQ(inventory.port->receive(monotonicNs() + kLong).result, PortResult::ok);
}

/// A browser that shows the manual may live longer than this program.
TEST_F(HaplySocket, ProgramsThatAreStartedMeanwhileDoNotInheritTheSession) {
  const Inventory inventory = lookAround(*service_, {});
  ASSERT_TRUE(inventory.port);
  const std::vector<int> sessions = connectionsTo(mock_.port());
  ASSERT_EQ(sessions.size(), 1U);
  EXPECT_EQ(::fcntl(sessions[0], F_GETFD) & FD_CLOEXEC, FD_CLOEXEC);
}

TEST_F(HaplySocket, ASessionEndsWhoeverElseHoldsIt) {
  Inventory inventory = lookAround(*service_, {});
  ASSERT_TRUE(inventory.port);
  const std::vector<int> sessions = connectionsTo(mock_.port());
  ASSERT_EQ(sessions.size(), 1U);
  const int held = ::dup(sessions[0]);
  plant(HaplyFault::huge_frame);  // Then no goodbye is said.
  MessageWriter writer;
  const auto text = writer.question(inventory.seen.told()[0], false);
  ASSERT_EQ(inventory.port->send(text, monotonicNs() + kLong), PortResult::ok);
  ASSERT_EQ(inventory.port->receive(monotonicNs() + kLong).result, PortResult::gone);
  inventory.port.reset();
  EXPECT_EQ(::send(held, "x", 1, MSG_NOSIGNAL), -1);
  EXPECT_EQ(errno, EPIPE);
  ::close(held);
}

/// In the device's thread nothing may be thrown.
TEST_F(HaplySocket, WhereNoDescriptorIsLeftThatIsAReason) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "To look at the type of what is thrown the sanitizer needs a descriptor itself.";
#endif
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit none = before;
  none.rlim_cur = 3;  // Those that are open stay.
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  Connection connection;
  EXPECT_NO_THROW(connection = service_->connect({}));
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_EQ(connection.reached, Reached::other);
  EXPECT_FALSE(connection.detail.empty());
}

class HaplyForms : public HaplySocket, public testing::WithParamInterface<HaplyFault> {};

TEST_P(HaplyForms, AreUnderstood) {
  plant(GetParam());
  Inventory inventory = lookAround(*service_, {});
  ASSERT_TRUE(inventory.port);
  MessageWriter writer;
  ServiceState state;
  for (int i = 0; i < 3; ++i) {
    const auto text = writer.question(inventory.seen.told()[0], true);
    ASSERT_EQ(inventory.port->send(text, monotonicNs() + kLong), PortResult::ok);
    const Port::Incoming in = inventory.port->receive(monotonicNs() + kLong);
    ASSERT_EQ(in.result, PortResult::ok);
    EXPECT_TRUE(readState(in.text, state)) << in.text;
  }
}
INSTANTIATE_TEST_SUITE_P(OfMessages, HaplyForms,
                         testing::Values(HaplyFault::byte_pieces, HaplyFault::fragments,
                                         HaplyFault::ping, HaplyFault::member_order),
                         [](const auto& one) { return std::string(nameOf(one.param)); });

class HaplyEnds : public HaplySocket, public testing::WithParamInterface<HaplyFault> {};

TEST_P(HaplyEnds, OfASessionAreSeen) {
  Inventory inventory = lookAround(*service_, {});
  ASSERT_TRUE(inventory.port);
  plant(GetParam());
  MessageWriter writer;
  const auto text = writer.question(inventory.seen.told()[0], false);
  ASSERT_EQ(inventory.port->send(text, monotonicNs() + kLong), PortResult::ok);
  EXPECT_EQ(inventory.port->receive(monotonicNs() + kLong).result, PortResult::gone);
  EXPECT_EQ(inventory.port->receive(monotonicNs() + kLong).result, PortResult::gone);
  EXPECT_EQ(inventory.port->send(text, monotonicNs() + kLong), PortResult::gone);
}
INSTANTIATE_TEST_SUITE_P(OfSessions, HaplyEnds,
                         testing::Values(HaplyFault::closes, HaplyFault::huge_frame),
                         [](const auto& one) { return std::string(nameOf(one.param)); });

TEST_F(HaplySocket, OneThatIsTooOldIsRefused) {
  mock_.with([](HaplyWorld& world) { world.version = "3.0.5"; });
  const Inventory inventory = lookAround(*service_, {});
  EXPECT_EQ(inventory.state, LinkState::old_service);
  EXPECT_EQ(inventory.version.text.view(), "3.0.5");
}

TEST_F(HaplySocket, WhoeverTellsNoVersionIsNotSpokenTo) {
  mock_.with([](HaplyWorld& world) { world.version = "of nothing"; });
  EXPECT_EQ(lookAround(*service_, {}).state, LinkState::other_service);
  EXPECT_EQ(mock_.with([](HaplyWorld& world) { return world.messages; }), 0U);
}

TEST(HaplyService, NobodyThereIsSeenWithoutASession) {
  const HeldPort held;
  const std::uint16_t port = held.port();
  {
    const InverseService mock(port);
    EXPECT_TRUE(isListenedTo(*addressOf(std::to_string(port))));
  }
  EXPECT_FALSE(isListenedTo(*addressOf(std::to_string(port))));
  EXPECT_EQ(lookAround(*serviceAt(port), {}).state, LinkState::no_service);
}

TEST_F(HaplySocket, AForceThatIsOrderedIsShownAndEndsWithTheDevice) {
  HaplyDevice device(serviceAt(mock_.port()), "049D");
  device.open();
  EXPECT_EQ(device.info().name, "Haply Inverse3 049D");
  EXPECT_EQ(device.info().id, "haply:049D");
  EXPECT_EQ(device.info().max_force_n, 5);
  EXPECT_TRUE(orderUntil(device, {0, 0, 3}, [&] { return shownN() > 2.999; }));
  EXPECT_EQ(device.status().version.view(), "3.5.0.0");
  device.close();
  EXPECT_TRUE(endsAtZero());
  EXPECT_LE(mock_.with([](HaplyWorld& world) { return world.largest_n; }), 3.001);
}

TEST_F(HaplySocket, AServiceThatIsStartedAgainIsFoundAgain) {
  const HeldPort held;
  const std::uint16_t port = held.port();
  auto mock = std::make_unique<InverseService>(port);
  HaplyDevice device(serviceAt(port), {});
  device.open();
  const auto isReady = [&] { return device.status().state == LinkState::ready; };
  ASSERT_TRUE(orderUntil(device, {}, isReady));
  mock.reset();
  EXPECT_TRUE(
      orderUntil(device, {}, [&] { return device.status().state == LinkState::no_service; }));
  mock = std::make_unique<InverseService>(port);
  EXPECT_TRUE(orderUntil(device, {}, isReady));
  device.close();  // Before its service.
}

/// As by SIGKILL the program itself can send nothing: its session closes, and that ends the force.
TEST_F(HaplySocket, AProgramThatIsKilledLeavesZero) {
  const std::string client = std::string(RELIEVO_BINARY_DIR) + "/tests/haply_client";
  const std::string port = std::to_string(mock_.port());
  const pid_t program = ::fork();
  if (program == 0) {
    ::execl(client.c_str(), client.c_str(), port.c_str(), nullptr);
    ::_exit(127);
  }
  const std::int64_t give_up = monotonicNs() + kLong;
  bool pushed = false;
  for (; !pushed && monotonicNs() < give_up; pushed = shownN() > 2.999) {
    sleepUntil(monotonicNs() + kMs);
  }
  EXPECT_TRUE(pushed);
  const std::int64_t killed_ns = monotonicNs();
  ASSERT_EQ(::kill(program, SIGKILL), 0);
  ::waitpid(program, nullptr, 0);
  EXPECT_TRUE(endsAtZero());
  const auto last = mock_.with([](HaplyWorld& world) { return world.log.back(); });
  EXPECT_EQ(last.force, HaplyWorld::Triple{});
  // A figure for docs/adr/0165, no promise of a busy computer.
  std::printf("zero (%s) %.2f ms after the kill\n", last.why,
              1e-6 * static_cast<double>(last.time_ns - killed_ns));
}

}  // namespace
}  // namespace relievo::haply
