// Loads the unpacked unit by FMI 3.0 as importer.hpp does that by 2.0: names and value references are the same in both.
// MICROSLIP_UNPACKED_FMU3 is its folder.
#pragma once

#include "fmi/fmi3.h"
#include "fmi/tests/importer.hpp"

#include <vector>

namespace microslip::fmi {
namespace {

const std::string folder3 = MICROSLIP_UNPACKED_FMU3;

std::string token3() {
  std::ifstream file(folder3 + "/modelDescription.xml");
  std::stringstream contents;
  contents << file.rdbuf();
  return attribute(contents.str(), "instantiationToken");
}

void* library3() {
  static void* const handle =
      dlopen((folder3 + "/binaries/x86_64-linux/" + description().identifier + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
  return handle;
}

#define FMI3(name) (*reinterpret_cast<decltype(name)*>(dlsym(library3(), #name)))

struct Messages3 {
  int count = 0;
  fmi3Status status = fmi3OK;
  std::string category, last;
};

void log_message3(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message) {
  auto& messages = *static_cast<Messages3*>(environment);
  ++messages.count;
  messages = {messages.count, status, category, message};
}

class Instance3 {
public:
  explicit Instance3(const std::string& token = token3(), bool event_mode = false, std::size_t intermediate = 0)
      : unit(FMI3(fmi3InstantiateCoSimulation)("law", token.c_str(), (folder3 + "/resources/").c_str(), false, true,
                                               event_mode, false, &first_, intermediate, &messages, log_message3,
                                               nullptr)) {}
  ~Instance3() { FMI3(fmi3FreeInstance)(unit); }
  Instance3(const Instance3&) = delete;

  Messages3 messages;

private:
  fmi3ValueReference first_ = 0;

public:
  fmi3Instance unit;

  void initialize() {
    EXPECT_EQ(FMI3(fmi3EnterInitializationMode)(unit, false, 0, 2, false, 0), fmi3OK);
    EXPECT_EQ(FMI3(fmi3ExitInitializationMode)(unit), fmi3OK);
  }
  fmi3Status set(fmi3ValueReference vr, double value) { return FMI3(fmi3SetFloat64)(unit, &vr, 1, &value, 1); }
  double get(fmi3ValueReference vr) {
    double value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(FMI3(fmi3GetFloat64)(unit, &vr, 1, &value, 1), fmi3OK) << messages.last;
    return value;
  }
  fmi3Status step(double time, double length = 1e-3) {
    bool event = true, terminate = true, early = true;
    double last = 0;
    const fmi3Status status = FMI3(fmi3DoStep)(unit, time, length, true, &event, &terminate, &early, &last);
    EXPECT_TRUE(status != fmi3OK || (!event && !terminate && !early && last == time + length));
    return status;
  }
};

/// References of the real variables of a causality.
std::vector<unsigned> references(const std::string& causality) {
  std::vector<unsigned> all;
  for (const auto& [name, one] : description().causalities)
    if (one == causality && description().types.at(name) == "Real") all.push_back(description().references.at(name));
  return all;
}

} // namespace
} // namespace microslip::fmi
