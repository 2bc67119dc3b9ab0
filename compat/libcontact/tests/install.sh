#!/bin/sh
# Installs the component libcontact alone, builds the example in C against it and runs it:
# install.sh CMAKE BUILD PREFIX LIBDIR EXAMPLES COMPILER
set -eu
rm -rf "$3"
"$1" --install "$2" --prefix "$3" --component libcontact >/dev/null
[ -f "$3/share/microslip/fortran/contact_addon.f90" ] && [ ! -e "$3/include/microslip" ]
$6 -std=c99 -I "$3/include" "$5/libcontact/manchester.c" -L "$3/$4" -lcontact -Wl,-rpath,"$3/$4" -o "$3/manchester"
cd "$3" && ./manchester "$5/profiles/60e1.prr" "$5/profiles/s1002.prw" | grep -c '^wheel' | grep -qx 42
