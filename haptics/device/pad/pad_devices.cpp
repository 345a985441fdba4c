// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/pad/pad_devices.h"

#include <sys/ioctl.h>

#include <fcntl.h>
#include <linux/input.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <list>
#include <set>
#include <utility>

#include "haptics/device/pad/pad_bits.h"

namespace relievo::pad {

namespace fs = std::filesystem;

namespace {
constexpr const char* kClass = "/sys/class/input";
constexpr int kMostReadsPerPoll = 64;
constexpr std::size_t kKeyBytes = KEY_CNT / 8;

/// A descriptor of an event device that closes itself.
class Node {
 public:
  explicit Node(int fd = -1) noexcept : fd_(fd) {}
  ~Node() {
    if (fd_ >= 0) ::close(fd_);
  }
  Node(Node&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Node& operator=(Node&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  int get() const noexcept { return fd_; }
  bool isOpen() const noexcept { return fd_ >= 0; }

 private:
  int fd_;
};

/// One effect, kept by the kernel for this descriptor and changed in place; it ends with it.
class EvdevMotor : public RumbleMotor {
 public:
  explicit EvdevMotor(Node node) noexcept : node_(std::move(node)) {
    effect_.type = FF_RUMBLE;
    effect_.id = -1;  // The kernel gives it one.
  }

  bool show(RumbleLevel level, int ms) noexcept override {
    const auto size = [](double part) {
      return static_cast<std::uint16_t>(std::lround(0xffff * std::clamp(part, 0.0, 1.0)));
    };
    effect_.replay.length = static_cast<std::uint16_t>(ms);
    effect_.u.rumble.strong_magnitude = size(level.strong);
    effect_.u.rumble.weak_magnitude = size(level.weak);
    return ::ioctl(node_.get(), EVIOCSFF, &effect_) >= 0 && play(1);
  }
  bool stop() noexcept override { return effect_.id < 0 || play(0); }

 private:
  bool play(int times) const noexcept {
    input_event event{};
    event.type = EV_FF;
    event.code = static_cast<std::uint16_t>(effect_.id);
    event.value = times;
    return ::write(node_.get(), &event, sizeof event) == static_cast<ssize_t>(sizeof event);
  }

  Node node_;
  ff_effect effect_{};
};

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string lineOf(const fs::path& file) {
  std::string line = textOf(file);
  line.resize(std::min(line.find('\n'), line.size()));
  return line;
}

struct OpenPad {
  std::string path;  // Of its node.
  SeenPad seen;
  PadFacts facts;
  Node node;                           // Closed where it may not be opened. Read also where
                                       // hidraw has its buttons: its end says that it is gone.
  std::unique_ptr<RumbleMotor> motor;  // Until it is handed on.
  std::uint32_t buttons = 0;           // The Falcon's, as told last.
  bool dropped = false;                // The kernel had more events than room.
};

/// Of an input device in sysfs, whose folder lies two below that of the device that has it.
bool hasHidraw(const fs::path& input) {
  std::error_code error;
  return fs::exists(input.parent_path().parent_path() / "hidraw", error);
}

/// [worker]
OpenPad opened(const std::string& name, const fs::path& input) {
  OpenPad pad;
  pad.path = "/dev/input/" + name;
  pad.facts = factsOf(textOf(input / "capabilities/key"), textOf(input / "capabilities/ff"));
  if (!pad.facts.isPad()) return pad;
  pad.seen = {.name = lineOf(input / "name"),
              .access = true,
              .presses = !hasHidraw(input),
              .can_rumble = pad.facts.can_rumble};
  if (pad.seen.name.empty()) pad.seen.name = "Gamepad";
  constexpr int kHow = O_CLOEXEC | O_NONBLOCK;
  pad.node = Node(::open(pad.path.c_str(), O_RDONLY | kHow));
  pad.seen.access = pad.node.isOpen();
  if (!pad.seen.can_rumble) return pad;
  Node node(::open(pad.path.c_str(), O_RDWR | kHow));
  pad.seen.access = pad.seen.access && node.isOpen();
  if (node.isOpen()) pad.motor = std::make_unique<EvdevMotor>(std::move(node));
  return pad;
}

/// What is plugged in; new ones are opened.
struct Sight {
  std::set<std::string> there;
  std::list<OpenPad> opened;
};

/// [worker] @param known  paths of those that are open already
Sight lookAround(const std::set<std::string>& known) {
  Sight sight;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(kClass, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("event")) continue;
    const std::string path = "/dev/input/" + name;
    sight.there.insert(path);
    if (known.contains(path)) continue;
    const fs::path device = fs::canonical(entry.path(), error);
    if (error) continue;
    OpenPad pad = opened(name, device.parent_path());
    const bool is_of_use = pad.seen.presses || pad.seen.can_rumble;
    if (pad.facts.isPad() && is_of_use) sight.opened.push_back(std::move(pad));
  }
  return sight;
}

void tellEdges(std::uint32_t before, std::uint32_t after, std::vector<PadEdge>& edges) {
  for (std::uint8_t i = 0; i < 4; ++i) {
    const bool was = (before >> i & 1U) != 0, is = (after >> i & 1U) != 0;
    if (was != is) edges.push_back({i, is});
  }
}

void press(OpenPad& pad, int key, bool down, std::vector<PadEdge>& edges) {
  const int button = pad.seen.presses ? falconButton(pad.facts, key) : -1;
  if (button < 0) return;
  const std::uint32_t bit = 1U << static_cast<unsigned>(button);
  const std::uint32_t after = down ? pad.buttons | bit : pad.buttons & ~bit;
  tellEdges(pad.buttons, after, edges);
  pad.buttons = after;
}

/// After events were lost: what is down now.
void askKeys(OpenPad& pad, std::vector<PadEdge>& edges) {
  std::array<unsigned char, kKeyBytes> down{};
  if (::ioctl(pad.node.get(), EVIOCGKEY(kKeyBytes), down.data()) < 0) return;
  for (const int key : pad.facts.keys) {
    const auto place = static_cast<unsigned>(key);
    press(pad, key, (down.at(place / 8) >> (place % 8) & 1U) != 0, edges);
  }
}

void take(OpenPad& pad, const input_event& event, std::vector<PadEdge>& edges) {
  if (event.type == EV_SYN && event.code == SYN_DROPPED) {
    pad.dropped = true;
  } else if (event.type == EV_SYN && event.code == SYN_REPORT &&
             std::exchange(pad.dropped, false)) {
    askKeys(pad, edges);
  } else if (event.type == EV_KEY && !pad.dropped && event.value != 2) {
    press(pad, event.code, event.value != 0, edges);
  }
}

/// @return false: it is gone
bool read(OpenPad& pad, std::vector<PadEdge>& edges) {
  std::array<input_event, 64> events{};
  for (int i = 0; i < kMostReadsPerPoll; ++i) {
    const ssize_t got = ::read(pad.node.get(), events.data(), sizeof events);
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    const std::size_t count = static_cast<std::size_t>(got) / sizeof(input_event);
    if (count == 0) return true;
    for (std::size_t k = 0; k < count; ++k) take(pad, events[k], edges);
  }
  return true;
}
}  // namespace

struct PadDevices::Impl {
  std::shared_ptr<Rumbler> rumbler;
  std::list<OpenPad> pads;
  std::list<OpenPad> closed;  // Those that this account may not open.
  std::future<Sight> looking;

  static void letGo(const OpenPad& pad, PadNews& news) {
    tellEdges(pad.buttons, 0, news.edges);
    news.left.push_back(pad.seen.name);
  }
  void take(Sight sight, PadNews& news);
};

void PadDevices::Impl::take(Sight sight, PadNews& news) {
  std::erase_if(pads, [&](const OpenPad& pad) {
    const bool gone = !sight.there.contains(pad.path);
    if (gone) letGo(pad, news);
    return gone;
  });
  closed.clear();
  while (!sight.opened.empty()) {
    OpenPad& pad = sight.opened.front();
    // Access may come a moment after the plug: those that are closed are tried at each look.
    std::list<OpenPad>& to = pad.seen.access ? pads : closed;
    if (pad.seen.access) {
      news.arrived.push_back(pad.seen.name);
      if (pad.motor && rumbler) rumbler->add(std::move(pad.motor));
      pad.motor.reset();
    }
    to.splice(to.end(), sight.opened, sight.opened.begin());
  }
}

PadDevices::PadDevices(std::shared_ptr<Rumbler> rumbler) : impl_(std::make_unique<Impl>()) {
  impl_->rumbler = std::move(rumbler);
}

PadDevices::~PadDevices() {
  if (impl_->looking.valid()) impl_->looking.wait();
}

void PadDevices::look() {
  if (impl_->looking.valid()) return;
  std::set<std::string> known;
  for (const OpenPad& pad : impl_->pads) known.insert(pad.path);
  impl_->looking =
      std::async(std::launch::async, [known = std::move(known)] { return lookAround(known); });
}

void PadDevices::rescan(PadNews& news) {
  look();
  impl_->take(impl_->looking.get(), news);
}

void PadDevices::poll(PadNews& news) {
  if (impl_->looking.valid() &&
      impl_->looking.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    impl_->take(impl_->looking.get(), news);
  }
  std::erase_if(impl_->pads, [&](OpenPad& pad) {
    const bool gone = !read(pad, news.edges);
    if (gone) Impl::letGo(pad, news);
    return gone;
  });
}

std::vector<SeenPad> PadDevices::seen() const {
  std::vector<SeenPad> all;
  for (const std::list<OpenPad>* some : {&impl_->pads, &impl_->closed}) {
    for (const OpenPad& pad : *some) all.push_back(pad.seen);
  }
  return all;
}

bool hasPadDevices() noexcept {
  return true;
}

}  // namespace relievo::pad
