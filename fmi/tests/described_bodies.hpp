#pragma once

#include "io/profile_file.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include <filesystem>

namespace microslip::fmi {

/// Bodies that the start values of the units of wheels describe.
inline WheelRailBodies described_bodies(TrackSide side = TrackSide::left) {
  const std::filesystem::path resources = MICROSLIP_UNPACKED_FMU "/resources";
  const Material steel = Material::from_young(210e9, 0.28);
  return {.rail = io::read_profile(resources / "60e1.prr").profile,
          .wheel = io::read_profile(resources / "s1002.prw").profile,
          .track = {},
          .wheelset = {},
          .side = side,
          .material = combine(steel, steel),
          .friction = {{0, 0.3}}};
}

} // namespace microslip::fmi
