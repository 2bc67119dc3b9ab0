#include "campaign/sweep.hpp"

#include "cases/contact_damage.hpp"
#include "cases/rolling_contact_result.hpp"
#include "cases/wheel_rail_result.hpp"
#include "io/nearest_word.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"
#include "microslip/rolling/solver.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>

namespace microslip::campaign {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A column with how its number is taken from what a kind of cases finds.
template <class Solved> struct Column {
  SweepColumn of_file;
  std::function<double(const Solved&)> value;
};
template <class Solved> using Columns = std::vector<Column<Solved>>;

double code_of(Status status) {
  return static_cast<double>(status);
}

/// The second column of each kind.
template <class Solved, class Value> Column<Solved> warning_column(const std::string& group, const Value& value) {
  return {{group + std::string(warning_name), "-", warning_codes},
          [value](const Solved& s) { return static_cast<double>(value(s).code); }};
}

// A kind of cases: what it finds, its columns, which keys need a new solver, and how it is read and solved. `root` is
// the case's file; `tables` are those of all cases and workers; `is_new` says that one of those keys has changed since
// the last call.

/// Two bodies that touch in an ellipse.
class RollingKind {
public:
  struct Solved {
    HertzContact hertz;
    ContactSolution contact;
    Warnings warnings;
    std::optional<Nip> nip = {};                  ///< of bodies with layers
    std::optional<cases::CaseDamage> damage = {}; ///< of a surface whose strength the case has
  };

  static Columns<Solved> columns(const SweepSpec& spec) {
    const bool is_shift =
        spec.base().at_path("motion.kind").value_or(std::string_view()) == io::to_word(ContactMotion::shift);
    Columns<Solved> all = {
        {{"contact/status", "-", status_codes}, [](const Solved& s) { return code_of(s.contact.report.status); }},
        warning_column<Solved>("contact/", [](const Solved& s) { return s.warnings; })};
    const auto hertz = cases::hertz_quantities({});
    for (std::size_t k = 0; k < hertz.size(); ++k)
      if (hertz[k].path.starts_with("hertz/"))
        all.push_back({{hertz[k].path, hertz[k].unit, hertz[k].description},
                       [k](const Solved& s) { return cases::hertz_quantities(s.hertz)[k].value; }});
    for (const Quantity& q : quantities())
      all.push_back({{"contact/" + std::string(q.name), std::string(is_shift ? q.shift_unit : q.unit),
                      std::string(q.description)},
                     [&q](const Solved& s) { return q.applies(s.contact) ? q.value(s.contact) : nan; }});
    if (spec.base().at_path("material").is_table())
      for (const DamageQuantity& q : damage_quantities())
        all.push_back({{"contact/" + std::string(q.name), std::string(q.unit), std::string(q.description)},
                       [&q](const Solved& s) { return s.damage ? (*s.damage)(q) : nan; }});
    if (spec.base().at_path("body1.layers").is_array() || spec.base().at_path("body2.layers").is_array()) add_nip(all);
    return all;
  }
  static bool needs_new_solver(std::string_view key) { return key.starts_with("solution."); }
  static void check(const io::TomlSection& root, const io::CreepTables& tables) { io::read_case(root, tables); }

  /// The solver is new each time: with influence coefficients that it keeps for the next contact the last bits are
  /// others. What it keeps of layers changes nothing, and costs more than a solution.
  Solved solve(const io::TomlSection& root, const io::CreepTables& tables, bool is_new, const Progress& progress) {
    const io::RollingCase input = io::read_case(root, tables);
    if (is_new || !solver_ || !input.problem.layered) solver_.emplace(input.method);
    const HertzContact hertz = hertz_contact(input.problem);
    Solved solved{hertz, solver_->solve(input.problem, progress), cases::case_warnings(input, hertz).all};
    if (input.strength) solved.damage.emplace(input, hertz, solved.contact);
    if (!cases::has_nip(input, solved.contact)) return solved;
    solved.nip = nips_.find(input.problem, solved.contact, cases::roller_radii(input), progress);
    solved.warnings = solved.nip->warnings.all;
    return solved;
  }
  static std::string reason(const Solved& solved) { return solved.contact.report.reason; }

private:
  static void add_nip(Columns<Solved>& all) {
    for (const cases::NipQuantity& q : cases::nip_quantities())
      all.push_back({{std::string(q.path), std::string(q.unit), std::string(q.description)},
                     [&q](const Solved& s) { return s.nip && q.applies(*s.nip) ? q.value(*s.nip) : nan; }});
  }

  std::optional<Solver> solver_;
  NipAnalysis nips_;
};

/// Columns of a wheel and its patches; `group` is what stands before wheel/ and patches/.
template <class Solved, class Wheel>
void add_wheel(Columns<Solved>& all, const std::string& group, int patches, const Wheel& wheel) {
  all.push_back(
      {{group + "wheel/status", "-", status_codes}, [=](const Solved& s) { return code_of(wheel(s).status); }});
  all.push_back(warning_column<Solved>(group + "wheel/", [=](const Solved& s) { return wheel(s).warnings; }));
  for (const WheelQuantity& q : wheel_quantities())
    all.push_back({{group + "wheel/" + std::string(q.name), std::string(q.unit), std::string(q.description)},
                   [=, &q](const Solved& s) { return q.value(wheel(s)); }});
  for (int k = 0; k < patches; ++k) {
    const std::string of_patch = group + "patches/" + std::to_string(k) + "/";
    const auto has = [=](const Solved& s) { return static_cast<std::size_t>(k) < wheel(s).patches.size(); };
    // A patch that is not there is no invalid input, which a status of NaN would become in the file.
    all.push_back({{of_patch + "status", "-", status_codes},
                   [=](const Solved& s) { return code_of(has(s) ? wheel(s).patches[k].status : Status::no_contact); }});
    for (const PatchQuantity& q : patch_quantities())
      all.push_back({{of_patch + std::string(q.name), std::string(q.unit), std::string(q.description)},
                     [=, &q](const Solved& s) { return has(s) ? q.value(wheel(s).patches[k]) : nan; }});
  }
}

const std::optional<double>& load_of(const io::LoadedWheelState& loaded) {
  return loaded.vertical_force;
}
const WheelsetLoad& load_of(const io::LoadedWheelsetState& loaded) {
  return loaded.load;
}

/// Kind shared by wheels and wheelsets. `Input` is a WheelRailCase or a WheelsetCase, which `read` reads, of the keys
/// of `inputs`.
template <class Input, class Solver, class Solution, auto read, auto inputs> class RailwayKind {
public:
  using Solved = Solution;

  static bool needs_new_solver(std::string_view key) {
    const auto dot = key.rfind('.');
    const description::Input* const input =
        dot == std::string_view::npos ? nullptr : inputs().find(key.substr(0, dot), key.substr(dot + 1));
    return input == nullptr || !input->is_state;
  }
  static void check(const io::TomlSection& root, const io::CreepTables& tables) { read(root, tables, nullptr); }
  static std::string reason(const Solved& solved) { return std::string(to_string(solved.reason)); }

  /// The state alone is read from case to case, unless something else has changed. The exact theory's solver is new
  /// each time: with what it keeps for the next state the last bits are others.
  Solved solve(const io::TomlSection& root, const io::CreepTables& tables, bool is_new, const Progress& progress) {
    is_new = is_new || !solver_;
    if (is_new)
      input_ = read(root, tables, nullptr);
    else
      input_->states = io::read_states(root, *input_);
    if (is_new || input_->method.theory == Theory::exact) solver_.emplace(io::solver_of(*input_, input_->method));
    solver_->reset(); // cases do not depend on each other
    const auto& loaded = input_->states.front();
    return solver_->solve(loaded.state, load_of(loaded), progress);
  }

private:
  std::optional<Input> input_;
  std::optional<Solver> solver_;
};

/// A wheel on a rail.
class WheelKind : public RailwayKind<io::WheelRailCase, WheelRail, WheelRailSolution, io::read_wheel_rail_case,
                                     description::wheel_inputs> {
public:
  static Columns<Solved> columns(const SweepSpec& spec) {
    Columns<Solved> all;
    add_wheel(all, "", spec.patches(), [](const Solved& s) -> const WheelRailSolution& { return s; });
    return all;
  }
};

/// Both wheels of a wheelset.
class WheelsetKind : public RailwayKind<io::WheelsetCase, WheelsetOnTrack, WheelsetSolution, io::read_wheelset_case,
                                        description::wheelset_inputs> {
public:
  static Columns<Solved> columns(const SweepSpec& spec) {
    Columns<Solved> all = {{{"wheelset/status", "-", status_codes}, [](const Solved& s) { return code_of(s.status); }},
                           warning_column<Solved>("wheelset/", [](const Solved& s) { return s.warnings; })};
    for (const WheelsetQuantity& q : wheelset_quantities())
      all.push_back({{"wheelset/" + std::string(q.name), std::string(q.unit), std::string(q.description)},
                     [&q](const Solved& s) { return q.value(s); }});
    add_wheel(all, "left/", spec.patches(), [](const Solved& s) -> const WheelRailSolution& { return s.left; });
    add_wheel(all, "right/", spec.patches(), [](const Solved& s) -> const WheelRailSolution& { return s.right; });
    return all;
  }
};

/// The case file's table, with the parameters of one case after the other.
template <class Kind> class CaseTable {
public:
  explicit CaseTable(std::shared_ptr<const SweepSpec> spec) : spec_(std::move(spec)), table_(spec_->base()) {
    for (const SweepParameter& parameter : spec_->parameters())
      rebuilds_.push_back(std::any_of(parameter.keys.begin(), parameter.keys.end(), Kind::needs_new_solver));
    last_.resize(rebuilds_.size());
  }

  /// Returns whether a key has changed that needs a new solver.
  bool set(std::size_t index) {
    bool is_new = std::exchange(is_first_, false);
    for (std::size_t k = 0; k < rebuilds_.size(); ++k) {
      spec_->set(index, k, table_);
      if (!rebuilds_[k]) continue;
      const CaseValue value = spec_->value(index, k);
      const bool is_another = std::exchange(last_[k], value) != value;
      is_new = is_new || is_another;
    }
    return is_new;
  }
  io::TomlSection root() const { return {table_, spec_->base_name()}; }

private:
  std::shared_ptr<const SweepSpec> spec_;
  toml::table table_;
  std::vector<bool> rebuilds_;
  std::vector<CaseValue> last_;
  bool is_first_ = true;
};

std::string_view last_name(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

/// Columns that the file asks for; status and warnings are always kept.
template <class Solved> Columns<Solved> chosen(Columns<Solved> all, const SweepSpec& spec) {
  const auto& wanted = spec.quantities();
  if (wanted.empty()) return all;
  const auto is_named = [](const auto& column, const std::string& name) {
    return column.of_file.path == name || last_name(column.of_file.path) == name;
  };
  for (const std::string& name : wanted) {
    if (std::any_of(all.begin(), all.end(), [&](const auto& column) { return is_named(column, name); })) continue;
    std::vector<std::string_view> names;
    for (const auto& column : all) names.push_back(last_name(column.of_file.path));
    throw Error(spec.name() + ": output.quantities: " + io::printable(name) + " is no quantity" +
                io::suggestion(name, names));
  }
  Columns<Solved> some = {all[0], all[1]};
  for (std::size_t k = some.size(); k < all.size(); ++k)
    if (std::any_of(wanted.begin(), wanted.end(), [&](const auto& name) { return is_named(all[k], name); }))
      some.push_back(all[k]);
  return some;
}

/// Reads one case of some that are tried: a misspelt key is wrong in all, a value out of range may be so in
/// one. Else the first one's Error.
void read_some_case(const SweepSpec& spec, const std::function<void(std::size_t index)>& read) {
  constexpr std::size_t some = 5;
  std::string first_error;
  for (std::size_t k = 0; k < some; ++k) {
    try {
      return read(k * (spec.count() - 1) / (some - 1));
    } catch (const Error& error) {
      if (k == 0) first_error = spec.location(0) + error.what();
    }
  }
  throw Error(first_error);
}

} // namespace

template <class Kind> void Sweep::set_up(SweepSpec spec) {
  const auto tables = std::make_shared<const io::CreepTables>();
  io::TomlSection::ReadKeys keys;
  try {
    read_some_case(spec, [&](std::size_t index) {
      const toml::table written = spec.case_as_written(index);
      Kind::check(io::TomlSection(written, spec.base_name(), {}, &keys), *tables);
    });
  } catch (const Error&) {
    if (spec.has_units()) throw; // else the cases fail one by one
  }
  spec.convert_units(io::TomlSection::units_of(keys));
  spec_ = std::make_shared<const SweepSpec>(std::move(spec));
  const auto columns = std::make_shared<const Columns<typename Kind::Solved>>(chosen(Kind::columns(*spec_), *spec_));
  for (const auto& column : *columns) columns_.push_back(column.of_file);
  struct Worker {
    CaseTable<Kind> table;
    Kind kind;
    std::shared_ptr<const Columns<typename Kind::Solved>> columns;
    bool has_failed = false; ///< the last case: its solver may not be as its keys say
  };
  make_worker_ = [spec = spec_, columns, tables]() -> RowWorker {
    const auto worker = std::make_shared<Worker>(Worker{CaseTable<Kind>(spec), {}, columns});
    return [worker, tables](std::size_t index, std::span<double> row, const Progress& progress) {
      const bool is_new = worker->table.set(index) || worker->has_failed;
      worker->has_failed = true;
      const auto solved = worker->kind.solve(worker->table.root(), *tables, is_new, progress);
      worker->has_failed = false;
      std::transform(worker->columns->begin(), worker->columns->end(), row.begin(),
                     [&](const auto& column) { return column.value(solved); });
      return row.front() == code_of(Status::ok) ? "" : Kind::reason(solved);
    };
  };
  read_some_case(*spec_, [&](std::size_t index) {
    CaseTable<Kind> table(spec_);
    table.set(index);
    Kind::check(table.root(), *tables);
  });
}

Sweep::Sweep(const std::string& text, const std::string& name) {
  SweepSpec spec(text, name);
  const io::TomlSection base(spec.base(), spec.base_name());
  if (io::is_wheelset_case(base))
    set_up<WheelsetKind>(std::move(spec));
  else if (io::is_wheel_rail_case(base))
    set_up<WheelKind>(std::move(spec));
  else
    set_up<RollingKind>(std::move(spec));
}

CampaignPlan Sweep::plan() const {
  return {.identity = spec_->identity(), .count = spec_->count(), .width = columns_.size(), .chunk = spec_->chunk()};
}

} // namespace microslip::campaign
