// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/firmware.h"

#include <openssl/evp.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <span>
#include <string_view>
#include <utility>

#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/file/output_set.h"
#include "haptics/device/falcon/boot_image.h"

namespace relievo::falcon {

namespace fs = std::filesystem;

namespace {
struct KnownImage {
  const char* sha256;
  const char* name;
  bool is_recommended = false;
};
constexpr std::array<KnownImage, 4> kKnownImages{{
    {"1119e39c39fab1f37678ea62dfc715b23dd86ee7f13d78f88f707d9f09b896a1", "nvent_firmware.bin",
     true},
    {"b2700d5cd5ca217e48565fb4de5a502a636c53f6e01ebd0cad193e9f84856c6a", "test_firmware.bin"},
    {"ae838730af34b5822c9c3949859b446614af0410730b832cc17a6ad627ea64a4", "novint_T0.bin"},
    {"e0ae3598670fa1c8d9277bd6943c99b3152b97c400c46c1c42c60de77ff4e816", "novint_T2.bin"},
}};
constexpr std::array<const char*, 5> kNames{"nvent_firmware.bin", "test_firmware.bin",
                                            "novint_T0.bin", "novint_T2.bin", "falcon.bin"};
constexpr const char* kAcceptedList = "accepted";  // One hash per line.

std::string sha256Of(const std::vector<std::uint8_t>& bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw failure<MessageId::firmware_hash>();
  }
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    text += kDigits[digest[i] >> 4U];
    text += kDigits[digest[i] & 15U];
  }
  return text;
}

/// Up to the end or an error, which the stream's iterators would throw.
std::vector<std::uint8_t> bytesOf(std::istream& stream) {
  std::vector<std::uint8_t> bytes;
  std::array<char, 4096> block{};
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    bytes.insert(bytes.end(), block.begin(), block.begin() + stream.gcount());
  }
  return bytes;
}

/// One that may not be looked at counts as there: reading it says why it cannot be used.
bool isThere(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error) || error == std::errc::permission_denied;
}

std::optional<fs::path> namedIn(const fs::path& folder) {
  for (const char* name : kNames) {
    if (isThere(folder / name)) return folder / name;
  }
  return std::nullopt;
}

/// What the user named by hand: a file, or a folder with one.
Firmware readNamed(const fs::path& named, const Message& by) {
  if (!isThere(named)) throw failure<MessageId::firmware_named_missing>(named, by);
  std::error_code ignored;
  const bool is_folder = fs::is_directory(named, ignored);
  const std::optional<fs::path> file = is_folder ? namedIn(named) : named;
  if (!file) throw failure<MessageId::firmware_folder_empty>(named, by);
  try {
    return readFirmware(*file);
  } catch (const FileError& error) {
    throw failure<MessageId::firmware_named_bad>(messageOf(error), by);
  }
}

std::string joined(const std::vector<fs::path>& places) {
  std::string text;
  for (const fs::path& place : places) text += (text.empty() ? "" : " ") + place.string();
  return text;
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::vector<std::uint8_t> bytes = bytesOf(stream);
  return {bytes.begin(), bytes.end()};
}

void write(const OutputFile& place, std::string_view bytes) {
  AtomicFile file(place);
  file.write(bytes);
  file.commit();
}

Firmware accepted(Firmware firmware, const FirmwarePlaces& places) {
  if (isAccepted(firmware, places)) return firmware;
  throw failure<MessageId::firmware_unknown>(firmware.file, firmware.sha256);
}
}  // namespace

Firmware readFirmware(const fs::path& file) {
  std::error_code error;
  if (!isThere(file)) throw failure<MessageId::firmware_missing>(file);
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::none) {
    throw failure<MessageId::firmware_unreadable>(file, error.message());
  }
  if (!fs::is_regular_file(status)) throw failure<MessageId::firmware_no_file>(file);
  if (fs::file_size(file, error) > kMostImageBytes && !error) {
    throw failure<MessageId::firmware_too_long>(file, kMostImageBytes);
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw failure<MessageId::firmware_unreadable>(file, std::strerror(errno));
  Firmware firmware;
  firmware.file = file;
  firmware.bytes = bytesOf(stream);
  if (stream.bad()) throw failure<MessageId::firmware_cut>(file);
  const BootImage image = inspectBootImage(firmware.bytes);
  if (image.problem) throw failure<MessageId::firmware_no_image>(file, *image.problem);
  firmware.sha256 = sha256Of(firmware.bytes);
  for (const KnownImage& known : kKnownImages) {
    if (firmware.sha256 != known.sha256) continue;
    firmware.known_as = known.is_recommended ? said<MessageId::firmware_recommended>(known.name)
                                             : said<MessageId::quoted>(known.name);
  }
  return firmware;
}

FirmwarePlaces firmwarePlaces(const fs::path& setting) {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    return std::string(value == nullptr ? "" : value);
  };
  FirmwarePlaces places;
  places.setting = setting;
  places.environment = variable("RELIEVO_FALCON_FIRMWARE");
  const std::string data = variable("XDG_DATA_HOME");
  // The base directory specification: a relative path is ignored.
  const fs::path home =
      data.starts_with('/') ? fs::path(data) : fs::path(variable("HOME")) / ".local/share";
  places.data_home = home / "relievo/falcon";
  places.system = {"/usr/local/share/relievo/falcon", "/usr/share/relievo/falcon",
                   "/lib/firmware/novint"};
  return places;
}

Firmware findFirmware(const FirmwarePlaces& places) {
  if (!places.setting.empty()) {
    return accepted(readNamed(places.setting, said<MessageId::firmware_setting>()), places);
  }
  if (!places.environment.empty()) {
    return accepted(
        readNamed(places.environment, said<MessageId::quoted>("RELIEVO_FALCON_FIRMWARE")), places);
  }
  std::vector<fs::path> searched{places.data_home};
  searched.insert(searched.end(), places.system.begin(), places.system.end());
  for (const fs::path& folder : searched) {
    if (const auto file = namedIn(folder)) return accepted(readFirmware(*file), places);
  }
  throw failure<MessageId::firmware_not_found>(joined(searched));
}

std::function<std::vector<std::uint8_t>()> firmwareSource(const fs::path& setting) {
  return [setting] {
    const Firmware firmware = findFirmware(firmwarePlaces(setting));
    std::cerr << "relievo: Loading the Falcon's firmware \"" + firmware.file.string() + "\", " +
                     std::to_string(firmware.bytes.size()) + " bytes, sha256 " + firmware.sha256 +
                     (firmware.known_as ? ", " + englishText(*firmware.known_as) : "") + ".\n";
    return firmware.bytes;
  };
}

bool isAccepted(const Firmware& firmware, const FirmwarePlaces& places) {
  if (firmware.known_as) return true;
  std::ifstream list(places.data_home / kAcceptedList);
  for (std::string line; std::getline(list, line);) {
    if (line == firmware.sha256) return true;
  }
  return false;
}

fs::path installFirmware(const Firmware& firmware, const FirmwarePlaces& places) {
  const auto refuse = [&places](Message why) {
    throw failure<MessageId::firmware_not_copied>(places.data_home, std::move(why));
  };
  std::error_code error;
  fs::create_directories(places.data_home, error);
  if (error) refuse(said<MessageId::quoted>(error.message()));
  // The first name that is looked for, so that this choice wins over older ones.
  const fs::path target = places.data_home / kNames[0];
  const fs::path list = places.data_home / kAcceptedList;
  try {
    OutputSet files;
    if (!isAccepted(firmware, places)) {
      write(files.file(list), textOf(list) + firmware.sha256 + "\n");
    }
    const auto* bytes = reinterpret_cast<const char*>(firmware.bytes.data());
    write(files.file(target), {bytes, firmware.bytes.size()});
    files.commit();
  } catch (const CannotWrite& cannot) {
    refuse(said<MessageId::quoted>(cannot.reason));
  } catch (const NotReplaceable& refused) {
    refuse(refused.why);
  }
  return target;
}

}  // namespace relievo::falcon
