#include "compat/contact/input.hpp"
#include "compat/contact/wheel_rail/case_reader.hpp"
#include "compat/contact/wheel_rail/profile_reading.hpp"
#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"

#include <fstream>
#include <thread>

// The beginning and the end of the library, and of result elements.

namespace microslip::libcontact {
namespace {

constexpr int version = 2510; ///< of CONTACT's interface that this one follows: 25.1.0

/// Nothing, or a folder's name; CONTACT's callers give one blank for none.
std::string optional_text(const char* name, const char* letters, const int* length) {
  return letters && length ? text(name, letters, length) : std::string();
}

/// The code goes to an argument as well.
int told(int code, int* ierror) {
  if (ierror) *ierror = code;
  return code;
}

/// Reads a profile that a file has named; others have their curves, or vary.
void read_profile(contact_program::ProfileRecord& record, ProfileRole role) {
  if (!record.curve && !record.file.empty() && !is_variable(record)) record.curve = read_profile_curve(record, role);
}

/// The first case of an input file.
Case first_case(std::istream& stream, const std::string& name) {
  contact_program::InputReader reader(stream, name);
  const Case* c = reader.next();
  if (!c || !c->wheel_rail) throw Refusal(CNTC_err_input, name + ": has no case of module 1");
  return *c;
}

/// Module 1: what a file of one of CNTC_inp_... has. A file that is refused changes nothing.
void read_file(ContactProblem& p, const std::filesystem::path& path, int kind) {
  std::ifstream stream(path);
  if (!stream) throw Refusal(CNTC_err_input, path.string() + ": cannot be read");
  try {
    Case c = kind == CNTC_inp_spck ? contact_program::read_pair(stream, path.string(), p.data)
                                   : first_case(stream, path.string());
    auto& rail = c.wheel_rail->rail;
    auto& wheel = c.wheel_rail->wheel;
    read_profile(rail, ProfileRole::rail);
    read_profile(wheel, ProfileRole::wheel);
    if (rail.file != p.wheel().rail.file) p.given_rail = {};
    if (wheel.file != p.wheel().wheel.file) p.given_wheel = {};
    p.data = std::move(c);
  } catch (const Error& error) {
    throw Refusal(CNTC_err_input, error.what());
  }
}

/// The first case of an input file, with its positions and points.
void read_wheel(ContactProblem& p, const std::filesystem::path& path) {
  read_file(p, path, CNTC_inp_modul1);
  const auto& d = p.wheel();
  if (const auto* force = std::get_if<contact_program::VerticalForce>(&d.position.vertical))
    p.vertical_force = force->fz;
  else
    p.z = std::get<contact_program::VerticalPosition>(d.position.vertical).z;
  if (const auto* force = std::get_if<contact_program::LongitudinalForce>(&d.velocity.pitch))
    p.force_x = force->fx;
  else
    p.vpitch = d.velocity.pitch_rate();
  p.points(-1) = p.data.points;
  p.data.digits.stress = contact_program::InteriorPoints::none;
}

} // namespace

extern "C" {

// NOLINTNEXTLINE(readability-function-size): as CONTACT's callers have it
int cntc_initializefirst(int* ifcver, int* ierror, int*, const char* c_wrkdir, const char* c_outdir,
                         const char* c_expnam, int* len_wrkdir, int* len_outdir, int* len_expnam) {
  const int code = guarded(__func__, [&] {
    if (ifcver) *ifcver = version;
    const bool can_log = Registry::instance().start(optional_text("c_wrkdir", c_wrkdir, len_wrkdir),
                                                    optional_text("c_outdir", c_outdir, len_outdir),
                                                    optional_text("c_expnam", c_expnam, len_expnam));
    return can_log ? 0 : CNTC_err_other;
  });
  return told(code, ierror);
}

// NOLINTNEXTLINE(readability-function-size): as CONTACT's callers have it
int cntc_initializefirst_new(int* ifcver, int* ierror, int* ioutput, const char* c_wrkdir, const char* c_outdir,
                             const char* c_expnam, int* len_wrkdir, int* len_outdir, int* len_expnam) {
  return cntc_initializefirst(ifcver, ierror, ioutput, c_wrkdir, c_outdir, c_expnam, len_wrkdir, len_outdir,
                              len_expnam);
}

int cntc_initialize(int* ire, int* imodul, int* ifcver, int* ierror, const char* c_outdir, int* len_outdir) {
  const int code = guarded(__func__, [&] {
    if (ifcver) *ifcver = version;
    const int element = integer("ire", ire), module = integer("imodul", imodul);
    Registry::instance().start("", optional_text("c_outdir", c_outdir, len_outdir), "");
    Registry::instance().add(element, module);
  });
  return told(code, ierror);
}

int cntc_setfileunits(int* nunits, int* iunits) {
  return guarded(__func__, [&] { integers("iunits", nunits, iunits); });
}

int cntc_setglobalflags(int* lenflg, int* params, int* values) {
  return guarded(__func__, [&] {
    const auto codes = integers("params", lenflg, params);
    integers("values", lenflg, values);
    for (const int code : codes)
      if (code != 0 && code != CNTC_if_idebug && code != CNTC_if_licdbg && code != CNTC_if_wrtinp &&
          code != CNTC_if_openmp && code != CNTC_if_timers)
        throw Refusal(CNTC_err_other, "there is no flag " + std::to_string(code));
  });
}

int cntc_getmaxnumthreads(int* mxthrd) {
  return guarded(__func__, [&] {
    constexpr unsigned most = 999;
    given("mxthrd", mxthrd) = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, most));
  });
}

int cntc_readinpfile(int* ire, int* inp_type, const char* c_fname, int* len_fname, int* ierror) {
  const int code = guarded(wheel_call(__func__, ire), [&](ContactProblem& p) {
    const int kind = integer("inp_type", inp_type);
    if (kind != CNTC_inp_modul1 && kind != CNTC_inp_spck)
      throw Refusal(CNTC_err_input, "inp_type = " + std::to_string(kind) + ": must be " +
                                        std::to_string(CNTC_inp_modul1) + " or " + std::to_string(CNTC_inp_spck));
    const auto path = Registry::instance().working_folder() / text("c_fname", c_fname, len_fname);
    if (kind == CNTC_inp_modul1)
      read_wheel(p, path);
    else
      read_file(p, path, kind);
  });
  return told(code, ierror);
}

int cntc_finalize(int* ire) {
  return guarded(__func__, [&] { Registry::instance().remove(integer("ire", ire)); });
}

int cntc_finalizelast(void) {
  return guarded(__func__, [&] { Registry::instance().remove_all(); });
}

} // extern "C"
} // namespace microslip::libcontact
