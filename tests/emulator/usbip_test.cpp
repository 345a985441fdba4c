// SPDX-License-Identifier: BSD-3-Clause
// The USB/IP front, asked by a small client that speaks the protocol's literal bytes.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string>
#include <thread>
#include <utility>

#include "tests/emulator/usbip_server.h"

namespace relievo::emulator {
namespace {

using Bytes = std::vector<std::uint8_t>;

class UsbipTest : public ::testing::Test {
 protected:
  void serve(EmulatorOptions options, bool negotiate) {
    std::array<int, 2> pair{};
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, pair.data()), 0);
    client_ = pair[0];
    falcon_ = std::make_shared<SharedFalcon>(options);
    thread_ = std::jthread([this, socket = pair[1], negotiate](const std::stop_token& stop) {
      UsbipServer(socket, falcon_, negotiate).serve(stop);
    });
  }
  void TearDown() override { close(client_); }

  void send(const Bytes& bytes) {
    ASSERT_EQ(::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }
  Bytes receive(std::size_t size) {
    Bytes bytes(size);
    std::size_t got = 0;
    while (got < size) {
      pollfd poll{.fd = client_, .events = POLLIN, .revents = 0};
      if (::poll(&poll, 1, 30'000) <= 0) break;
      const ssize_t n = recv(client_, bytes.data() + got, size - got, 0);
      if (n <= 0) break;
      got += static_cast<std::size_t>(n);
    }
    bytes.resize(got);
    return bytes;
  }
  static std::uint32_t word(const Bytes& bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at] << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 |
                                      bytes[at + 3]);
  }
  static void put(Bytes& bytes, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0})
      bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
  void submit(std::uint32_t sequence, bool in, std::uint32_t endpoint, std::uint32_t length,
              const Bytes& setup, const Bytes& data = {}) {
    Bytes bytes;
    for (const std::uint32_t w :
         {1U, sequence, 0x10002U, in ? 1U : 0U, endpoint, 0U, length, 0U, 0U, 0U}) {
      put(bytes, w);
    }
    Bytes request = setup;
    request.resize(8);
    bytes.insert(bytes.end(), request.begin(), request.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    send(bytes);
  }
  struct Answer {
    std::uint32_t command = 0, sequence = 0;
    int status = 0;
    Bytes data;
    std::uint32_t length = 0;
  };
  Answer answer(bool in) {
    const Bytes header = receive(48);
    if (header.size() < 48) return {};
    Answer a{
        word(header, 0), word(header, 4), static_cast<int>(word(header, 20)), {}, word(header, 24)};
    if (a.command == 3 && in && a.length > 0) a.data = receive(a.length);
    return a;
  }
  Answer control(std::uint32_t sequence, const Bytes& setup, std::uint32_t length = 0) {
    submit(sequence, (setup[0] & 0x80) != 0, 0, length, setup);
    return answer((setup[0] & 0x80) != 0);
  }

  int client_ = -1;
  std::shared_ptr<SharedFalcon> falcon_;
  std::jthread thread_;
};

TEST_F(UsbipTest, IsListedAndImported) {
  serve({}, true);
  send({0x01, 0x11, 0x80, 0x05, 0, 0, 0, 0});
  const Bytes list = receive(12 + 312 + 4);
  ASSERT_EQ(list.size(), 328U);
  EXPECT_EQ(list[3], 5);
  EXPECT_EQ(word(list, 8), 1U) << "one device";
  EXPECT_EQ(std::string(list.begin() + 12 + 256, list.begin() + 12 + 259), "1-1");
  Bytes import{0x01, 0x11, 0x80, 0x03, 0, 0, 0, 0, '1', '-', '1'};
  import.resize(40);
  send(import);
  const Bytes device = receive(8 + 312);
  ASSERT_EQ(device.size(), 320U);
  EXPECT_EQ(word(device, 4), 0U) << "granted";
  EXPECT_EQ(word(device, 8 + 256 + 32 + 8), 2U) << "full speed";
  EXPECT_EQ(word(device, 8 + 256 + 32 + 12), 0x0403cb48U);
  const Answer descriptor = control(1, {0x80, 6, 0, 1, 0, 0, 18, 0}, 18);
  EXPECT_EQ(descriptor.data, FalconEmulator::deviceDescriptor());
}

TEST_F(UsbipTest, AnswersStandardRequestsAndStallsUnknownOnes) {
  serve({}, false);
  EXPECT_EQ(control(1, {0x80, 6, 0, 2, 0, 0, 9, 0}, 9).data.size(), 9U) << "as short as asked";
  const Answer text = control(2, {0x80, 6, 2, 3, 9, 4, 255, 0}, 255);
  EXPECT_EQ(text.data[2], 'F');
  EXPECT_EQ(control(3, {0, 9, 1, 0, 0, 0, 0, 0}).status, 0);
  EXPECT_EQ(control(4, {0x80, 77, 0, 0, 0, 0, 0, 0}).status, -EPIPE);
  EXPECT_EQ(control(5, {0x40, 9, 1, 0, 0, 0, 0, 0}).status, 0) << "latency";
  EXPECT_EQ(control(6, {0xc0, 10, 0, 0, 0, 0, 1, 0}, 1).data, Bytes{1});
  EXPECT_EQ(control(7, {0x40, 99, 0, 0, 0, 0, 0, 0}).status, -EPIPE);
}

TEST_F(UsbipTest, AnswersFramesInOrder) {
  serve({.firmware_loaded = true, .homed = true}, false);
  control(1, {0x40, 9, 1, 0, 0, 0, 0, 0});
  control(2, {0x40, 3, 2, 0, 0, 0, 0, 0});
  const std::string frame = "<IODAIBMPAAAAJA>";
  std::uint32_t sequence = 10;
  for (int i = 0; i < 100; ++i) {
    submit(++sequence, false, 2, 16, {}, Bytes(frame.begin(), frame.end()));
    Bytes got;
    const Answer out = answer(false);
    ASSERT_EQ(out.sequence, sequence);
    ASSERT_EQ(out.length, 16U);
    while (got.size() < 16) {
      submit(++sequence, true, 1, 64, {});
      const Answer in = answer(true);
      ASSERT_EQ(in.sequence, sequence);
      ASSERT_EQ(in.status, 0);
      ASSERT_GE(in.data.size(), 2U);
      got.insert(got.end(), in.data.begin() + 2, in.data.end());
    }
    ASSERT_EQ(got.front(), '<');
    ASSERT_EQ(got.back(), '>');
    ASSERT_EQ(got[13], 'A' + 0x70) << "all homed";
  }
  falcon_->with([](auto& f) {
    EXPECT_EQ(f.commands().size(), 100U);
    EXPECT_EQ(f.commands().back().motors, (std::array<int, 3>{1000, -1000, 0}));
    EXPECT_EQ(f.commands().back().lights, 8);
  });
}

TEST_F(UsbipTest, APendingReadIsUnlinkedAndADoneOneIsNot) {
  serve({}, false);
  control(1, {0x40, 9, 255, 0, 0, 0, 0, 0});
  // The first packet leaves at once; the next one waits for the latency timer.
  submit(2, true, 1, 64, {});
  EXPECT_EQ(answer(true).sequence, 2U);
  submit(3, true, 1, 64, {});
  Bytes unlink;
  for (const std::uint32_t w : {2U, 4U, 0x10002U, 0U, 0U, 3U, 0U, 0U, 0U, 0U, 0U, 0U})
    put(unlink, w);
  send(unlink);
  const Answer done = answer(false);
  EXPECT_EQ(done.command, 4U);
  EXPECT_EQ(done.sequence, 4U);
  EXPECT_EQ(done.status, -ECONNRESET);
  send(unlink);
  EXPECT_EQ(answer(false).status, 0) << "it is gone already";
}

TEST_F(UsbipTest, UnpluggingEndsTheConnectionAndNonsenseToo) {
  serve({}, false);
  falcon_->with([](auto& f) { f.unplug(); });
  EXPECT_TRUE(receive(1).empty());
  close(client_);
  serve({}, false);
  send(Bytes(48, 0xff));
  EXPECT_TRUE(receive(1).empty());
}

/// The program itself, its input and output in our hands.
class EmulatorProgram {
 public:
  explicit EmulatorProgram(const std::string& port) {
    std::array<int, 2> in{}, out{};
    if (pipe2(in.data(), O_CLOEXEC) != 0 || pipe2(out.data(), O_CLOEXEC) != 0) return;
    const std::string program = RELIEVO_EMULATOR_PROGRAM;
    child_ = fork();
    if (child_ == 0) {
      dup2(in[0], 0);
      dup2(out[1], 1);
      execl(program.c_str(), program.c_str(), "--port", port.c_str(), "--homed", nullptr);
      _exit(99);
    }
    close(in[0]);
    close(out[1]);
    input_ = in[1];
    output_ = out[0];
  }
  ~EmulatorProgram() {
    endInput();
    close(output_);
    if (child_ > 0) kill(child_, SIGKILL);
    exitCode();
  }
  EmulatorProgram(const EmulatorProgram&) = delete;
  EmulatorProgram& operator=(const EmulatorProgram&) = delete;

  std::string line() const {
    std::string text;
    for (char c = 0; read(output_, &c, 1) == 1 && c != '\n';) text += c;
    return text;
  }
  void say(const std::string& text) const {
    ASSERT_EQ(write(input_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void endInput() {
    if (input_ >= 0) close(std::exchange(input_, -1));
  }
  int exitCode() {
    int status = 0;
    if (child_ <= 0 || waitpid(std::exchange(child_, -1), &status, 0) < 0) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t child_ = -1;
  int input_ = -1, output_ = -1;
};

sockaddr_in here(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// One that nobody listens on just now.
int freePort() {
  const int probe = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = here(0);
  socklen_t size = sizeof address;
  EXPECT_EQ(bind(probe, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size), 0);
  close(probe);
  return ntohs(address.sin_port);
}

TEST(EmulatorProgramTest, QuitEndsItWhileNobodyIsConnected) {
  EmulatorProgram program(std::to_string(freePort()));
  EXPECT_EQ(program.line().substr(0, 7), "Serving");
  program.say("quit\n");
  EXPECT_EQ(program.exitCode(), 0);
}

TEST(EmulatorProgramTest, ServesOnWhenItsInputEnds) {
  const int port = freePort();
  EmulatorProgram program(std::to_string(port));
  program.endInput();
  EXPECT_EQ(program.line().substr(0, 7), "Serving");
  for (int i = 0; i < 2; ++i) {  // The first may come before the end of the input is read.
    const int client = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = here(port);
    ASSERT_EQ(connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    // Which devices are there? The answer begins with the same version, and counts one.
    const Bytes question{1, 0x11, 0x80, 5, 0, 0, 0, 0};
    ASSERT_EQ(send(client, question.data(), question.size(), MSG_NOSIGNAL), 8);
    Bytes answer(12);
    EXPECT_EQ(recv(client, answer.data(), answer.size(), MSG_WAITALL), 12);
    EXPECT_EQ(answer, (Bytes{1, 0x11, 0, 5, 0, 0, 0, 0, 0, 0, 0, 1}));
    close(client);
  }
}

TEST(EmulatorProgramTest, RefusesAPortThatIsNone) {
  for (const char* port : {"abc", "0", "70000", "80x", ""}) {
    EXPECT_EQ(EmulatorProgram(port).exitCode(), 1) << port;
  }
}

}  // namespace
}  // namespace relievo::emulator
