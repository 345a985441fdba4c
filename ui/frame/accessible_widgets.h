// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// The property of a button that unfolds a section: true while the section is open, else false.
inline constexpr const char* kUnfolded = "unfolded";

/// Tells screen readers more of some widgets than Qt 5 does on Linux, wherever they stand
/// (docs/adr/0196-what-screen-readers-meet.md): a label says its text behind its name, a list to
/// choose from its choice, a section whether it is open, and a plot is one object. To be called
/// once, after the application is made and before its windows. [GUI thread]
void installAccessibleWidgets();

}  // namespace relievo
