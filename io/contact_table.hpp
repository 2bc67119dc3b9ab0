#pragma once

#include "io/units.hpp"
#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/contact/warnings.hpp"

#include <cstddef>
#include <istream>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip::io {

/// Whole lines of a file.
struct TextChunk {
  std::string text = {};
  std::size_t first_line = 1; ///< number of the first line in the file, from 1
};

/// A row that holds no contact.
struct BadRow {
  std::size_t line = 0;
  std::string reason; ///< `column friction: "abc" is not a number`
};

/// Rows whose contacts are valid and yet hardly what is meant, all for the same reason.
struct ImplausibleRows {
  std::size_t count = 0;
  BadRow first;
};

/// Contacts of a table, with the text of their rows.
struct TableRows {
  std::vector<EllipticContact> contacts = {};
  std::string text = {};              ///< the rows' fields as they were, joined by commas, rows without separator
  std::vector<std::size_t> ends = {}; ///< where in `text` each row ends
  std::vector<BadRow> bad = {};
  std::map<Warning, ImplausibleRows> implausible = {};
};

/// Reads a table of contacts from CSV, a chunk at a time, in constant memory. The first line names the columns, in any
/// order: a [m], b [m], shear_modulus [Pa], poisson_ratio [-], friction [-], normal_force [N], creepage_longitudinal
/// [-], creepage_lateral [-], spin [1/m], each of them once; there may be dissimilarity [-], K with
/// |K| <= 1/2 - poisson_ratio, and rolling_speed [m/s]. Behind a name there may be another unit: `normal_force [kN]`.
/// Columns of results are those of an earlier run and left out; all others are kept as they are. Commas, semicolons or
/// tabs separate fields, decimal commas are understood where commas do not, and blanks around fields, quotes, CRLF, a
/// byte-order mark, blank lines and a last line without its end are fine. Everything else is an Error with file, line
/// and column: `in.csv:17: column friction: "abc" is not a number`, `in.csv:18: column poisson_ratio = 0.7 [-]: must be
/// in [0, 0.5]`.
class ContactTableReader {
public:
  /// Reads the header. `stream` must outlive the reader; `name` is the file's name for messages.
  ContactTableReader(std::istream& stream, std::string name);

  /// Makes rows with a dissimilarity other than 0 bad ones: `reason` ends "must be 0 ...".
  void refuse_dissimilar_bodies(std::string reason) { similar_only_ = std::move(reason); }

  /// Names of the columns that are kept, in the order of the file, as CSV.
  const std::vector<std::string>& columns() const { return columns_; }
  /// The next rows, about 32 KiB of them; false at the end. Chunks do not depend on how they are used.
  bool read(TextChunk& chunk);
  std::size_t bytes_read() const { return bytes_read_; }
  /// Rows in a chunk, bad ones by themselves. May be called from several threads at a time.
  TableRows parse(const TextChunk& chunk) const;
  /// The message for a bad row, with file and line.
  std::string message(const BadRow& row) const { return name_ + ":" + std::to_string(row.line) + ": " + row.reason; }

private:
  /// Use of a column.
  struct Use {
    std::size_t known = 0; ///< which of the known ones it is; else one behind the last
    bool is_kept = true;
    UnitScale to_si = {};
  };

  void fill(std::string& text);
  void parse_header(std::string_view line);
  Use use_of(std::string_view field, std::vector<std::string_view>& strangers) const;
  void require_columns(std::span<const std::string_view> strangers) const;
  void parse_row(const std::vector<std::string_view>& fields, TableRows& rows) const;

  std::istream& stream_;
  std::string name_, similar_only_;
  char separator_ = ',';
  std::vector<std::string> columns_;
  std::vector<Use> uses_; ///< of each column of the file
  std::string rest_;      ///< bytes that are read and not handed out: the beginning of a line
  std::size_t next_line_ = 1;
  std::size_t bytes_read_ = 0;
};

/// Outcome of the exact theory's iteration for a contact.
struct Iteration {
  double residual = 0; ///< relative
  int steps = 0;       ///< of Newton's method
};

/// The header of a table of results: the given columns and fx [N], fy [N], mz [N m], adhesion_area [m^2], slip_area
/// [m^2], status; for the exact theory also residual [-], iterations.
std::string result_header(const std::vector<std::string>& columns, bool exact = false);
/// Its rows: the text of `rows` and the results, as the shortest decimal numbers that read back as the same. For the
/// exact theory there is an iteration for each.
std::string result_rows(const TableRows& rows, std::span<const ContactForces> forces,
                        std::span<const Iteration> iterations = {});

} // namespace microslip::io
