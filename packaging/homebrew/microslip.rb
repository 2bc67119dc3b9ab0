# Homebrew on Linux: brew install --build-from-source ./microslip.rb
class Microslip < Formula
  desc "Frictional rolling contact of wheel and rail or of rollers"
  url "@URL@"
  version "@VERSION@"
  sha256 "@SHA256@"
  license "Apache-2.0"

  depends_on "boost" => :build
  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "tomlplusplus" => :build
  depends_on "fmt"
  depends_on "hdf5"
  depends_on "libcsv"
  depends_on :linux

  def install
    args = %w[
      -DMICROSLIP_BUILD_PYTHON=OFF
      -DMICROSLIP_BUILD_LIBCONTACT=OFF
      -DMICROSLIP_BUILD_TESTS=OFF
      -DMICROSLIP_BUILD_BENCH=OFF
      -DMICROSLIP_MPI=OFF
    ]
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", *args, *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    system bin/"microslip", "init", "wheel.toml"
    assert_match "ok", shell_output("#{bin}/microslip solve wheel.toml --no-pictures -o results")
  end
end
