#include "app/batch.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/option_text.hpp"
#include "app/progress_bar.hpp"
#include "io/contact_table.hpp"
#include "io/nearest_word.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/elliptic_contact.hpp"
#include "microslip/simplified/fastrip.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <omp.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

struct BatchArguments {
  fs::path input, output;
  std::string theory = "fastsim2", grid = "10x10", bound, flexibility;
  std::string coefficients = "kalker", discretisation = "second_order";
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool json = false;
};

/// MXxMY, e.g. 10x10.
void parse_grid(const std::string& text, int largest, int& mx, int& my) {
  const char *begin = text.data(), *end = begin + text.size();
  const auto first = std::from_chars(begin, end, mx);
  const bool has_separator = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second = has_separator ? std::from_chars(first.ptr + 1, end, my) : first;
  if (!has_separator || second.ec != std::errc() || second.ptr != end)
    throw Error("--grid = " + printable(text) + ": must be two whole numbers, e.g. 10x10");
  require_count("--grid", mx, 1, largest);
  require_count("--grid", my, 1, largest);
}

SimplifiedOptions simplified_options(const BatchArguments& arguments, Theory theory) {
  SimplifiedOptions options;
  parse_grid(arguments.grid, 10000, options.mx, options.my);
  set_defaults(theory, options);
  if (!arguments.bound.empty()) options.bound = from_word<TractionBound>("--bound", arguments.bound);
  if (!arguments.flexibility.empty())
    options.flexibility = from_word<FlexibilityModel>("--flexibility", arguments.flexibility);
  options.creepage_table = from_word<CreepageTable>("--coefficients", arguments.coefficients);
  return options;
}

std::vector<EllipticContactSolver> make_exact_solvers(const BatchArguments& arguments) {
  ExactOptions options;
  parse_grid(arguments.grid, 4000, options.mx, options.my);
  options.discretisation = from_word<Discretisation>("--discretisation", arguments.discretisation);
  std::vector<EllipticContactSolver> solvers;
  for (int i = 0; i < arguments.threads; ++i) solvers.emplace_back(options);
  return solvers;
}

std::ifstream open_input(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw Error(path.string() + ": cannot be read: it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path.string() + ": cannot be read: " + std::generic_category().message(errno));
  return file;
}

/// Size of a file, 0 if it has none, as a pipe.
double size_of(const fs::path& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  return error ? 0 : static_cast<double>(size);
}

/// Is told how many bytes of the input are done.
using ReportBytes = std::function<void(std::size_t)>;

/// Solves chunks of a table, several at a time. Results go to the places of the chunks. `report` is told of bytes done,
/// from any thread.
class TableSolver {
public:
  virtual ~TableSolver() = default;
  virtual bool is_exact() const = 0;
  virtual void solve(const ContactTableReader& reader, std::span<const TextChunk> chunks,
                     std::span<std::string> results, const ReportBytes& report) = 0;
  std::size_t contacts() const { return contacts_; }
  std::size_t contacts_unsolved() const { return contacts_unsolved_; }

protected:
  void count(std::span<const ContactForces> forces) {
    contacts_ += forces.size();
    contacts_unsolved_ += static_cast<std::size_t>(
        std::count_if(forces.begin(), forces.end(), [](const auto& result) { return result.status != Status::ok; }));
  }

private:
  std::atomic<std::size_t> contacts_ = 0, contacts_unsolved_ = 0;
};

/// Runs `work(i)` for i below `count` on `threads` threads, and passes on the exception of the lowest i, if any.
template <class Work> void for_each_parallel(std::size_t count, std::size_t threads, const Work& work) {
  std::vector<std::exception_ptr> errors(count);
#pragma omp parallel for schedule(dynamic) num_threads(static_cast <int>(threads))
  for (std::size_t i = 0; i < count; ++i) {
    try {
      work(i);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  }
  for (const auto& error : errors)
    if (error) std::rethrow_exception(error);
}

/// Contacts cost next to nothing: the threads share the chunks. `Solver` is RowSolver or Fastrip.
template <class Solver> class SimplifiedTableSolver : public TableSolver {
public:
  SimplifiedTableSolver(const BatchArguments& arguments, const Solver& solver)
      : solvers_(static_cast<std::size_t>(arguments.threads), solver) {}
  bool is_exact() const override { return false; }

  void solve(const ContactTableReader& reader, std::span<const TextChunk> chunks, std::span<std::string> results,
             const ReportBytes& report) override {
    for_each_parallel(chunks.size(), solvers_.size(), [&](std::size_t i) {
      auto& solver = solvers_[static_cast<std::size_t>(omp_get_thread_num())];
      results[i] = solve(reader.parse(chunks[i]), chunks[i].text.size(), solver, report);
    });
  }

private:
  std::string solve(const ContactRows& rows, std::size_t bytes, Solver& solver, const ReportBytes& report) {
    std::vector<ContactForces> forces(rows.contacts.size());
    // Few enough contacts at a time to see Ctrl-C and to move the bar also on the largest grids.
    const auto cells = static_cast<std::size_t>(solver.options().mx) * static_cast<std::size_t>(solver.options().my);
    const auto step = std::clamp<std::size_t>(1000000 / cells, 1, 256);
    for (std::size_t first = 0; first < forces.size(); first += step) {
      InterruptGuard::throw_if_interrupted();
      const auto count = std::min(step, forces.size() - first);
      solver.solve(std::span(rows.contacts).subspan(first, count), std::span(forces).subspan(first, count));
      report(bytes * count / forces.size());
    }
    count(forces);
    return result_rows(rows, forces);
  }

  std::vector<Solver> solvers_; ///< one for each thread
};

/// Contacts cost much: the threads share those of a chunk.
class ExactTableSolver : public TableSolver {
public:
  explicit ExactTableSolver(const BatchArguments& arguments) : solvers_(make_exact_solvers(arguments)) {}
  bool is_exact() const override { return true; }

  void solve(const ContactTableReader& reader, std::span<const TextChunk> chunks, std::span<std::string> results,
             const ReportBytes& report) override {
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      const auto rows = reader.parse(chunks[c]);
      std::vector<ContactForces> forces(rows.contacts.size());
      std::vector<Iteration> iterations(forces.size());
      for_each_parallel(forces.size(), solvers_.size(), [&](std::size_t i) {
        InterruptGuard::throw_if_interrupted();
        const auto result =
            solvers_[static_cast<std::size_t>(omp_get_thread_num())].solve(rows.contacts[i], {}, [](double) {
              InterruptGuard::throw_if_interrupted();
              return true;
            });
        forces[i] = result.fields.forces;
        iterations[i] = {result.residual, result.newton_steps};
        report(chunks[c].text.size() / forces.size());
      });
      count(forces);
      results[c] = result_rows(rows, forces, iterations);
    }
  }

private:
  std::vector<EllipticContactSolver> solvers_; ///< one for each thread
};

std::unique_ptr<TableSolver> make_solver(const BatchArguments& arguments) {
  const auto theory = from_word<Theory>("--theory", arguments.theory);
  if (theory == Theory::exact) return std::make_unique<ExactTableSolver>(arguments);
  const auto options = simplified_options(arguments, theory);
  if (theory == Theory::fastrip) return std::make_unique<SimplifiedTableSolver<Fastrip>>(arguments, Fastrip(options));
  return std::make_unique<SimplifiedTableSolver<RowSolver>>(arguments, RowSolver(marching_scheme(theory), options));
}

/// Reads, solves and writes a table, a group of chunks at a time.
class Batch {
public:
  explicit Batch(const BatchArguments& arguments)
      : solver_(make_solver(arguments)), input_(open_input(arguments.input)), reader_(input_, arguments.input.string()),
        output_(arguments.output), size_(size_of(arguments.input)), bar_(arguments.input.filename().string()),
        chunks_(32 * static_cast<std::size_t>(arguments.threads)), results_(chunks_.size()) {}

  /// Returns whether every contact could be solved.
  bool run() {
    output_.write(result_header(reader_.columns(), solver_->is_exact()));
    bytes_done_ = reader_.bytes_read();
    while (const auto count = read_group()) {
      solver_->solve(reader_, std::span(chunks_).first(count), std::span(results_).first(count),
                     [&](std::size_t bytes) {
                       bytes_done_ += bytes;
                       if (omp_get_thread_num() == 0 && size_ > 0)
                         bar_.update(static_cast<double>(bytes_done_) / size_);
                     });
      for (std::size_t i = 0; i < count; ++i) output_.write(results_[i]);
      InterruptGuard::throw_if_interrupted();
    }
    output_.commit();
    return solver_->contacts_unsolved() == 0;
  }

  const TableSolver& solver() const { return *solver_; }

private:
  std::size_t read_group() {
    std::size_t count = 0;
    while (count < chunks_.size() && reader_.read(chunks_[count])) ++count;
    return count;
  }

  std::unique_ptr<TableSolver> solver_;
  std::ifstream input_;
  ContactTableReader reader_;
  OutputFile output_;
  double size_;
  ProgressBar bar_;
  std::vector<TextChunk> chunks_;
  std::vector<std::string> results_;
  std::atomic<std::size_t> bytes_done_ = 0;
};

void print_document(const BatchArguments& arguments, const TableSolver& solver) {
  auto document = json_document("batch");
  document["input"] = arguments.input.string();
  document["theory"] = arguments.theory;
  document["grid"] = arguments.grid;
  document["contacts"] = solver.contacts();
  document["contacts_unsolved"] = solver.contacts_unsolved();
  document["files"] = {arguments.output.string()};
  print_json(document);
}

int batch(const BatchArguments& arguments) {
  require_count("--threads", arguments.threads, 1, 1024);
  const InterruptGuard guard;
  Batch work(arguments);
  const bool all_solved = work.run();
  if (arguments.json) print_document(arguments, work.solver());
  if (all_solved) return ExitCode::done;
  fmt::print(stderr, "microslip: warning: {}: {} of {} contacts are not solved, see their status\n",
             arguments.output.string(), work.solver().contacts_unsolved(), work.solver().contacts());
  return ExitCode::not_met;
}

} // namespace

void add_batch_command(CLI::App& program, int& exit_code) {
  auto* command = program.add_subcommand("batch", "Forces of many contacts, from CSV to CSV");
  const auto arguments = std::make_shared<BatchArguments>();
  const auto option = [&](const char* name, std::string& value, const std::string& type, const char* what) {
    command->add_option(name, value, what)->type_name(type)->capture_default_str();
  };
  command->add_option("IN.csv", arguments->input, "table of contacts")->required()->type_name("");
  command->add_option("-o,--output", arguments->output, "table of results")->required()->type_name("OUT.csv");
  option("--theory", arguments->theory, choices<Theory>(), "what the contacts are solved by");
  option("--grid", arguments->grid, "MXxMY", "cells or elements across the ellipse along x and y");
  option("--bound", arguments->bound, choices<TractionBound>(),
         "traction bound of the simplified theory; default: parabolic, with fastrip elliptic");
  option("--flexibility", arguments->flexibility, choices<FlexibilityModel>(),
         "flexibilities of the simplified theory; default: three, with fastrip blended");
  option("--coefficients", arguments->coefficients, choices<CreepageTable>(), "table of creepage coefficients");
  option("--discretisation", arguments->discretisation, choices<Discretisation>(), "of the exact theory");
  command
      ->add_option("--threads", arguments->threads,
                   "threads, 1 to 1024; results do not depend on it; default: one for each processor")
      ->type_name("COUNT");
  add_json_flag(*command, arguments->json);
  command->footer(
      "IN.csv names its columns in the first line, in any order: a [m], b [m], shear_modulus [Pa], poisson_ratio [-],\n"
      "friction [-], normal_force [N], creep_x [-], creep_y [-], spin [1/m]. OUT.csv repeats them and adds fx [N],\n"
      "fy [N], mz [N m], adhesion_area [m^2], slip_area [m^2], status, and with --theory exact residual [-] and\n"
      "iterations. Forces act on body 1. A bad row is named by line and column, and OUT.csv appears only when it is\n"
      "complete. With --json the numbers of contacts and of those not solved. Exit code 1: some contacts have another\n"
      "status than ok.\n\n"
      "Example:\n  microslip batch contacts.csv -o forces.csv --theory fastsim2 --grid 10x10");
  command->callback([arguments, &exit_code] { exit_code = batch(*arguments); });
}

} // namespace microslip
