// The tangential contact law as a unit.

#include "fmi/model.hpp"
#include "fmi/tangential_law.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace microslip::fmi {
namespace {

/// The variables by their value references.
enum Reference : std::size_t {
  creepage_longitudinal,
  creepage_lateral,
  spin,
  normal_force,
  friction,
  fx,
  fy,
  mz,
  adhesion_area,
  slip_area,
  semi_axis_x,
  semi_axis_y,
  reference_force,
  shear_modulus,
  poisson_ratio,
  mx,
  my,
  status,
  theory,
  table
};

/// The table in a file.
CreepTableNodes read_table(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const auto bytes =
      std::make_shared<std::string>(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  if (!file || bytes->empty()) throw Error("table = " + path.string() + ": cannot be read");
  try {
    return decode(std::as_bytes(std::span(*bytes)), bytes);
  } catch (const Error& error) {
    throw Error("table = " + path.string() + ": " + error.what());
  }
}

/// A file as it is now: what replaces it has another size or another time.
struct FileVersion {
  std::filesystem::path path;
  std::uintmax_t size = 0;
  std::filesystem::file_time_type written;

  explicit FileVersion(std::filesystem::path of) : path(std::move(of)) {
    std::error_code none; // what cannot be read is said when it is
    size = std::filesystem::file_size(path, none);
    written = std::filesystem::last_write_time(path, none);
  }
  bool operator==(const FileVersion&) const = default;
};

/// Source of a unit's tables. Units that name one file, the one that comes with them, share what they make of
/// it: that of the first is kept.
CreepTableSource table_source(const std::filesystem::path& path) {
  struct Kept {
    FileVersion file;
    CreepTableSource source;
    explicit Kept(const std::filesystem::path& from) : file(from), source(read_table(from)) {}
  };
  static const Kept kept(path);
  return kept.file == FileVersion(path) ? kept.source : read_table(path);
}

class TangentialModel final : public Model {
public:
  explicit TangentialModel(std::filesystem::path resources) : resources_(std::move(resources)) {}

  std::vector<std::string> set_parameters(const Values& v) override {
    law_.reset();
    law_.emplace(LawParameters{.semi_axis_x = v.real[semi_axis_x],
                               .semi_axis_y = v.real[semi_axis_y],
                               .reference_force = v.real[reference_force],
                               .shear_modulus = v.real[shear_modulus],
                               .poisson_ratio = v.real[poisson_ratio],
                               .mx = v.integer[mx],
                               .my = v.integer[my],
                               .table = table_of(v)});
    if (law_->in_range()) return {};
    return {"the ellipse or Poisson's ratio is beyond the creep-force table's range: forces are those of limits"};
  }

  void evaluate(Values& v) override {
    const ContactForces forces = law_->evaluate(input(v));
    v.real[fx] = forces.fx, v.real[fy] = forces.fy, v.real[mz] = forces.mz;
    v.real[adhesion_area] = forces.adhesion_area, v.real[slip_area] = forces.slip_area;
    v.integer[status] = static_cast<int>(forces.status);
  }

  std::span<const double> differentiate(const Values& v) override {
    derivatives_ = law_->differentiate(input(v));
    return {derivatives_.front().data(), derivatives_.size() * derivatives_.front().size()};
  }

private:
  static LawInput input(const Values& v) {
    return {.creepage = {v.real[creepage_longitudinal], v.real[creepage_lateral], v.real[spin]},
            .normal_force = v.real[normal_force],
            .friction = v.real[friction]};
  }

  /// Read once unless the file or Poisson's ratio changes.
  std::optional<CreepForceTable> table_of(const Values& v) {
    const std::string& word = v.text[theory];
    if (word == "fastsim2") return std::nullopt;
    if (word != "table") throw Error("theory = \"" + word + "\": must be fastsim2 or table");
    const auto from = std::pair(v.text[table], v.real[poisson_ratio]);
    if (!table_ || read_from_ != from) {
      table_.reset();
      table_.emplace(table_source(resources_ / from.first), from.second);
      read_from_ = from;
    }
    return table_;
  }

  std::filesystem::path resources_;
  std::optional<CreepForceTable> table_;
  std::pair<std::string, double> read_from_;
  std::optional<TangentialLaw> law_;
  std::array<std::array<double, 5>, 3> derivatives_{};
};

/// A variable that cases of two bodies have, by its unit, range and text there.
Variable of_input(const char* section, const char* key, const char* name, Causality causality, double start) {
  const description::Input& input = *description::rolling_inputs().find(section, key);
  return {.name = name,
          .description = std::string(input.text),
          .causality = causality,
          .unit = std::string(input.unit),
          .start = start,
          .min = input.bounds.least(),
          .max = input.bounds.largest()};
}

Variable of_result(const char* name, Causality causality) {
  const Quantity& q = quantity(name);
  return {.name = name, .description = std::string(q.description), .causality = causality, .unit = std::string(q.unit)};
}

} // namespace

ModelInfo model_info() {
  using enum Causality;
  const LawInput usual;
  const LawParameters p;
  const auto real = [](const char* name, Causality causality, const char* unit, double start, const char* text) {
    return Variable{.name = name, .description = text, .causality = causality, .unit = unit, .start = start};
  };
  const auto cells = [](const char* name, int start, const char* text) {
    return Variable{.name = name,
                    .description = text,
                    .kind = Kind::integer,
                    .causality = parameter,
                    .start = static_cast<double>(start),
                    .min = 1,
                    .max = most_cells};
  };
  const auto text = [](const char* name, const char* start, const char* what) {
    return Variable{.name = name, .description = what, .kind = Kind::text, .causality = parameter, .start_text = start};
  };
  return {.name = "microslip tangential contact law",
          .identifier = "microslip_tangential",
          .description = "Creep forces of a wheel on a rail by FASTSIM2 or a creep-force table: forces on the wheel, x "
                         "along the rolling direction, "
                         "y to the left, z up",
          .variables = {
              of_input("motion", "creepage_longitudinal", "creepage_longitudinal", input, 0),
              of_input("motion", "creepage_lateral", "creepage_lateral", input, 0),
              of_input("motion", "spin", "spin", input, 0),
              real("normal_force", input, "N", usual.normal_force, "Fn; no contact at 0 and below"),
              of_input("friction", "coefficient", "friction", input, usual.friction),
              of_result("fx", output),
              of_result("fy", output),
              of_result("mz", output),
              of_result("adhesion_area", local),
              of_result("slip_area", local),
              real("semi_axis_x", parameter, "m", p.semi_axis_x,
                   "Semi-axis of the contact ellipse along x under the reference force; grows as Fn^(1/3)"),
              real("semi_axis_y", parameter, "m", p.semi_axis_y, "The same along y"),
              real("reference_force", parameter, "N", p.reference_force, "Normal force that the semi-axes belong to"),
              real("shear_modulus", parameter, "Pa", p.shear_modulus, "Combined modulus of rigidity of wheel and rail"),
              of_input("body1", "poisson_ratio", "poisson_ratio", parameter, p.poisson_ratio),
              cells("mx", p.mx, "Cells along each row of the contact"),
              cells("my", p.my, "Rows of cells"),
              {.name = "status",
               .description = "0: contact, 3: no contact, 5: contact beyond the range of the creep-force table",
               .kind = Kind::integer,
               .causality = output},
              text("theory", "fastsim2", "fastsim2 or table"),
              text("table", "hertz.creep",
                   "Creep-force table of theory table: a path, from the unit's resources on if it is relative")}};
}

std::unique_ptr<Model> make_model(const std::filesystem::path& resources) {
  return std::make_unique<TangentialModel>(resources);
}

} // namespace microslip::fmi
