#include "validation/study.hpp"

#include "validation/fastsim2_table2.hpp"
#include "validation/model_problem.hpp"

#include <algorithm>
#include <array>

namespace microslip::validation {
namespace {

constexpr std::array all_studies = {
    Study{"fastsim2-table2", "Table 2 of the FASTSIM2 paper: discretisation errors on 3,220 cases",
          run_fastsim2_table2},
    Study{"model-problem", "the 1-D model problem of the FASTSIM2 paper: exact solutions and three strategies",
          run_model_problem},
};

} // namespace

std::span<const Study> studies() {
  return all_studies;
}

const Study* find_study(std::string_view name) {
  const auto found =
      std::find_if(all_studies.begin(), all_studies.end(), [name](const Study& s) { return s.name == name; });
  return found == all_studies.end() ? nullptr : &*found;
}

} // namespace microslip::validation
