#pragma once

#include "compat/libcontact/tests/calls.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace microslip::libcontact {

/// The library at work, with its log in a folder.
class LibraryTest : public ::testing::Test {
protected:
  void SetUp() override { ASSERT_EQ(library_.code, 0); }

  TemporaryFolder folder_;
  Library library_{folder_.path()};
};

} // namespace microslip::libcontact
