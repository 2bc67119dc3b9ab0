#include "app/batch.hpp"

#include "app/interrupt.hpp"
#include "app/progress_bar.hpp"
#include "io/contact_table.hpp"
#include "io/nearest_word.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
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
  std::string theory = "fastsim2", grid = "10x10", bound = "parabolic", flexibility = "three";
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

/// MXxMY, e.g. 10x10.
void parse_grid(const std::string& text, SimplifiedOptions& options) {
  const char *begin = text.data(), *end = begin + text.size();
  const auto mx = std::from_chars(begin, end, options.mx);
  const bool has_separator = mx.ec == std::errc() && mx.ptr != end && *mx.ptr == 'x';
  const auto my = has_separator ? std::from_chars(mx.ptr + 1, end, options.my) : mx;
  if (!has_separator || my.ec != std::errc() || my.ptr != end)
    throw Error("--grid = " + printable(text) + ": must be two whole numbers, e.g. 10x10");
  require_count("--grid", options.mx, 1, 10000);
  require_count("--grid", options.my, 1, 10000);
}

RowSolver make_solver(const BatchArguments& arguments) {
  SimplifiedOptions options;
  parse_grid(arguments.grid, options);
  options.bound = from_word<TractionBound>("--bound", arguments.bound);
  options.flexibility = from_word<FlexibilityModel>("--flexibility", arguments.flexibility);
  return {from_word<MarchingScheme>("--theory", arguments.theory), options};
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

/// Reads, solves and writes a table, a group of chunks at a time: the threads share the chunks of a group.
class Batch {
public:
  Batch(const BatchArguments& arguments)
      : solvers_(static_cast<std::size_t>(arguments.threads), make_solver(arguments)),
        input_(open_input(arguments.input)), reader_(input_, arguments.input.string()), output_(arguments.output),
        size_(size_of(arguments.input)), bar_(arguments.input.filename().string()), chunks_(32 * solvers_.size()),
        results_(chunks_.size()), errors_(chunks_.size()) {}

  /// Returns whether every contact could be solved.
  bool run() {
    output_.write(result_header(reader_.columns()));
    bytes_done_ = reader_.bytes_read();
    while (const auto count = read_group()) {
      solve_group(count);
      for (std::size_t i = 0; i < count; ++i) {
        if (errors_[i]) std::rethrow_exception(errors_[i]);
        output_.write(results_[i]);
      }
      InterruptGuard::throw_if_interrupted();
    }
    output_.commit();
    return contacts_unsolved_ == 0;
  }

  std::size_t contacts() const { return contacts_; }
  std::size_t contacts_unsolved() const { return contacts_unsolved_; }

private:
  std::size_t read_group() {
    std::size_t count = 0;
    while (count < chunks_.size() && reader_.read(chunks_[count])) ++count;
    return count;
  }

  void solve_group(std::size_t count) {
#pragma omp parallel for schedule(dynamic) num_threads(static_cast <int>(solvers_.size()))
    for (std::size_t i = 0; i < count; ++i) {
      try {
        results_[i] = solve(chunks_[i], solvers_[static_cast<std::size_t>(omp_get_thread_num())]);
      } catch (...) {
        errors_[i] = std::current_exception();
      }
    }
  }

  std::string solve(const TextChunk& chunk, RowSolver& solver) {
    const auto rows = reader_.parse(chunk);
    std::vector<ContactForces> forces(rows.contacts.size());
    // Few enough contacts at a time to see Ctrl-C and to move the bar also on the largest grids.
    const auto cells = static_cast<std::size_t>(solver.options().mx) * static_cast<std::size_t>(solver.options().my);
    const auto step = std::clamp<std::size_t>(1000000 / cells, 1, 256);
    for (std::size_t first = 0; first < forces.size(); first += step) {
      InterruptGuard::throw_if_interrupted();
      const auto count = std::min(step, forces.size() - first);
      solver.solve(std::span(rows.contacts).subspan(first, count), std::span(forces).subspan(first, count));
      show_progress(chunk.text.size() * count / forces.size());
    }
    contacts_ += forces.size();
    contacts_unsolved_ += static_cast<std::size_t>(
        std::count_if(forces.begin(), forces.end(), [](const auto& result) { return result.status != Status::ok; }));
    return result_rows(rows, forces);
  }

  void show_progress(std::size_t bytes) {
    bytes_done_ += bytes;
    if (omp_get_thread_num() == 0 && size_ > 0) bar_.update(static_cast<double>(bytes_done_) / size_);
  }

  std::vector<RowSolver> solvers_; ///< one for each thread
  std::ifstream input_;
  ContactTableReader reader_;
  OutputFile output_;
  double size_;
  ProgressBar bar_;
  std::vector<TextChunk> chunks_;
  std::vector<std::string> results_;
  std::vector<std::exception_ptr> errors_;
  std::atomic<std::size_t> bytes_done_ = 0, contacts_ = 0, contacts_unsolved_ = 0;
};

int batch(const BatchArguments& arguments) {
  require_count("--threads", arguments.threads, 1, 1024);
  const InterruptGuard guard;
  Batch work(arguments);
  if (work.run()) return 0;
  fmt::print(stderr, "microslip: warning: {}: {} of {} contacts have numbers too large or too small to compute with\n",
             arguments.output.string(), work.contacts_unsolved(), work.contacts());
  return 1;
}

} // namespace

void add_batch_command(CLI::App& program, int& exit_code) {
  auto* command = program.add_subcommand("batch", "Forces of many contacts, from CSV to CSV");
  const auto arguments = std::make_shared<BatchArguments>();
  const auto option = [&](const char* name, auto& value, const char* what) {
    return command->add_option(name, value, what)->capture_default_str();
  };
  command->add_option("IN.csv", arguments->input, "table of contacts")->required();
  command->add_option("-o,--output", arguments->output, "table of results")->required();
  option("--theory", arguments->theory, "fastsim, fastsim_half_step or fastsim2");
  option("--grid", arguments->grid, "cells along x and y, 1 to 10000 each");
  option("--bound", arguments->bound, "traction bound: parabolic or elliptic");
  option("--flexibility", arguments->flexibility, "flexibilities: three, one or blended");
  option("--threads", arguments->threads, "results do not depend on it; default: all processors");
  command->footer(
      "IN.csv names its columns in the first line, in any order: a [m], b [m], shear_modulus [Pa], poisson_ratio [-],\n"
      "friction [-], normal_force [N], creep_x [-], creep_y [-], spin [1/m]. OUT.csv repeats them and adds fx [N],\n"
      "fy [N], mz [N m], adhesion_area [m^2], slip_area [m^2], status. Forces act on body 1. A bad row is named by\n"
      "line and column, and OUT.csv appears only when it is complete.\n\n"
      "Example:\n  microslip batch contacts.csv -o forces.csv --theory fastsim2 --grid 10x10");
  command->callback([arguments, &exit_code] { exit_code = batch(*arguments); });
}

} // namespace microslip
