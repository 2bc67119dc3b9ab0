#!/bin/sh
# The example as a function of Octave, built by the command in its first lines:
# octave.sh MKOCTFILE OCTAVE INCLUDE LIBRARY EXAMPLES FOLDER
set -eu
mkdir -p "$6/prefix" && cd "$6"
ln -sfn "$3" prefix/include
ln -sfn "$(dirname "$4")" prefix/lib
cp "$5/libcontact/wheel_forces.c" .
arguments=$(sed -n 's|^ \*   mkoctfile \(.*[^ ]\)  *Octave$|\1|p' wheel_forces.c)
[ -n "$arguments" ]
"$1" $(echo "$arguments" | sed "s|PREFIX|$PWD/prefix|g") # several words
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
