#pragma once

#include "compat/contact/records.hpp"
#include "compat/contact/words.hpp"

#include <filesystem>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace microslip::contact_program {

/// Reads the cases of a CONTACT input file one after the other, in constant memory, and completes what they keep from
/// the ones before. Modules 1 and 3.
///
/// Throws Error with file, line, field, value and allowed range for whatever is against the grammar: values that are
/// missing, no numbers or out of range, digits that do not exist or that do not go together, and a digit that keeps
/// what no earlier case has given.
class InputReader {
public:
  /// `stream` must outlive the reader. Files of influence coefficients are looked for in the folder of `name`.
  InputReader(std::istream& stream, const std::string& name);

  /// The next case, nullptr at the end of the file or at MODULE 0. It holds until the next call.
  const Case* next();
  /// Returns whether the end that next() has found is the one that MODULE 0 makes, and not that of a file cut short.
  bool is_complete() const { return complete_; }

private:
  int read_module();
  void read_case(Case& c);
  void check_kept(const Case& c);
  void read_kinematics(Case& c);
  void read_friction(Case& c);
  void read_rolling(Case& c);
  void read_material(Case& c);
  std::shared_ptr<const InfluenceTable> coefficients_from(const std::string& file, const MaterialData& m);
  void read_potential(Case& c);
  void read_geometry(Case& c);
  void read_friction_by_rows(Case& c);
  void read_extra_slip(Case& c);

  Words words_;
  std::filesystem::path folder_; ///< of the file
  /// By file and combined modulus [Pa], so that cases with the same ones share them.
  std::map<std::pair<std::string, double>, std::shared_ptr<const InfluenceTable>> tables_;
  std::map<std::pair<int, std::pair<int, int>>, CaseSequence> sequences_; ///< by module and sequence
  CaseSequence* now_ = nullptr;
  std::map<int, int> cases_of_element_; ///< so far, by RE
  std::pair<int, int> sequence_ = {1, 1};
  int module_ = 0, cases_ = 0;
  bool in_module_ = false, ended_ = false, complete_ = false;
};

} // namespace microslip::contact_program
