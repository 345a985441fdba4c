// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/message/message.h"

namespace relievo::falcon {

// The firmware is Novint's and is not part of this program: it is found on the user's computer.

struct Firmware {
  std::filesystem::path file;
  std::vector<std::uint8_t> bytes;
  std::string sha256;  ///< 64 hexadecimal digits.
  std::optional<Message>
      known_as;  ///< "nvent_firmware.bin (recommended)"; nothing: it is not known.
};

/// Reads and inspects a file. @throw FileError  missing, unreadable, or not a boot image
Firmware readFirmware(const std::filesystem::path& file);

/// What the user has said, and where the system keeps things.
struct FirmwarePlaces {
  std::filesystem::path setting;    ///< From the preferences; empty: not set.
  std::string environment;          ///< Of RELIEVO_FALCON_FIRMWARE: a file or a folder.
  std::filesystem::path data_home;  ///< $XDG_DATA_HOME/relievo/falcon
  std::vector<std::filesystem::path> system;
};
/// From the environment of the process.
FirmwarePlaces firmwarePlaces(const std::filesystem::path& setting = {});

/// The first file in the order: setting, environment, data home, system. One that the user named
/// and that is bad is an error, never passed over; so is an image that nobody knows and that was
/// not accepted. @throw FileError  says which, or every place that was searched
Firmware findFirmware(const FirmwarePlaces& places);

/// For the driver: finds anew each time it is asked, and tells on stderr what will be loaded.
std::function<std::vector<std::uint8_t>()> firmwareSource(
    const std::filesystem::path& setting = {});

/// Copies an image to the user's data home, whole or not at all, and remembers that it was
/// accepted. @return where it lies now. @throw WriteError
std::filesystem::path installFirmware(const Firmware& firmware, const FirmwarePlaces& places);

/// Was this image installed on purpose before?
bool isAccepted(const Firmware& firmware, const FirmwarePlaces& places);

}  // namespace relievo::falcon
