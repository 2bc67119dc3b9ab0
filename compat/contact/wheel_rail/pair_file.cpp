#include "compat/contact/wheel_rail/pair_file.hpp"

#include "compat/contact/wheel_rail/case_reader.hpp"

#include <filesystem>
#include <limits>

namespace microslip::contact_program {

Case read_pair(std::istream& stream, const std::string& name, const Case& before) {
  Words words(stream, name);
  constexpr int pair_module = 11;
  const int module = words.integer("MODULE", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  if (module != 0 && module != pair_module) words.fail("MODULE", module, "must be 11");
  words.end_record();
  CaseSequence sequence{before, true, true, true, true};
  WheelRailReader(words, std::filesystem::path(name).parent_path().string(), sequence).read_pair();
  return sequence.last;
}

} // namespace microslip::contact_program
