#pragma once

#include "validation/study.hpp"

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace microslip::app {

/// A study that has been run.
struct StudyRecord {
  const validation::Study* study = nullptr;
  bool as_stated = false;
  double seconds = 0;
  std::vector<validation::Figure> figures = {};
  std::string text = {};                  ///< as it is printed
  std::vector<std::string> pictures = {}; ///< names of PNG files
};

/// What comes of a study in words: "all figures are met", "all figures are as stated, 1 of 12 is a known limit", "NOT
/// all figures are as stated".
std::string outcome(bool as_stated, const std::vector<validation::Figure>& figures);

/// The name of the page in its folder.
inline constexpr const char* validation_page = "validation.html";

/// A file and what it holds.
struct DigestedFile {
  std::filesystem::path file;
  std::string sha256;
};
/// Throws Error for one that cannot be read.
std::vector<DigestedFile> digested(const std::vector<std::filesystem::path>& files);

/// What the report says besides its figures.
struct ReportHead {
  std::string purpose = {};                ///< added to the one that every report has
  std::time_t begin = 0;                   ///< when the first study began
  std::vector<DigestedFile> inputs = {};   ///< files that studies read
  std::vector<DigestedFile> programs = {}; ///< the one that computes and those built with it
};

/// Writes validation.html into a folder: one page without other files, with purpose, versions, machine, digests of
/// programs and inputs, a verdict on each clause, places for signatures, and all figures beside the published ones,
/// with the pictures; and validation.pdf where a browser of the Chromium family makes it. Returns the names of both.
/// Throws Error if they cannot be written.
std::vector<std::string> write_validation_report(const std::filesystem::path& folder, const ReportHead& head,
                                                 const std::vector<StudyRecord>& records);

} // namespace microslip::app
