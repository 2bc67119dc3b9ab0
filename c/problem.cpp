#include "c/problem.hpp"
#include "microslip/description/words.hpp"

#include <algorithm>
#include <variant>
#include <vector>

using namespace microslip;
using namespace microslip::c;

namespace {

std::unique_ptr<SolvedCase> solved_case(std::string_view kind) {
  if (kind == description::case_kinds[MICROSLIP_BODIES]) return solved_bodies();
  return kind == description::case_kinds[MICROSLIP_WHEEL] ? solved_wheel() : solved_wheelset();
}
static_assert(description::case_kinds.size() == MICROSLIP_WHEELSET + 1);

/// Sets an input; `value` makes the library's form of what the caller gives.
template <class Make>
microslip_code set(microslip_problem* problem, const char* path, microslip_error* error, const Make& value) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("path", path);
    problem->inputs.set(path, value());
  });
}

/// Gets an input that is of one kind; another one than `what` is refused.
template <class Value> Value get(const microslip_problem& problem, const char* path, const char* what) {
  const auto found = problem.inputs.get(require_pointer("path", path));
  if (!found) throw Refusal(MICROSLIP_NO_RESULT, std::string(path) + ": is not set, and has no default");
  if (const auto* value = std::get_if<Value>(&*found)) return *value;
  throw Error(std::string(path) + ": is no " + what);
}

/// Runs `solve` with the caller's progress function, and reports how it ended.
template <class Solve> microslip_code run(microslip_problem& problem, microslip_error* error, const Solve& solve) {
  bool stopped = false;
  Progress progress;
  if (problem.progress)
    progress = [&](double fraction) {
      stopped = stopped || problem.progress(fraction, problem.progress_data) != 0;
      return !stopped;
    };
  Ending ending = solve(progress);
  if (!stopped) return report(error, code_of(ending.status), ending.reason);
  // Fewer steps than wanted may each have converged.
  const Status status = ending.status == Status::ok ? Status::not_converged : ending.status;
  return report(error, code_of(status), "ended by the caller's progress function");
}

} // namespace

microslip_problem::microslip_problem(io::CaseInputs given)
    : inputs(std::move(given)), solved(solved_case(inputs.kind())) {}

Ending SolvedCase::differentiate(const io::CaseInputs&, const Progress&, std::span<double, 9>) {
  throw Error("derivatives: of two bodies; microslip_wheel_rail_differentiate has those of a wheel on a rail");
}

microslip_code microslip_problem_create(int kind, microslip_problem** problem, microslip_error* error) {
  return guarded(error, [&] {
    *require_pointer("problem", problem) = nullptr;
    require_count("kind", kind, MICROSLIP_BODIES, MICROSLIP_WHEELSET);
    *problem = new microslip_problem(io::CaseInputs(description::case_kinds[static_cast<std::size_t>(kind)]));
  });
}

microslip_code microslip_problem_read(const char* text, const char* name, microslip_problem** problem,
                                      microslip_error* error) {
  return guarded(error, [&] {
    *require_pointer("problem", problem) = nullptr;
    *problem =
        new microslip_problem(io::CaseInputs::read(require_pointer("text", text), require_pointer("name", name)));
  });
}

void microslip_problem_destroy(microslip_problem* problem) {
  delete problem;
}

microslip_code microslip_problem_text(const microslip_problem* problem, char** text, microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("text", text);
    *text = text_copy(problem->inputs.text());
  });
}

microslip_code microslip_set(microslip_problem* problem, const char* path, double value, microslip_error* error) {
  return set(problem, path, error, [&] { return value; });
}

microslip_code microslip_set_text(microslip_problem* problem, const char* path, const char* value,
                                  microslip_error* error) {
  return set(problem, path, error, [&] { return std::string(require_pointer("value", value)); });
}

microslip_code microslip_set_array(microslip_problem* problem, const char* path, size_t count, const double* values,
                                   microslip_error* error) {
  return set(problem, path, error, [&] {
    if (count > 0) require_pointer("values", values);
    return std::vector<double>(values, values + count);
  });
}

microslip_code microslip_unset(microslip_problem* problem, const char* path, microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] { problem->inputs.unset(require_pointer("path", path)); });
}

microslip_code microslip_get(const microslip_problem* problem, const char* path, double* value,
                             microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("value", value);
    *value = get<double>(*problem, path, "number");
  });
}

microslip_code microslip_get_text(const microslip_problem* problem, const char* path, char** value,
                                  microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("value", value);
    *value = text_copy(get<std::string>(*problem, path, "text"));
  });
}

microslip_code microslip_get_array(const microslip_problem* problem, const char* path, size_t capacity, double* values,
                                   size_t* count, microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("count", count);
    const auto found = get<std::vector<double>>(*problem, path, "list of numbers");
    *count = found.size();
    if (!values) return;
    require_at_most("count", found.size(), capacity);
    std::ranges::copy(found, values);
  });
}

microslip_code microslip_set_progress(microslip_problem* problem, int (*progress)(double fraction, void* data),
                                      void* data, microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    problem->progress = progress;
    problem->progress_data = data;
  });
}

microslip_code microslip_solve(microslip_problem* problem, microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    return run(*problem, error,
               [&](const Progress& progress) { return problem->solved->solve(problem->inputs, progress); });
  });
}

microslip_code microslip_differentiate(microslip_problem* problem, size_t count, double* jacobian,
                                       microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("jacobian", jacobian);
    require_size("count", count, 9);
    return run(*problem, error, [&](const Progress& progress) {
      return problem->solved->differentiate(problem->inputs, progress, std::span<double, 9>(jacobian, 9));
    });
  });
}

microslip_code microslip_number(const microslip_problem* problem, const char* name, double* value,
                                microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("value", value);
    *value = problem->solved->number(require_pointer("name", name));
  });
}

microslip_code microslip_field_size(const microslip_problem* problem, const char* name, size_t* columns, size_t* rows,
                                    microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("columns", columns), require_pointer("rows", rows);
    const FieldSize size = problem->solved->field_size(require_pointer("name", name));
    *columns = size.columns;
    *rows = size.rows;
  });
}

microslip_code microslip_field(microslip_problem* problem, const char* name, size_t count, double* values,
                               microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    require_pointer("name", name);
    problem->solved->copy_field(name, {require_pointer("values", values), count});
  });
}
