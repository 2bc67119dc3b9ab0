#pragma once

#include "app/input_options.hpp"
#include "cases/profile_result.hpp"
#include "io/profile_file.hpp"

#include <filesystem>
#include <vector>

namespace microslip::app {

/// Options of the equivalent conicity of a folder's profiles with one other.
struct PartnerOptions {
  std::filesystem::path file; ///< a rail for wheels, a wheel for rails; empty: no conicity
  InputOptions inputs{description::conicity_inputs()};
  std::vector<double> gauge;                                     ///< [m]; one value
  double cant = 0, nominal_radius = 0, flange_back_distance = 0; ///< [rad], [m], [m]
};

/// Adds --partner, --gauge, --cant and so on; `options` must outlive the command.
void add_partner_options(Command& command, PartnerOptions& options);

struct ProfileFolderArguments {
  std::filesystem::path input;
  io::ProfileFileOptions options; ///< of all files
  cases::ProfileMeasures measures;
  const PartnerOptions* partner = nullptr;
  std::filesystem::path folder; ///< of profiles.csv, result.h5 and profiles.png; empty: none
  bool no_pictures = false, json = false;
};

/// Reads and measures all files of a folder, except hidden ones and slices, in the order of their names; those that
/// cannot be read are listed with their errors. Prints a table or a document and writes files. The exit code, not_met
/// if a file could not be read. Throws Error for a folder without files.
int show_profile_folder(const ProfileFolderArguments& arguments);

} // namespace microslip::app
