#pragma once

#include "compat/contact/outcome.hpp"
#include "io/result_file.hpp"

#include <filesystem>
#include <optional>

namespace microslip::contact_program {

/// The result file of `microslip run`, SI units. `cases/...` have a value for each contact: each case of the input
/// file, and for wheels on rails each of their patches; those of a case that was not solved are NaN, and counts zero.
/// `wheels/...` have what belongs to a wheel as a whole. `elements/...` have the elements that digit A asks for, of all
/// cases one after the other: those of a case begin at cases/first_element. So do `interior/...` with the points inside
/// the bodies that digit S asks for, from cases/first_point on.
class RunFile {
public:
  RunFile(const std::filesystem::path& path, const io::Provenance& provenance);

  void add(const Case& c, const Outcome& outcome);
  void commit() { file_.commit(); }

private:
  /// Origin of a contact.
  struct Origin {
    int number = 0, patch = 0;
    std::optional<PatchLocation> place = {};
  };

  void add_contact(const Case& c, const Outcome& outcome, const Origin& origin);
  void add_wheel(const Case& c, const Outcome& outcome);
  int add_elements(const Case& c, const Outcome& outcome);
  int add_points(const Outcome& outcome);

  io::ResultFile file_;
  double elements_ = 0, points_ = 0; ///< stored so far
};

} // namespace microslip::contact_program
