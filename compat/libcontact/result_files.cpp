#include "compat/libcontact/result_files.hpp"

#include "compat/contact/input_text.hpp"
#include "compat/contact/mat.hpp"
#include "compat/contact/out.hpp"
#include "compat/contact/out_sections.hpp"
#include "compat/libcontact/refusal.hpp"
#include "compat/libcontact/registry.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

namespace microslip::libcontact {
namespace {

using namespace contact_program;
namespace fs = std::filesystem;

/// As CONTACT's library names the files of an element or a contact problem.
std::string stem_of(const Case& c) {
  const auto& [element, problem] = c.sequence;
  return fmt::format("caddon_re{:03}", element) + (c.wheel_rail ? "" : fmt::format("_cp{}", problem));
}

void write_file(const std::string& name, const std::string& text) {
  io::OutputFile file(Registry::instance().output_folder() / name);
  file.write(text);
  file.commit();
}

void write_case_file(const Case& c, const std::string& ending, const std::string& text) {
  write_file(fmt::format("{}.{:04}{}", stem_of(c), c.number, ending), text);
}

void write_log(const std::string& results) {
  if (!Registry::instance().log().write(results))
    throw Refusal(CNTC_err_other, "the file of results cannot be written");
}

std::string heading(const Case& c) {
  const auto& [element, problem] = c.sequence;
  return c.wheel_rail
             ? fmt::format("\n Case {} for w/r contact on result element {}\n", c.number, element)
             : fmt::format("\n Case{:6} for contact problem{:3} on result element{:3}\n", c.number, problem, element);
}

void write_elements(const Case& c, const Outcome& o) {
  if (!o.wheel) return write_case_file(c, ".mat", mat_text(c, o));
  for (std::size_t k = 0; k < o.wheel->patches.size(); ++k)
    write_case_file(c, patch_letter(k) + ".mat", mat_text(c, *o.wheel, k));
}

/// The points that a profile was given by, as a file that is read as they are: columns, whose zig-zags stay.
void name_points(ProfileRecord& record, GivenProfile& given, const std::string& name) {
  if (given.points.empty()) return;
  if (given.file.empty()) {
    std::string text;
    for (const ProfilePoint& point : given.points) text += fmt::format("{} {}\n", point.y, point.z);
    write_file(name, text);
    given.file = fs::absolute(Registry::instance().output_folder() / name);
  }
  constexpr double no_zigzag = 7; // rad, above a full turn
  record.file = given.file.string();
  record.zigzag = no_zigzag;
}

} // namespace

void write_input(ContactProblem& p, const Case& c) {
  if (!p.writes_input()) return;
  Case written = c;
  if (auto& wheel = written.wheel_rail) {
    const auto name = [&](const char* role) { return fmt::format("{}_{}.{:04}.txt", stem_of(c), role, c.number); };
    name_points(wheel->rail, p.given_rail, name("rail"));
    name_points(wheel->wheel, p.given_wheel, name("wheel"));
  }
  Registry::instance().cases().add(input_text(written));
}

void write_results(const ContactProblem& p) {
  const Case& c = p.solved();
  const Outcome* o = p.outcome();
  if (!o) return;
  if (prints(c, 1)) write_log(heading(c) + out_results(c, *o));
  if (c.digits.matfil != Stored::none && o->kind == Outcome::Kind::solved) write_elements(c, *o);
}

void write_interior(const ContactProblem& p, int patch) {
  Case c = p.solved();
  c.subs_file = p.data.subs_file;
  c.interior_level = p.data.interior_level;
  Outcome o;
  o.interior = p.interior(patch);
  if (c.interior_level > 0) write_log(out_interior(c, o));
  const std::string letter = p.is_wheel() ? patch_letter(static_cast<std::size_t>(patch) - 1) : "";
  if (c.subs_file != SubsFile::none) write_case_file(c, letter + ".subs", subs_text(c, o.interior));
}

} // namespace microslip::libcontact
