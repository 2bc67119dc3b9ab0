#pragma once

#include "c/guarded_call.hpp"
#include "io/case_inputs.hpp"
#include "microslip/progress.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace microslip::c {

/// Outcome of a solve.
struct Ending {
  Status status = Status::ok;
  std::string reason = {}; ///< why it is not ok
};

/// Number of values of a field.
struct FieldSize {
  std::size_t columns, rows;
};

/// Solution of a kind of case, with the solver that is kept for the next time.
class SolvedCase {
public:
  virtual ~SolvedCase() = default;

  /// Throws Error for inputs that the readers of cases refuse, which leaves what was solved before.
  virtual Ending solve(const io::CaseInputs& inputs, const Progress& progress) = 0;
  /// Solves with the derivatives of fx, fy, mz by xi, eta, phi, row by row; NaN where there is no result.
  virtual Ending differentiate(const io::CaseInputs& inputs, const Progress& progress, std::span<double, 9> jacobian);
  /// A number of what was solved last. Throws Error for an unknown name, Refusal where there is none.
  virtual double number(std::string_view name) const = 0;
  /// Its fields. Throw likewise, and Refusal for values of the wrong count.
  virtual FieldSize field_size(std::string_view name) const = 0;
  virtual void copy_field(std::string_view name, std::span<double> values) = 0;
};

/// Solvers of cases with two bodies, a wheel, or a wheelset.
std::unique_ptr<SolvedCase> solved_bodies();
std::unique_ptr<SolvedCase> solved_wheel();
std::unique_ptr<SolvedCase> solved_wheelset();

} // namespace microslip::c

struct microslip_problem {
  explicit microslip_problem(microslip::io::CaseInputs given);

  microslip::io::CaseInputs inputs;
  std::unique_ptr<microslip::c::SolvedCase> solved;
  int (*progress)(double fraction, void* data) = nullptr;
  void* progress_data = nullptr;
  mutable microslip::c::InUse in_use = false;
};
