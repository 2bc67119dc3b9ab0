#!/bin/sh
# Under Wine: program, C library and units for Windows do what those for Linux do: windows.sh BUILD LINUX_BUILD
# Exit code 77: skipped, because Wine or either build is missing.
set -eux
root=$(cd "$(dirname "$0")/../.." && pwd)
for needed in wine x86_64-w64-mingw32-gcc-posix x86_64-w64-mingw32-objdump python3; do
  command -v $needed >/dev/null || { echo "skipped: $needed is not installed"; exit 77; }
done
for program in "$1/bin/microslip.exe" "$2/bin/microslip"; do
  [ -f "$program" ] || { echo "skipped: $program is not built"; exit 77; }
done
build=$(cd "$1" && pwd)
linux=$(cd "$2" && pwd)
export WINEPREFIX="$build/wine" WINEDEBUG=-all
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/größe 1" # Windows users have such folders
cd "$work/größe 1"
cp -r "$root"/examples/*.toml "$root/examples/contacts.csv" "$root/examples/profiles" .
# what it prints has the ends of lines that Windows has
windows() { wine "$build/bin/microslip.exe" "$@" 2>messages; }
same_numbers() { python3 "$root/tools/trials/same_numbers.py" "$@"; }

windows --version
windows init first.toml
for case in first hertzian_contact two_rollers wheel_on_rail starting_to_roll; do
  windows solve $case.toml --no-pictures --json -o "$case out" >$case.json
  test -f "$case out/result.h5"
  "$linux/bin/microslip" solve $case.toml --no-pictures --json -o linux >linux.json
  same_numbers $case.json linux.json
done
windows validate carter --no-pictures | grep -q "all figures are met"
# whose moments of balance are as near to zero as its tolerance
windows solve wheelset_in_curve.toml --no-pictures -o wheelset >solved.txt
test -f wheelset/result.h5
for theory in fastsim2 exact table; do
  windows batch contacts.csv --theory $theory -o there.csv
  "$linux/bin/microslip" batch contacts.csv --theory $theory -o here.csv
  same_numbers there.csv here.csv
  [ "$theory" = exact ] || cmp there.csv here.csv
done
windows profile profiles/60e1.prr --role rail --no-pictures -o profile >profile.txt || { cat messages; exit 1; }
if [ -f "$build/share/microslip/explorer/index.html" ]; then
  windows explore -o page.html --no-browser hertzian_contact.toml >address.txt
  grep -q "file:///.*page.html" address.txt
  test -s page.html
fi

# faults have their words and exit codes
code=0
windows solve none.toml || code=$?
[ $code -eq 2 ]
grep -q "none.toml: cannot be read" messages
code=0
windows solve größe.toml || code=$?
[ $code -eq 2 ]
grep -q "letters of ASCII only" messages

# a program in C
x86_64-w64-mingw32-gcc-posix "$root/examples/c/first_contact.c" -I"$root/c/include" -L"$build/c" -lmicroslip_c \
  -o first_contact.exe
cp "$build/bin/libmicroslip_c.dll" .
wine ./first_contact.exe | tr -d '\r' >there.txt
cc "$root/examples/c/first_contact.c" -I"$root/c/include" -L"$linux/c" -lmicroslip_c -lm -o first_contact
LD_LIBRARY_PATH="$linux/c" ./first_contact >here.txt
grep -q "[0-9]" here.txt
cmp there.txt here.txt

# the units by FMI 2.0 and 3.0, step by step beside those of Linux
cc -I"$root" "$root/fmi/tests/step_unit.c" -o step -ldl
x86_64-w64-mingw32-gcc-posix -I"$root" "$root/fmi/tests/step_unit.c" -o step.exe
# STANDARD FOLDER PLATFORM_HERE PLATFORM_THERE URI_HERE URI_THERE, of the unit and value references at hand
compare() {
  cmp "$linux/fmi/$2/modelDescription.xml" "$build/fmi/$2/modelDescription.xml"
  token=$(sed -nE 's/.*(guid|instantiationToken)="([^"]*)".*/\2/p' "$linux/fmi/$2/modelDescription.xml")
  # shellcheck disable=SC2086
  ./step "$1" "$linux/fmi/$2/binaries/$3/$unit.so" "$token" "$5$linux/fmi/$2/resources/" $references >here.txt
  # shellcheck disable=SC2086
  wine ./step.exe "$1" "Z:$build/fmi/$2/binaries/$4/$unit.dll" "$token" "$6Z:$build/fmi/$2/resources/" $references |
    tr -d '\r' >there.txt
  test -s here.txt
  cmp here.txt there.txt
}
step() {
  unit=$1 file=$linux/fmi/$1/modelDescription.xml
  shift
  references=
  for name in "$@"; do
    reference=$(sed -n "s/.*name=\"${name%%=*}\" valueReference=\"\([0-9]*\)\".*/\1/p" "$file")
    [ -n "$reference" ]
    case $name in *=*) reference=$reference=${name#*=} ;; esac
    references="$references $reference"
  done
  compare 2 "$unit" linux64 win64 file:// file:///
  compare 3 "${unit}_fmi3" x86_64-linux x86_64-windows "" ""
}
step microslip_tangential creepage_longitudinal=0.001 spin=0.1 fx fy mz
step microslip_wheel_rail state.lateral=0.003 state.vertical=-0.0001 state.forward_velocity=20 state.pitch_velocity=43.5 \
  wheel.force_x wheel.force_y wheel.force_z

# libraries that every Windows has, and no others
for file in "$build"/bin/microslip.exe "$build"/bin/*.dll "$build"/fmi/*/binaries/*/*.dll; do
  x86_64-w64-mingw32-objdump -p "$file" | sed -n 's/.*DLL Name: //p' >libraries.txt
  test -s libraries.txt
  if grep -viE '^(kernel32|msvcrt|advapi32|shell32|user32|ws2_32|bcrypt)\.dll$' libraries.txt; then exit 1; fi
done
echo "windows: all is as it should be"
