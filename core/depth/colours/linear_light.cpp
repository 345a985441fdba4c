// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colours/linear_light.h"

#include <cmath>
#include <cstddef>

namespace relievo {
namespace {

constexpr double kWhite = 255;

template <class LightOf, class StoredOf>
Transfer made(const LightOf& light_of, const StoredOf& stored_of) {
  Transfer transfer;
  for (std::size_t i = 0; i < transfer.light.size(); ++i) {
    const double light = light_of(static_cast<double>(i) / kWhite);
    transfer.light[i] = static_cast<std::uint16_t>(std::lround(light * Transfer::kMost));
  }
  for (std::size_t i = 0; i < transfer.stored.size(); ++i) {
    const double stored = stored_of(static_cast<double>(i) / Transfer::kMost);
    transfer.stored[i] = static_cast<std::uint8_t>(std::lround(stored * kWhite));
  }
  return transfer;
}

double lightOf(double stored) {
  return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
}

double storedOf(double light) {
  return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

}  // namespace

const Transfer& sRgb() {
  static const Transfer transfer = made(lightOf, storedOf);
  return transfer;
}

const Transfer& proportional() {
  static const Transfer transfer =
      made([](double stored) { return stored; }, [](double light) { return light; });
  return transfer;
}

}  // namespace relievo
