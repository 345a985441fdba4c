// SPDX-License-Identifier: BSD-3-Clause
#include "tests/app/program_window.h"

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <stdexcept>
#include <thread>

// After Qt: its macros are common words.
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace relievo::test {

namespace {
struct CloseDisplay {
  void operator()(Display* display) const { XCloseDisplay(display); }
};

std::string nameOf(Display* display, Window window) {
  const Atom utf8 = XInternAtom(display, "UTF8_STRING", 0);
  const Atom property = XInternAtom(display, "_NET_WM_NAME", 0);
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, rest = 0;  // NOLINT(google-runtime-int): as Xlib has them.
  unsigned char* text = nullptr;
  constexpr long kMostWords = 256;  // NOLINT(google-runtime-int)
  if (XGetWindowProperty(display, window, property, 0, kMostWords, 0, utf8, &type, &format, &count,
                         &rest, &text) != 0 ||
      text == nullptr) {
    return {};
  }
  std::string name(reinterpret_cast<char*>(text), count);
  XFree(text);
  return name;
}

/// Windows come and go while they are looked at.
int ignoreErrors(Display* /*display*/, XErrorEvent* /*error*/) {
  return 0;
}
}  // namespace

struct ProgramWindow::Impl {
  std::unique_ptr<Display, CloseDisplay> display{XOpenDisplay(nullptr)};
  pid_t process = 0;
  int status = 0;
  bool ended = false;

  /// The shown window whose title ends in the program's name; 0: none.
  Window mainWindow() const {
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display.get(), DefaultRootWindow(display.get()), &root, &parent, &children,
                   &count) == 0) {
      return 0;
    }
    Window found = 0;
    for (unsigned i = 0; i < count; ++i) {
      XWindowAttributes attributes{};
      const bool shown = XGetWindowAttributes(display.get(), children[i], &attributes) != 0 &&
                         attributes.map_state == IsViewable;
      if (shown && nameOf(display.get(), children[i]).ends_with("relievo")) found = children[i];
    }
    if (children != nullptr) XFree(children);
    return found;
  }
};

ProgramWindow::ProgramWindow(const std::vector<std::string>& arguments, const std::string& program)
    : impl_(std::make_unique<Impl>()) {
  if (!impl_->display) throw std::runtime_error("there is no screen");
  XSetErrorHandler(&ignoreErrors);
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  if (posix_spawn(&impl_->process, program.c_str(), nullptr, nullptr, argv.data(), environ) != 0) {
    throw std::runtime_error(program + " could not be started");
  }
}

ProgramWindow::~ProgramWindow() {
  if (!runs()) return;
  kill(impl_->process, SIGKILL);
  waitpid(impl_->process, &impl_->status, 0);
}

bool ProgramWindow::runs() {
  if (!impl_->ended && waitpid(impl_->process, &impl_->status, WNOHANG) == impl_->process) {
    impl_->ended = true;
  }
  return !impl_->ended;
}

int ProgramWindow::process() const {
  return impl_->process;
}

int ProgramWindow::exitCode() const {
  return WIFEXITED(impl_->status) ? WEXITSTATUS(impl_->status) : 128 + WTERMSIG(impl_->status);
}

std::string ProgramWindow::title() {
  const Window window = impl_->mainWindow();
  return window == 0 ? std::string() : nameOf(impl_->display.get(), window);
}

bool ProgramWindow::hasIcon() {
  Display* const display = impl_->display.get();
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, rest = 0;
  unsigned char* data = nullptr;
  constexpr long kSizeOnly = 2;  // Width and height come first.
  const bool read =
      XGetWindowProperty(display, impl_->mainWindow(), XInternAtom(display, "_NET_WM_ICON", 0), 0,
                         kSizeOnly, 0, XA_CARDINAL, &type, &format, &count, &rest, &data) == 0;
  if (data != nullptr) XFree(data);
  return read && count == kSizeOnly && rest > 0;
}

void ProgramWindow::key(const std::string& name, bool control, bool alt) {
  Display* display = impl_->display.get();
  const Window window = impl_->mainWindow();
  // There is no window manager that would give it the keyboard.
  XSetInputFocus(display, window, RevertToParent, CurrentTime);
  XSync(display, 0);
  XEvent event{};
  XKeyEvent& key = event.xkey;
  key.display = display;
  key.window = window;
  key.root = DefaultRootWindow(display);
  key.time = CurrentTime;
  key.same_screen = 1;
  key.keycode = XKeysymToKeycode(display, XStringToKeysym(name.c_str()));
  key.state = (control ? ControlMask : 0U) | (alt ? Mod1Mask : 0U);
  for (const int type : {KeyPress, KeyRelease}) {
    key.type = type;
    XSendEvent(display, window, 1, KeyPressMask, &event);
  }
  XSync(display, 0);
}

void ProgramWindow::picture(const std::string& file) {
  Display* display = impl_->display.get();
  XWindowAttributes screen{};
  XGetWindowAttributes(display, DefaultRootWindow(display), &screen);
  XImage* seen =
      XGetImage(display, DefaultRootWindow(display), 0, 0, static_cast<unsigned>(screen.width),
                static_cast<unsigned>(screen.height), AllPlanes, ZPixmap);
  if (seen == nullptr) throw std::runtime_error("the screen cannot be read");
  const QImage image(reinterpret_cast<const uchar*>(seen->data), seen->width, seen->height,
                     seen->bytes_per_line, QImage::Format_RGB32);
  const QString name = QString::fromStdString(file);
  QDir().mkpath(QFileInfo(name).path());
  const bool saved = image.save(name);
  XDestroyImage(seen);
  if (!saved) throw std::runtime_error(file + " cannot be written");
}

bool eventually(const std::function<bool()>& holds) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(240);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

}  // namespace relievo::test
