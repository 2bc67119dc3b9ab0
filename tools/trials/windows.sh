#!/bin/sh
# Under Wine: the program for Windows solves the example as the one for Linux does, and the units load: windows.sh BUILD
set -eux
build=$(cd "$1" && pwd)
root=$(cd "$(dirname "$0")/../.." && pwd)
command -v wine >/dev/null || { echo "skipped: wine is not installed"; exit 77; }
work=$(mktemp -d)
cd "$work"
wine "$build/bin/microslip.exe" --version
wine "$build/bin/microslip.exe" solve "$root/examples/hertzian_contact.toml" --no-pictures -o results | tr -d '\r' >solved.txt
grep -q "longitudinal force fx  *-14\.0606" solved.txt
test -f results/result.h5
# libraries that every Windows has, and no others
for file in "$build"/bin/microslip.exe "$build"/c/*.dll "$build"/fmi/*/binaries/win64/*.dll; do
  x86_64-w64-mingw32-objdump -p "$file" | sed -n 's/.*DLL Name: //p' | grep -viE '^(kernel32|msvcrt|advapi32|shell32|user32|ws2_32|bcrypt)\.dll$' && exit 1
done
echo "windows: all is as it should be"
