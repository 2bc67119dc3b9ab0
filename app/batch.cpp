#include "app/commands.hpp"

#include "app/exit_code.hpp"
#include "app/input_options.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/option_text.hpp"
#include "app/progress_bar.hpp"
#include "io/contact_table.hpp"
#include "io/creep_table_file.hpp"
#include "io/csv_line.hpp"
#include "io/input_file.hpp"
#include "io/nearest_word.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "microslip/batch/batch.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/method.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastrip.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct BatchArguments {
  fs::path input, output; ///< "-": standard input and output
  fs::path errors;        ///< empty: none are listed
  bool skip_bad = false;
  fs::path table; ///< empty: the table that microslip has
  InputOptions solution{description::rolling_inputs(), "solution"}, motion{description::rolling_inputs(), "motion"};
  std::string theory, direction, precision = "double";
  std::string grid;                             ///< empty: not given
  std::string bound, flexibility, coefficients; ///< of the simplified theory; empty: not given
  std::string discretisation, elements;         ///< of the exact theory; empty: not given
  std::optional<double> tolerance;              ///< of the exact theory
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool json = false;
};

/// MXxMY, e.g. 10x20, or M for both directions.
void parse_grid(const std::string& text, int largest, int& mx, int& my) {
  const char *begin = text.data(), *end = begin + text.size();
  auto number = std::from_chars(begin, end, mx);
  my = mx;
  if (number.ec == std::errc() && number.ptr != end && *number.ptr == 'x')
    number = std::from_chars(number.ptr + 1, end, my);
  if (number.ec != std::errc() || number.ptr != end)
    throw Error("--grid = " + io::printable(text) + ": must be one or two whole numbers, e.g. 10 or 10x20");
  require_count("--grid", mx, 1, largest);
  require_count("--grid", my, 1, largest);
}

std::string grid_of(const BatchArguments& arguments) {
  return arguments.grid.empty() ? "10x10" : arguments.grid;
}

using Given = std::pair<const char*, bool>;

/// Options that the theory does not have are refused.
void refuse(std::initializer_list<Given> options, const char* reason) {
  for (const auto& [name, is_given] : options)
    if (is_given) throw Error(std::string(name) + ": " + reason);
}

template <class Option> void read(const char* name, const std::string& word, std::optional<Option>& option) {
  if (!word.empty()) option = io::from_word<Option>(name, word);
}

/// The method with what is given only.
Method method_of(const BatchArguments& arguments) {
  Method method{.theory = io::from_word<Theory>("--theory", arguments.theory)};
  const bool exact = method.theory == Theory::exact;
  if (exact)
    refuse({{"--bound", !arguments.bound.empty()},
            {"--flexibility", !arguments.flexibility.empty()},
            {"--coefficients", !arguments.coefficients.empty()}},
           "needs the simplified theory, e.g. --theory fastsim2");
  else
    refuse({{"--tolerance", arguments.tolerance.has_value()}}, "needs --theory exact");
  parse_grid(grid_of(arguments), exact ? most_elements : most_cells, method.mx, method.my);
  read("--bound", arguments.bound, method.bound);
  read("--flexibility", arguments.flexibility, method.flexibility);
  read("--discretisation", arguments.discretisation, method.discretisation);
  read("--elements", arguments.elements, method.elements);
  if (!arguments.coefficients.empty())
    method.coefficients = io::from_word<CreepageTable>("--coefficients", arguments.coefficients);
  method.precision = io::from_word<Precision>("--precision", arguments.precision);
  method.tolerance = arguments.tolerance.value_or(method.tolerance);
  return method;
}

bool is_standard(const fs::path& path) {
  return path == "-";
}

fs::path input_file(const BatchArguments& arguments) {
  return is_standard(arguments.input) ? "/dev/stdin" : arguments.input;
}

std::string input_name(const BatchArguments& arguments) {
  return is_standard(arguments.input) ? "standard input" : arguments.input.string();
}

fs::path output_file(const fs::path& path) {
  return is_standard(path) ? "/dev/stdout" : path;
}

/// A file, or standard input.
class Input {
public:
  explicit Input(const fs::path& path) {
    if (!is_standard(path)) file_ = io::open_input(path);
  }
  std::istream& stream() { return file_.is_open() ? file_ : std::cin; }

private:
  std::ifstream file_;
};

/// Size of a file, 0 if it has none, as a pipe.
double size_of(const fs::path& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  return error ? 0 : static_cast<double>(size);
}

/// Treatment of bad rows.
enum class BadRows {
  stop, ///< the first one ends the batch
  list, ///< all are found; with one of them nothing is solved
  skip  ///< they are left out
};

/// Parses chunks on several threads at a time.
class RowParser {
public:
  RowParser(const io::ContactTableReader& reader, BadRows bad_rows) : reader_(reader), bad_rows_(bad_rows) {}

  io::TableRows parse(const io::TextChunk& chunk) {
    io::TableRows rows = reader_.parse(chunk);
    if (bad_rows_ == BadRows::stop && !rows.bad.empty()) throw Error(reader_.message(rows.bad.front()));
    if (!rows.bad.empty()) has_bad_ = true;
    if (!rows.implausible.empty()) remember(rows.implausible);
    if (bad_rows_ == BadRows::list && has_bad_) return {.bad = std::move(rows.bad)};
    return rows;
  }
  const std::map<Warning, io::ImplausibleRows>& implausible() const { return implausible_; }

private:
  void remember(const std::map<Warning, io::ImplausibleRows>& found) {
    const std::lock_guard lock(implausible_mutex_);
    for (const auto& [warning, rows] : found) {
      io::ImplausibleRows& all = implausible_[warning];
      if (all.count == 0 || rows.first.line < all.first.line) all.first = rows.first;
      all.count += rows.count;
    }
  }

  const io::ContactTableReader& reader_;
  BadRows bad_rows_;
  std::atomic<bool> has_bad_ = false;
  std::mutex implausible_mutex_;
  std::map<Warning, io::ImplausibleRows> implausible_;
};

/// Result of a chunk of a table.
struct ChunkResult {
  std::string csv;
  std::vector<io::BadRow> bad;
};

/// Solves chunks of a table by one batch. Results are stored by the index of the chunks; if `progress` ends the batch
/// they mean nothing.
class TableSolver {
public:
  virtual ~TableSolver() = default;
  virtual bool is_exact() const = 0;
  virtual void solve(RowParser& parser, std::span<const io::TextChunk> chunks, std::span<ChunkResult> results,
                     const Progress& progress) = 0;
  std::size_t contacts() const { return contacts_; }
  std::size_t contacts_unsolved() const { return contacts_unsolved_; }
  /// Error of the first contact that could not even be begun; else empty.
  const std::string& first_error() const { return first_error_; }

protected:
  void count(std::span<const ContactForces> forces) {
    contacts_ += forces.size();
    contacts_unsolved_ += static_cast<std::size_t>(
        std::count_if(forces.begin(), forces.end(), [](const auto& result) { return result.status != Status::ok; }));
  }
  void remember(const std::string& error) {
    if (first_error_.empty()) first_error_ = error;
  }

private:
  std::atomic<std::size_t> contacts_ = 0, contacts_unsolved_ = 0;
  std::string first_error_;
};

/// Cells that a contact costs the work of.
std::size_t cells_of(const CreepForceTable&) {
  return 100;
}
template <class Solver> std::size_t cells_of(const Solver& solver) {
  return static_cast<std::size_t>(solver.options().mx) * static_cast<std::size_t>(solver.options().my);
}

/// Contacts cost next to nothing: the threads share the chunks of text. `Solver` is RowSolver, Fastrip or
/// CreepForceTable.
template <class Solver> class SimplifiedTableSolver : public TableSolver {
public:
  SimplifiedTableSolver(int threads, Solver solver) : threads_(threads), solver_(std::move(solver)) {}
  bool is_exact() const override { return false; }

  void solve(RowParser& parser, std::span<const io::TextChunk> chunks, std::span<ChunkResult> results,
             const Progress& progress) override {
    run_batch(chunks.size(), {.threads = threads_, .progress = progress}, [&]() -> BatchWorker {
      return [&, own = solver_](std::size_t i, std::size_t, const Progress& of_chunk) mutable {
        io::TableRows rows = parser.parse(chunks[i]);
        results[i] = {solve(rows, own, of_chunk), std::move(rows.bad)};
      };
    });
  }

private:
  std::string solve(const io::TableRows& rows, Solver& solver, const Progress& progress) {
    std::vector<ContactForces> forces(rows.contacts.size());
    // Few enough contacts at a time to see Ctrl-C and to move the bar also on the largest grids.
    const auto step = std::clamp<std::size_t>(1000000 / cells_of(solver), 1, 256);
    for (std::size_t first = 0; first < forces.size(); first += step) {
      if (!progress(static_cast<double>(first) / static_cast<double>(forces.size()))) return {};
      const auto count = std::min(step, forces.size() - first);
      solver.solve(std::span(rows.contacts).subspan(first, count), std::span(forces).subspan(first, count));
    }
    count(forces);
    return io::result_rows(rows, forces);
  }

  int threads_;
  Solver solver_;
};

/// Contacts cost much: the threads share them one by one.
class ExactTableSolver : public TableSolver {
public:
  ExactTableSolver(int threads, const Method& method, const Motion& motion)
      : threads_(threads), method_(method), motion_(motion) {
    const Solver checked(method);
  }
  bool is_exact() const override { return true; }

  void solve(RowParser& parser, std::span<const io::TextChunk> chunks, std::span<ChunkResult> results,
             const Progress& progress) override {
    std::vector<io::TableRows> tables;
    std::vector<const EllipticContact*> rows;
    for (const io::TextChunk& chunk : chunks) tables.push_back(parser.parse(chunk));
    for (const io::TableRows& table : tables)
      for (const EllipticContact& contact : table.contacts) rows.push_back(&contact);
    std::vector<ContactForces> forces(rows.size());
    std::vector<io::Iteration> iterations(rows.size());
    const BatchOptions batch = {.threads = threads_, .progress = progress, .keep_errors = true};
    const auto report = run_batch(rows.size(), batch, [&]() -> BatchWorker {
      return [&, own = std::make_shared<Solver>(method_)](std::size_t i, std::size_t, const Progress& of_row) {
        const ContactSolution result = own->solve(rolling_problem(*rows[i], motion_), of_row);
        forces[i] = result.forces();
        iterations[i] = {result.report.residual, result.report.newton_steps};
      };
    });
    for (const BatchError& error : report.errors) {
      forces[error.first] = {nan, nan, nan, nan, nan, Status::invalid_input};
      iterations[error.first].residual = nan;
      remember(error.reason);
    }
    count(forces);
    std::size_t first = 0;
    for (std::size_t c = 0; c < chunks.size(); first += tables[c].contacts.size(), ++c) {
      const std::size_t n = tables[c].contacts.size();
      results[c] = {
          io::result_rows(tables[c], std::span(forces).subspan(first, n), std::span(iterations).subspan(first, n)),
          std::move(tables[c].bad)};
    }
  }

private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  int threads_;
  Method method_;
  Motion motion_;
};

/// Contact like every row of the table, except for what its columns say.
RollingProblem any_contact(const BatchArguments& arguments) {
  RollingProblem any;
  any.motion.direction = io::from_word<RollingDirection>("--direction", arguments.direction);
  return any;
}

/// Refuses options that cannot be combined. Of interpolation only the direction of rolling may be said.
void check_options(const BatchArguments& arguments) {
  if (arguments.theory == "table") {
    refuse({{"--bound", !arguments.bound.empty()},
            {"--flexibility", !arguments.flexibility.empty()},
            {"--coefficients", !arguments.coefficients.empty()},
            {"--grid", !arguments.grid.empty()},
            {"--discretisation", !arguments.discretisation.empty()},
            {"--elements", !arguments.elements.empty()},
            {"--precision", arguments.precision != "double"},
            {"--tolerance", arguments.tolerance.has_value()}},
           "cannot be combined with --theory table");
    any_contact(arguments);
    return;
  }
  refuse({{"--table", !arguments.table.empty()}}, "needs --theory table");
  const auto found = incompatibilities(any_contact(arguments), method_of(arguments));
  if (!found.empty()) throw Error(found.front().message(KeyStyle::option));
}

std::unique_ptr<TableSolver> make_solver(const BatchArguments& arguments) {
  const int threads = arguments.threads;
  const RollingProblem any = any_contact(arguments);
  if (arguments.theory == "table") {
    const CreepTableSource source = io::creep_table_source(io::creep_table_or_shipped(arguments.table));
    return std::make_unique<SimplifiedTableSolver<CreepForceTable>>(threads,
                                                                    CreepForceTable(source, any.motion.direction));
  }
  const Method method = method_of(arguments);
  if (method.theory == Theory::exact) return std::make_unique<ExactTableSolver>(threads, method, any.motion);
  const auto options = simplified_options(method, any.motion.direction);
  if (method.theory == Theory::fastrip)
    return std::make_unique<SimplifiedTableSolver<Fastrip>>(threads, Fastrip(options));
  return std::make_unique<SimplifiedTableSolver<RowSolver>>(threads,
                                                            RowSolver(marching_scheme(method.theory), options));
}

/// Bad rows in a separate file, if one is named.
class ErrorList {
public:
  explicit ErrorList(const fs::path& path) {
    if (path.empty()) return;
    file_.emplace(output_file(path));
    file_->write("line,error\n");
  }

  void add(const io::BadRow& row) {
    if (file_) file_->write(std::to_string(row.line) + "," + io::csv_field(row.reason) + "\n");
  }
  void commit() {
    if (file_) file_->commit();
  }

private:
  std::optional<io::OutputFile> file_;
};

/// Reads, solves and writes a table, a group of chunks at a time.
class Batch {
public:
  explicit Batch(const BatchArguments& arguments)
      : input_(arguments.input), reader_(input_.stream(), input_name(arguments)),
        bad_rows_(arguments.skip_bad         ? BadRows::skip
                  : arguments.errors.empty() ? BadRows::stop
                                             : BadRows::list),
        parser_(reader_, bad_rows_), output_(output_file(arguments.output)), errors_(arguments.errors),
        solver_(make_solver(arguments)), size_(size_of(arguments.input)), bar_(arguments.input.filename().string()),
        chunks_(32 * static_cast<std::size_t>(arguments.threads)), results_(chunks_.size()),
        errors_file_(arguments.errors.string()) {
    if (!solver_->is_exact()) reader_.refuse_dissimilar_bodies("unless --theory is exact");
    if (arguments.discretisation == "second_order")
      reader_.refuse_dissimilar_bodies("with --discretisation second_order; dissimilar bodies are solved classically");
  }

  /// Returns whether every contact could be solved.
  bool run() {
    output_.write(io::result_header(reader_.columns(), solver_->is_exact()));
    std::size_t begin = reader_.bytes_read();
    while (const auto count = read_group()) {
      const std::size_t end = reader_.bytes_read();
      solver_->solve(parser_, std::span(chunks_).first(count), std::span(results_).first(count), [&](double fraction) {
        if (size_ > 0) bar_.update((double(begin) + fraction * double(end - begin)) / size_);
        return !InterruptGuard::interrupted();
      });
      InterruptGuard::throw_if_interrupted();
      for (std::size_t i = 0; i < count; ++i) write(results_[i]);
      begin = end;
    }
    errors_.commit();
    if (bad_rows_ != BadRows::skip && bad_count_ > 0) throw Error(bad_message());
    output_.commit();
    return solver_->contacts_unsolved() == 0;
  }

  const TableSolver& solver() const { return *solver_; }
  std::size_t bad_count() const { return bad_count_; }
  /// The first bad row, and where to find the others.
  std::string bad_message() const {
    return fmt::format("{}; {} bad {} in all{}", first_bad_, bad_count_, bad_count_ == 1 ? "row" : "rows",
                       errors_file_.empty() ? "" : ", listed in " + errors_file_);
  }

  /// Messages on contacts that are hardly what is meant: the first and their number for each reason.
  std::vector<std::string> implausible_messages() const {
    std::vector<std::string> all;
    for (const auto& [warning, rows] : parser_.implausible())
      all.push_back(fmt::format("{}; {} such {} in all", reader_.message(rows.first), rows.count,
                                rows.count == 1 ? "row" : "rows"));
    return all;
  }

private:
  std::size_t read_group() {
    std::size_t count = 0;
    while (count < chunks_.size() && reader_.read(chunks_[count])) ++count;
    return count;
  }

  void write(const ChunkResult& result) {
    output_.write(result.csv);
    for (const io::BadRow& row : result.bad) {
      if (bad_count_++ == 0) first_bad_ = reader_.message(row);
      errors_.add(row);
    }
  }

  Input input_;
  io::ContactTableReader reader_;
  BadRows bad_rows_;
  RowParser parser_;
  io::OutputFile output_;
  ErrorList errors_;
  std::unique_ptr<TableSolver> solver_; ///< made when the table's header and the output are known to be good
  double size_;
  ProgressBar bar_;
  std::vector<io::TextChunk> chunks_;
  std::vector<ChunkResult> results_;
  std::size_t bad_count_ = 0;
  std::string first_bad_, errors_file_;
};

void print_document(const BatchArguments& arguments, const Batch& work) {
  auto document = json_document("batch");
  document["input"] = arguments.input.string();
  document["theory"] = arguments.theory;
  if (arguments.theory != "table") document["grid"] = grid_of(arguments);
  document["contacts"] = work.solver().contacts();
  document["contacts_unsolved"] = work.solver().contacts_unsolved();
  document["bad_rows"] = work.bad_count();
  document["files"] = {arguments.output.string()};
  if (!arguments.errors.empty()) document["files"].push_back(arguments.errors.string());
  print_json(document);
}

void check_files(const BatchArguments& arguments) {
  if (is_standard(arguments.output) && arguments.json) throw Error("--json needs a file for --output");
  for (const fs::path& file : {arguments.output, arguments.errors})
    if (!is_standard(file)) io::require_other_file(file, input_file(arguments));
  if (arguments.errors == arguments.output ||
      io::is_same_output(output_file(arguments.errors), output_file(arguments.output)))
    throw Error("--errors and --output must be different files");
}

int batch(const BatchArguments& arguments) {
  check_files(arguments);
  require_count("--threads", arguments.threads, 1, most_threads);
  arguments.solution.require();
  arguments.motion.require();
  check_options(arguments);
  Batch work(arguments);
  const bool all_solved = work.run();
  if (arguments.json) print_document(arguments, work);
  for (const std::string& text : work.implausible_messages()) fmt::print(stderr, "microslip: warning: {}\n", text);
  if (work.bad_count() > 0)
    fmt::print(stderr, "microslip: warning: {}: left out: {}\n", arguments.output.string(), work.bad_message());
  if (all_solved) return work.bad_count() > 0 ? ExitCode::not_met : ExitCode::done;
  fmt::print(stderr, "microslip: warning: {}: {} of {} contacts are not solved, see their status{}\n",
             arguments.output.string(), work.solver().contacts_unsolved(), work.solver().contacts(),
             work.solver().first_error().empty() ? "" : "; " + work.solver().first_error());
  return ExitCode::not_met;
}

constexpr const char* footer =
    R"(IN.csv names its columns in the first line, in any order: a [m], b [m], shear_modulus [Pa], poisson_ratio [-],
friction [-], normal_force [N], creepage_longitudinal [-], creepage_lateral [-], spin [1/m]. It may have
dissimilarity [-], the combined K of bodies of different materials, which needs --theory exact, and
rolling_speed [m/s], which forces under a constant coefficient of friction do not depend on. Behind a name
there may be another unit: normal_force [kN]. Commas, semicolons or tabs separate columns; with the latter two
numbers may have decimal commas. OUT.csv has commas and points, repeats these and any further columns, and adds
fx [N], fy [N], mz [N m], adhesion_area [m^2], slip_area [m^2], status, and with --theory exact residual [-]
and iterations; those that IN.csv has of these are replaced. Forces act on body 1. A bad row is named by line
and column, and OUT.csv appears only when it is complete. With --json the numbers of contacts, of those not
solved and of bad rows. Exit code 1: some contacts have another status than ok, or rows were left out.

Example:
  microslip batch contacts.csv -o forces.csv --theory fastsim2 --grid 10x10)";

} // namespace

void add_batch_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand("batch", "Forces of many contacts, from CSV to CSV", footer);
  BatchArguments& arguments = command.arguments(exit_code, batch);
  command.add_option("IN.csv", arguments.input, "table of contacts; -: standard input").required();
  command.add_option("-o,--output OUT.csv", arguments.output, "table of results; -: standard output").required();
  command.add_option("--errors FILE.csv", arguments.errors,
                     "list of all bad rows: line and what is wrong; without --skip-bad nothing else is written then");
  command.add_flag("--skip-bad", arguments.skip_bad, "leave bad rows out of OUT.csv");
  InputOptions& solution = arguments.solution;
  solution.add(command, "theory", arguments.theory);
  command.add_option("--table FILE", arguments.table,
                     "a creep-force table made by `microslip table make`; default: the one that microslip has");
  command.add_option("--grid MXxMY", arguments.grid,
                     solution.text("grid") + ", or M of both; default: " + grid_of(arguments));
  solution.add(command, "bound", arguments.bound, "", true);
  solution.add(command, "flexibility", arguments.flexibility, "", true);
  solution.add(command, "coefficients", arguments.coefficients, "", true);
  command
      .add_option("--precision " + choices<Precision>(), arguments.precision,
                  "of FASTSIM and FASTSIM2: single takes about half the time, forces are accurate to 1e-5 of mu Fn")
      .capture_default_str();
  arguments.motion.add(command, "direction", arguments.direction);
  solution.add(command, "discretisation", arguments.discretisation, "", true);
  solution.add(command, "elements", arguments.elements, "", true);
  solution.add(command, "tolerance", arguments.tolerance);
  command.add_option("--threads COUNT", arguments.threads,
                     "threads, 1 to 1024; results do not depend on it; default: one for each processor");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
