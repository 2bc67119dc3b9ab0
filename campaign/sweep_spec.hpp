#pragma once

#include "campaign/sample.hpp"
#include "campaign/sweep_axis.hpp"
#include "io/toml_section.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::campaign {

/// Parameters that vary from case to case.
struct SweepParameter {
  std::string name;              ///< as the file has it: "motion.spin", or keys that take the same value: "a.x, b.x"
  std::vector<std::string> keys; ///< of the case file
  bool is_number = true;         ///< in all cases; texts with units are after convert_units
  std::string unit = "SI";       ///< of its numbers, known after convert_units
};

/// Contents of the file of a sweep: a case, and how its keys vary: on a grid, by a list or in a random sample.
/// docs/campaigns.md has the format.
class SweepSpec {
public:
  /// Reads TOML; `name` is the file's name for messages, and where paths start. Throws Error as parse_case.
  SweepSpec(const std::string& text, const std::string& name);

  const std::string& title() const { return title_; }
  const std::string& text() const { return text_; }
  const std::string& name() const { return name_; }
  /// Returns whether numbers vary that are given as texts with units, such as "80 kN".
  bool has_units() const;
  /// A case with its values as they are written, texts with units among them; of a range that has such ends the first.
  toml::table case_as_written(std::size_t index) const;
  /// Makes them numbers in the units that their keys have, also those of the case before anything varies. Error for
  /// another kind of unit.
  void convert_units(const io::TomlSection::KeyUnits& units);

  /// The case before anything varies, and its file's name for messages.
  const toml::table& base() const { return base_; }
  const std::string& base_name() const { return base_name_; }
  const std::string& base_text() const { return base_text_; }

  std::size_t count() const { return count_; }
  /// Cases that are handed out, and kept, at a time: as given, or by their number.
  std::size_t chunk() const { return chunk_; }
  const std::vector<SweepParameter>& parameters() const { return parameters_; }
  /// Shape of a grid: the number of values of each parameter; the last varies fastest. Else empty.
  const std::vector<std::size_t>& shape() const { return shape_; }
  /// How the cases of a random sample are made; none of a grid or a list.
  const std::optional<Sample>& sample() const { return sample_; }
  /// Names of the quantities to keep; empty: all.
  const std::vector<std::string>& quantities() const { return quantities_; }
  /// Patches of each wheel to keep.
  int patches() const { return patches_; }

  /// Parameter `k` in a case: depends on the case's number alone. Cost O(parameters).
  CaseValue value(std::size_t index, std::size_t k) const;
  /// Value as text, for a parameter that is no number.
  std::string text_of(std::size_t index, std::size_t k) const;
  /// Location of a case of a list, "cases.csv:2: ", for messages; else empty. Reads the list anew.
  std::string location(std::size_t index) const;
  /// Puts it into a case.
  void set(std::size_t index, std::size_t k, toml::table& table) const;

  /// A hash of all that the cases depend on: this file, the case's, the list's, all files that texts of the case or of
  /// what varies name, with the slices of profiles, and the build. Reads these files anew.
  std::uint64_t identity() const;

private:
  struct Entry;

  void read_base(const io::TomlSection& root);
  void read_grid(const io::TomlSection& root, const toml::table& section);
  void read_sample(const io::TomlSection& root, const toml::table& section);
  std::vector<Correlation> read_correlations(const io::TomlSection& correlations, const toml::table& section) const;
  std::size_t correlated(const std::string& name) const;
  void read_list(const io::TomlSection& list);
  void parse_rows(std::string_view text, const std::string& file);
  void read_headings(const std::vector<std::string_view>& fields, std::vector<std::string>& units);
  void require_distinct_keys() const;
  void read_chunk(const io::TomlSection& root);
  std::vector<Entry> entries_of(const toml::table& section) const;
  /// `read` takes what a table below the key has, described by the keys of `section` in the table of inputs.
  void add(const Entry& entry, const io::TomlSection& root, std::string_view section,
           SweepAxis (*read)(const io::TomlSection&));
  void put(std::size_t k, const CaseValue& value, toml::table& table) const;
  void put(const std::string& path, const CaseValue& value, toml::table& table) const;
  void convert(SweepAxis& axis, std::size_t k, const io::TomlSection::KeyUnits& units) const;
  [[noreturn]] void fail(const toml::source_region& location, const std::string& what) const;

  std::string title_, text_, name_, base_name_, base_text_;
  std::string list_name_, list_text_; ///< of the table of cases, if there is one
  toml::table base_;
  std::size_t count_ = 0, chunk_ = 1;
  std::vector<SweepParameter> parameters_;
  std::vector<SweepAxis> axes_; ///< of a grid or a sample, or columns of a list
  std::vector<std::size_t> shape_;
  std::optional<Sample> sample_;
  std::vector<std::string> quantities_;
  int patches_ = 0;
};

} // namespace microslip::campaign
