#include "io/profile_file.hpp"

#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

namespace microslip {
namespace {

using Point = std::function<std::string(int k, double y, double z)>;

std::string plain(int, double y, double z) {
  return fmt::format("{:.4f} {:.4f}\n", y, z);
}

/// 141 points of a rail's head in mm, each as the function writes it.
std::string head(const Point& point = plain) {
  std::string text;
  for (int k = 0; k <= 140; ++k) {
    const double y = 0.5 * (k - 70);
    text += point(k, y, -y * y / 600);
  }
  return text;
}

Point with(const std::string& separator) {
  return [=](int, double y, double z) { return fmt::format("{:.4f}{}{:.4f}\n", y, separator, z); };
}

std::string decimal_commas(double y, const std::string& separator, double z) {
  std::string first = fmt::format("{:.3f}", y), second = fmt::format("{:.3f}", z);
  std::replace(first.begin(), first.end(), '.', ',');
  std::replace(second.begin(), second.end(), '.', ',');
  return first + separator + second + "\n";
}

/// The head with another line in the middle.
std::string with_line(const std::string& line) {
  return head([&](int k, double y, double z) { return k == 70 ? line + "\n" : plain(k, y, z); });
}

std::string scaled(double factor) {
  return head([=](int, double y, double z) { return fmt::format("{:.9f} {:.9f}\n", factor * y, factor * z); });
}

struct Malformed {
  std::string name, text, words; ///< of the message, after the name
};

std::vector<Malformed> malformed() {
  const std::string points = head();
  return {
      {"rail.txt", "", "is empty"},
      {"rail.txt", "no numbers here\nnor here\n", "there are no lines with two numbers, y and z"},
      {"rail.txt", "<html><body>404 Not Found</body></html>\n", "there are no lines with two numbers, y and z"},
      {"rail.txt", std::string("PK\x03\x04\0\0\0\0", 8), "is not a text file: it has NUL bytes"},
      {"rail.txt", head([](int, double y, double) { return fmt::format("{:.3f}\n", y); }),
       "1: one number, \"-35.000\", not y and z"},
      {"rail.txt", with_line("0.0"), "71: one number, \"0.0\", not y and z"},
      {"rail.txt", with_line("0.0 nan"), "71: z: \"nan\" is not a finite number"},
      {"rail.txt", with_line("0.0 -inf"), "71: z: \"-inf\" is not a finite number"},
      {"rail.txt", with_line("0.0 1e999"), "71: z: \"1e999\" is not a finite number"},
      {"rail.txt", with_line("O.0 0.0"), "71: y: \"O.0\" is not a finite number"},
      {"rail.txt", with_line("0.0 1e300"), "must be in 5 mm to 500 mm"},
      {"rail.txt", "500\n" + points, "the first line announces 500 points, but there are 141; is it truncated?"},
      {"rail.txt", points + "x y z\n" + points, "142: y: \"x\" is not a finite number"},
      {"rail.txt", "0 0\n", "the profile has no width: 1 point with the same y"},
      {"rail.txt", head([](int, double, double) { return std::string("10 10\n"); }), "141 points with the same y"},
      {"rail.txt", scaled(1e-6), "neither in mm nor in m; give the unit"},
      {"rail.txt", scaled(1e3), "neither in mm nor in m; give the unit"},
      {"rail.txt", scaled(1 / 25.4), "neither in mm nor in m; give the unit, in for inches"},
      {"rail.txt", head([](int k, double, double) {
         return fmt::format("{:.4f} {:.4f}\n", 30 * std::sin(0.126 * k), 10 * std::sin(0.063 * k));
       }),
       "the profile crosses itself between"},
      {"head.txt", points, "neither the file nor its name says whether this is a rail or a wheel; give the role"},
      {"a.prr", "header.begin\n type = 0\nheader.end\nspline.begin\npoint.begin\n0 0\n1 0\n",
       "the file ends before point.end; is it truncated?"},
      {"a.prr", "header.begin\n type = 7\nheader.end\nspline.begin\npoint.begin\n" + points + "point.end\nspline.end\n",
       "type = 7 in the header: must be 0 or 1"},
      {"a.ban", "Title=a\nColumnDef=X,Q\n\n" + points, "ColumnDef = \"X,Q\" has no X or no Y"},
      // exports of lasers
      {"rail.csv", "y;y\n" + head(with(";")), "1: two columns are headed \"y\""},
      {"rail.csv", "y [mm];z [inch]\n" + head(with(";")), "1: the headings give y and z different units"},
      {"rail.csv", "x;y;quality;z\n" + head(with(";")), "2: 2 numbers, but y or z is in column 4"},
      {"rail.csv", "y;z\n" + head([](int k, double y, double z) {
                     return k == 70 ? std::string("0,0;;\n") : decimal_commas(y, ";", z);
                   }),
       "72: z: \"\" is not a finite number"},
      {"rail.csv", "y;z\n" + head([](int k, double y, double z) {
                     return k == 70 ? std::string("0,0;---\n") : decimal_commas(y, ";", z);
                   }),
       "72: z: \"---\" is not a finite number"},
      {"rail.csv", "y,z\n" + head([](int, double y, double z) { return decimal_commas(y, ",", z); }),
       "commas are both decimal points and separators; separate the columns by semicolons"},
      {"rail.csv", "y;z\n" + head(with(";")) + "End of scan\n", "143: y: \"End\" is not a finite number"},
      {"rail.csv", "Scanner;L2\nNo;Height;Lateral\n", "there are no lines with two numbers, y and z"},
      {"a.mpt", "[FileInfo]\na=1\n[Profile1Info]\nx=1\n", "there are no points"},
  };
}

TEST(MalformedProfiles, AreAnsweredInWords) {
  for (const Malformed& file : malformed()) {
    const std::string message = error_of([&] { io::parse_profile(file.text, file.name); });
    EXPECT_TRUE(message.starts_with(file.name + ":")) << message;
    EXPECT_NE(message.find(file.words), std::string::npos) << file.words << "\nis not in\n" << message;
  }
}

TEST(MalformedProfiles, ColumnsMustNameYAndZOnceEach) {
  for (const std::string columns : {"y", "y,y", "z,z,y", "a,b", ",", "y;z;y"}) {
    const std::string message = error_of([&] { io::parse_profile(head(), "rail.txt", {.columns = columns}); });
    EXPECT_EQ(message, "rail.txt: columns = \"" + columns +
                           "\": must name y and z once each, with - for a column that is not used, as \"-,y,z\"");
  }
  EXPECT_EQ(error_of([&] { io::parse_profile("header.begin\n", "a.prr", {.columns = "y,z"}); }),
            "a.prr: columns is for files of columns, not of Simpack");
}

} // namespace
} // namespace microslip
