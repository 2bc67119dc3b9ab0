#!/bin/sh
# As root on a clean Debian 12, in a folder with the packages and the examples: installs the packages, tries all that is
# in them, and removes them. Ends with an error at the first thing that is not right.
set -eux
here=$(cd "$(dirname "$0")" && pwd)
export DEBIAN_FRONTEND=noninteractive
install="apt-get install -y -qq --no-install-recommends"
apt-get update -qq
work=$(mktemp -d)
cd "$work"

# what the package depends on is enough for the program, the module and the table
$install "$here"/microslip_*.deb >/dev/null
microslip --version
microslip init wheel.toml
microslip solve wheel.toml --no-pictures -o results >solved.txt
grep -q "status  *ok  *ok" solved.txt
microslip batch "$here/contacts.csv" -o forces.csv --theory table
microslip validate carter --no-pictures
python3 "$here/first_contact.py"
python3 -m microslip --version
python3 -c "import microslip; print(microslip.__version__, microslip.CreepForceTable(poisson_ratio=0.28))"
test -f /usr/share/bash-completion/completions/microslip
test -f /usr/share/doc/microslip/copyright

# what it recommends draws the pictures
$install python3-h5py python3-matplotlib >/dev/null
microslip plot results/result.h5 | grep -q tractions.png
sh "$here/first_pictures.sh"

# programs in C and with CMake against libraries and headers
$install gcc g++ libc6-dev pkg-config cmake make man-db >/dev/null
man microslip | grep -q FASTSIM2
# shellcheck disable=SC2046
cc "$here/first_contact.c" -o first_contact $(pkg-config --cflags --libs microslip_c) -lm
./first_contact
cp -r "$here/consumer" .
cmake -S consumer -B consumer/build >/dev/null && cmake --build consumer/build --target consumer && ./consumer/build/consumer

# libcontact beside it
$install "$here"/microslip-libcontact_*.deb >/dev/null
cc "$here/manchester.c" -o manchester -lcontact -lm
./manchester "$here/profiles/60e1.prr" "$here/profiles/s1002.prw" >/dev/null

# and nothing is left
apt-get purge -y -qq microslip microslip-libcontact >/dev/null
for left in /usr/bin/microslip /usr/bin/microslip-validate /usr/share/microslip /usr/lib/python3/dist-packages/microslip; do
  [ ! -e $left ] || exit 1 # `set -e` stops at the last of a list of conditions only
done
echo "packages: all is as it should be"
