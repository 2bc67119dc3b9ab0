#!/bin/sh
# The example as a function of Octave: octave.sh MKOCTFILE OCTAVE INCLUDE LIBRARY EXAMPLES FOLDER
set -eu
mkdir -p "$6" && cd "$6"
library=$(dirname "$4")
"$1" --mex -o wheel_forces.mex "$5/libcontact/wheel_forces.c" -I"$3" -L"$library" -lcontact -Wl,-rpath,"$library"
"$2" --no-gui --quiet --no-init-file --eval "
  forces = @(y) wheel_forces('$5/profiles/60e1.prr', '$5/profiles/s1002.prw', y);
  f = forces(0); g = forces(3);
  assert (numel (f) == 24 && all (isfinite (f)));
  assert (abs (f(3) - 10e3) < 1 && abs (g(3) - 10e3) < 1);
  assert (f, forces(0));
  assert (any (f(1:2) != g(1:2)));
  failed = false;
  try, wheel_forces('none.prr', 'none.prw', 0); catch, failed = true; end
  assert (failed);"
