#!/bin/sh
# With the program and what draws its pictures: three first tasks from an empty folder, each with the seconds it takes.
set -eu
cd "$(mktemp -d)"

# The steps of a task; its pictures must be there.
task() {
  name=$1
  shift
  begin=$(date +%s%N)
  "$@" >steps.txt
  end=$(date +%s%N)
  printf '%-62s %4.1f s\n' "$name" "$(awk "BEGIN { print ($end - $begin) / 1e9 }")"
}

wheel() {
  microslip init wheel.toml
  microslip solve wheel.toml -o wheel
  test -s wheel/creep_curve.png
}

profile() {
  microslip init --example wheel_on_rail rail.toml
  sed -i 's/^lateral = "6.04 mm"/lateral = "6 mm"/' rail.toml
  grep -q '^lateral = "6 mm"' rail.toml
  microslip solve rail.toml -o rail
  microslip plot rail/result.h5 --field traction
  test -s rail/patches.png
  test -s rail/field_traction.png
}

# Two discs of 47 mm, one with a crown of 300 mm, pressed by 1.5 kN.
rollers() {
  microslip init twin.toml
  sed -i 's/^rolling_radius = \("460 mm"\|inf\)/rolling_radius = "23.5 mm"/; s/^normal_force = "80 kN"/normal_force = "1.5 kN"/' twin.toml
  [ "$(grep -c '^rolling_radius = "23.5 mm"' twin.toml)" -eq 2 ]
  microslip solve twin.toml -o twin
  microslip plot twin/result.h5 --stresses 0
  test -s twin/stresses.png
}

task "the creep curve of a wheel" wheel
task "tractions of measured profiles, 6 mm to the left" profile
task "stresses under a crowned roller in a twin-disc machine" rollers
