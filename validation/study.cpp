#include "validation/study.hpp"

#include "validation/studies.hpp"
#include "validation/study_texts.hpp"

#include <algorithm>
#include <array>

namespace microslip::validation {
namespace {

/// Refuses to compile a name that is not in the table of texts.
consteval Study study(std::string_view name, bool (*run)(const StudyOptions& options, std::ostream& out)) {
  const auto* text = std::ranges::find(study_texts, name, &StudyText::name);
  return {text->name, text->summary, run};
}

constexpr std::array all_studies = {
    study("bentall-johnson", run_bentall_johnson),
    study("carter", run_carter),
    study("cattaneo", run_cattaneo),
    study("cattaneo-to-carter", run_cattaneo_to_carter),
    study("conicity", run_conicity),
    study("contact", run_contact_folder),
    study("contact-cases", run_contact_cases),
    study("creep-curve", run_creep_curve),
    study("creep-table", run_creep_table),
    study("creep-table-patches", run_creep_table_patches),
    study("edge-constants", run_edge_constants),
    study("exact-112", run_exact_112),
    study("exact-test-set", run_exact_test_set),
    study("falling-friction", run_falling_friction),
    study("fastsim2-table1", run_fastsim2_table1),
    study("fastsim2-table2", run_fastsim2_table2),
    study("frictional-power", run_frictional_power),
    study("hertz", run_hertz),
    study("kalker-coefficients", run_kalker_coefficients),
    study("layers", run_layers),
    study("manchester", run_manchester),
    study("measurements", run_measurements),
    study("model-problem", run_model_problem),
    study("models", run_models),
    study("normal-models", run_normal_models),
    study("random-problems", run_random_problems),
    study("random-wheels", run_random_wheels),
    study("refinement", run_refinement),
    study("response", run_response),
    study("second-order", run_second_order),
    study("solver-growth", run_solver_growth),
    study("spence", run_spence),
    study("subsurface", run_subsurface),
    study("temperature", run_temperature),
    study("vehicle", run_vehicle),
    study("viscoelastic-cylinders", run_viscoelastic_cylinders),
    study("wheel-rail", run_wheel_rail),
    study("wheel-surfaces", run_wheel_surfaces),
    study("wheel-theories", run_wheel_theories),
};
static_assert(std::ranges::equal(all_studies, study_texts, {}, &Study::name, &StudyText::name));

} // namespace

Progress part_of(const Progress& whole, double begin, double end) {
  if (!whole) return {};
  return [whole, begin, end](double fraction) { return whole(begin + fraction * (end - begin)); };
}

std::span<const Study> studies() {
  return all_studies;
}

const Study* find_study(std::string_view name) {
  const auto found =
      std::find_if(all_studies.begin(), all_studies.end(), [name](const Study& s) { return s.name == name; });
  return found == all_studies.end() ? nullptr : &*found;
}

} // namespace microslip::validation
