#pragma once

#include "validation/report.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace microslip::validation {

/// What the validation report states, and where its figures are.
struct Clause {
  std::string_view number, text;
  std::string_view study;        ///< whose figures show it; empty: none
  std::string_view section = {}; ///< how the headings of these figures begin; empty: all figures of the study
  std::string_view note = {};    ///< what stands beside it; why it is not examined where no study is
};

/// Clauses that rest on one source.
struct ClauseGroup {
  std::string_view title, source;
  std::span<const Clause> clauses;
};

std::span<const ClauseGroup> clause_groups();

enum class Verdict {
  passed,
  passed_with_known_limits, ///< figures that miss their mark keep to a limit that the documentation states
  failed,
  only_shown,   ///< it has figures, of which none is judged
  not_examined, ///< no study shows it, or the one that does was not run, or lacked its data
};

struct ClauseResult {
  Verdict verdict = Verdict::not_examined;
  int judged = 0, met = 0, known = 0; ///< numbers of figures
};

/// From all figures of the clause's study.
ClauseResult judge(const Clause& clause, std::span<const Figure> figures);

} // namespace microslip::validation
